/* Writes a picture with its texts as PNG, SVG and PDF. */
#include "postproc/draw/figure.h"
#include "base/memory.h"
#include "base/files/folder.h"
#include "postproc/draw/font.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

static const unsigned ink = 0x23282e;
static const double capital = 0.729; /* height of DejaVu Sans's capitals over its size */

struct postproc_figure *postproc_figure_new(struct postproc_canvas *canvas) {
    struct postproc_figure *f = memory_new(MEMORY_OUTPUT, 1, sizeof *f);
    f->canvas = canvas;
    return f;
}

void postproc_figure_text(struct postproc_figure *f, double x, double y, double height, unsigned colour,
                          enum postproc_align align, const char *text) {
    if (f->texts == POSTPROC_FIGURE_TEXTS || !text[0]) return;
    const int k = f->texts++;
    f->text[k].x = x;
    f->text[k].y = y;
    f->text[k].height = height;
    f->text[k].colour = colour;
    f->text[k].align = align;
    snprintf(f->text[k].text, sizeof f->text[k].text, "%s", text);
}

/* "10" and the number raised. */
static void raised(int power, char text[32]) {
    static const char *const digit[10] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    char plain[16];
    size_t at = (size_t)snprintf(text, 32, "×10");
    snprintf(plain, sizeof plain, "%d", power);
    for (const char *c = plain; *c; c++)
        at += (size_t)snprintf(text + at, 32 - at, "%s", *c == '-' ? "⁻" : digit[*c - '0']);
}

void postproc_figure_bar(struct postproc_figure *f, const struct postproc_bar *bar) {
    postproc_bar_draw(f->canvas, bar);
    const struct postproc_bar_ticks ticks = postproc_bar_scale(bar);
    const int power = postproc_gnuplot_power(fmax(fabs(bar->low), fabs(bar->high)));
    const double x = bar->x + bar->width + 12, unit = pow(10, power);
    for (int i = 0; i < ticks.n; i++) {
        char number[32];
        snprintf(number, sizeof number, "%.6g", ticks.value[i] / unit);
        postproc_figure_text(f, x, ticks.y[i] + 0.5 * bar->text, bar->text, ink, POSTPROC_LEFT, number);
    }
    char factor[32] = "";
    if (power != 0) raised(power, factor);
    postproc_figure_text(f, bar->x, bar->y0 - 1.4 * bar->text, bar->text, ink, POSTPROC_LEFT, factor);
    postproc_figure_text(f, bar->x, bar->y0 - (power ? 3.4 : 1.4) * bar->text, bar->text, ink, POSTPROC_LEFT,
                         bar->label);
}

/* The stroke font has no raised letters: a power of ten gets a caret. */
static void plain_of(const char *text, char plain[300]) {
    const char *ten = strstr(text, "×10");
    snprintf(plain, 300, "%.*s%s%s", ten ? (int)(ten - text) : 0, text, ten ? "×10^" : "",
             ten ? ten + strlen("×10") : text);
}

static int write_plain(const struct postproc_figure *f, const char *path) {
    for (int k = 0; k < f->texts; k++) {
        char plain[300];
        plain_of(f->text[k].text, plain);
        const double wide = postproc_font_width(f->text[k].height, plain);
        const double left = f->text[k].align == POSTPROC_LEFT     ? 0
                            : f->text[k].align == POSTPROC_CENTRE ? 0.5 * wide
                                                                  : wide;
        postproc_font_draw(f->canvas, f->text[k].x - left, f->text[k].y, f->text[k].height, f->text[k].colour, plain);
    }
    return postproc_canvas_write(f->canvas, path);
}

static void put_texts(FILE *s, const struct postproc_figure *f) {
    static const char *const align[] = {"left", "center", "right"};
    for (int k = 0; k < f->texts; k++) { /* gnuplot centres a text on its point in height; 0.75 points a pixel */
        fprintf(s, "set label %d ", k + 1);
        postproc_gnuplot_text(s, f->text[k].text);
        fprintf(s, " at first %.6g, first %.6g %s noenhanced front font ',%.4g' tc rgb '#%06x'\n", f->text[k].x,
                f->canvas->height - f->text[k].y + 0.5 * f->text[k].height, align[f->text[k].align],
                0.75 * f->text[k].height / capital, f->text[k].colour);
    }
}

/* The script that puts the texts on the raster NAME.rgb. */
static int script_write(const struct postproc_figure *f, const char *path, const char *name, int all) {
    FILE *s = fopen(path, "w");
    if (!s) return -1;
    const int w = f->canvas->width, h = f->canvas->height;
    fprintf(s,
            "set encoding utf8\nset lmargin at screen 0\nset rmargin at screen 1\nset bmargin at screen 0\n"
            "set tmargin at screen 1\nunset border\nunset tics\nunset key\nset xrange [0.5:%g]\nset yrange [0.5:%g]\n",
            w - 0.5, h - 0.5);
    put_texts(s, f);
    for (int k = 0; k < (all ? POSTPROC_FORMATS : 1); k++) {
        postproc_gnuplot_terminal(s, (enum postproc_format)k, name, w, h);
        if (k == 0)
            fprintf(s, "plot '%s.rgb' binary array=(%d,%d) format='%%uchar' origin=(0.5,0.5) flipy with rgbimage\n",
                    name, w, h);
        else
            fputs("refresh\n", s); /* without reading the raster again */
    }
    fputs("set output\n", s);
    const int bad = ferror(s);
    return fclose(s) || bad ? -1 : 0;
}

int postproc_figure_write(struct postproc_figure *f, const char *folder, const char *name, int all) {
    char png[FOLDER_PATH], raster[FOLDER_PATH], script[FOLDER_PATH], file[256];
    snprintf(file, sizeof file, "%s.png", name);
    folder_path(png, folder, file);
    snprintf(file, sizeof file, "%s.rgb", name);
    folder_path(raster, folder, file);
    snprintf(file, sizeof file, "%s.gp", name);
    folder_path(script, folder, file);
    int status = postproc_canvas_write_raw(f->canvas, raster) || script_write(f, script, name, all) ? -1 : 0;
    if (!status && postproc_gnuplot_run(folder, file) != POSTPROC_PLOT_DONE) status = write_plain(f, png);
    const int fault = errno;
    unlink(raster);
    unlink(script);
    postproc_canvas_free(f->canvas);
    memory_free(f);
    errno = fault;
    return status;
}
