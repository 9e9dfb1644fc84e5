/* Draws lines and texts on a picture by cairo, and writes it as PNG, SVG and PDF. */
#include "postproc/draw/figure.h"
#include "base/files/atomic_write.h"
#include "base/ensure.h"
#include "base/memory.h"
#include "base/files/folder.h"
#include "postproc/gnuplot.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>

static const char typeface[] = "DejaVu Sans"; /* also that of the plots */
static const double capital = 0.729;          /* height of its capitals over its size */
static const double point = 0.75;             /* points of a pixel, at 96 pixels an inch */

static cairo_surface_t *surface_of_canvas(const struct postproc_canvas *canvas) {
    const int w = canvas->width / 2, h = canvas->height / 2;
    cairo_surface_t *s = cairo_image_surface_create(CAIRO_FORMAT_RGB24, w, h);
    postproc_canvas_halve(canvas, (uint32_t *)(void *)cairo_image_surface_get_data(s),
                          (size_t)cairo_image_surface_get_stride(s) / sizeof(uint32_t));
    cairo_surface_mark_dirty(s);
    return s;
}

struct postproc_figure *postproc_figure_new(struct postproc_canvas *canvas) {
    struct postproc_figure *f = memory_new(MEMORY_OUTPUT, 1, sizeof *f);
    f->width = canvas->width / 2;
    f->height = canvas->height / 2;
    f->pixels = surface_of_canvas(canvas);
    cairo_surface_t *lines =
        cairo_recording_surface_create(CAIRO_CONTENT_COLOR_ALPHA, &(cairo_rectangle_t){0, 0, f->width, f->height});
    f->cairo = cairo_create(lines);
    cairo_surface_destroy(lines); /* the context holds it */
    postproc_canvas_free(canvas);
    return f;
}

static void set_colour(cairo_t *c, unsigned colour, double alpha) {
    cairo_set_source_rgba(c, (colour >> 16 & 255) / 255.0, (colour >> 8 & 255) / 255.0, (colour & 255) / 255.0, alpha);
}

void postproc_figure_stroke(struct postproc_figure *f, unsigned colour, double alpha, double width) {
    set_colour(f->cairo, colour, alpha);
    cairo_set_line_width(f->cairo, width);
    cairo_set_line_cap(f->cairo, CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(f->cairo, CAIRO_LINE_JOIN_ROUND);
    cairo_stroke(f->cairo);
}

void postproc_figure_line(struct postproc_figure *f, const double a[2], const double b[2], unsigned colour,
                          double width) {
    cairo_move_to(f->cairo, a[0], a[1]);
    cairo_line_to(f->cairo, b[0], b[1]);
    postproc_figure_stroke(f, colour, 1, width);
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

/* The same letters at the same places in all formats. */
static double set_typeface(cairo_t *c, double height, const char *text) {
    cairo_text_extents_t extents;
    cairo_font_options_t *options = cairo_font_options_create();
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    cairo_set_font_options(c, options);
    cairo_font_options_destroy(options);
    cairo_select_font_face(c, typeface, CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(c, height / capital);
    cairo_text_extents(c, text, &extents);
    return extents.x_advance;
}

double postproc_figure_text_width(struct postproc_figure *f, double height, const char *text) {
    return set_typeface(f->cairo, height, text);
}

static void draw_texts(cairo_t *c, const struct postproc_figure *f) {
    static const double before[] = {[POSTPROC_LEFT] = 0, [POSTPROC_CENTRE] = 0.5, [POSTPROC_RIGHT] = 1};
    for (int k = 0; k < f->texts; k++) {
        const double width = set_typeface(c, f->text[k].height, f->text[k].text);
        set_colour(c, f->text[k].colour, 1);
        cairo_move_to(c, f->text[k].x - before[f->text[k].align] * width, f->text[k].y);
        cairo_show_text(c, f->text[k].text);
    }
}

static void put_escaped(FILE *file, const char *text) {
    for (; *text; text++)
        if (*text == '<' || *text == '&')
            fprintf(file, "&#%d;", *text);
        else
            fputc(*text, file);
}

/* Takes back the end of an SVG and adds the texts as text: cairo itself would write outlines of letters. */
static void put_svg(FILE *file, char *svg, const struct postproc_figure *f) {
    static const char *const anchor[] = {
        [POSTPROC_LEFT] = "start", [POSTPROC_CENTRE] = "middle", [POSTPROC_RIGHT] = "end"};
    char *end = NULL;
    for (char *next = svg; (next = strstr(next, "</svg>")); next++) end = next;
    ENSURE(end, "cairo's SVG has no end");
    fwrite(svg, 1, (size_t)(end - svg), file);
    for (int k = 0; k < f->texts; k++) {
        fprintf(file,
                "<text x=\"%.6g\" y=\"%.6g\" font-family=\"%s, sans-serif\" font-size=\"%.4g\" fill=\"#%06x\" "
                "text-anchor=\"%s\" xml:space=\"preserve\">",
                f->text[k].x, f->text[k].y, typeface, f->text[k].height / capital, f->text[k].colour,
                anchor[f->text[k].align]);
        put_escaped(file, f->text[k].text);
        fputs("</text>\n", file);
    }
    fputs("</svg>\n", file);
}

static cairo_status_t put(void *file, const unsigned char *bytes, unsigned n) {
    return fwrite(bytes, 1, n, file) == n ? CAIRO_STATUS_SUCCESS : CAIRO_STATUS_WRITE_ERROR;
}

static cairo_surface_t *surface_new(enum postproc_format format, const struct postproc_figure *f, FILE *file) {
    const int w = f->width, h = f->height;
    switch (format) {
    case POSTPROC_PNG:
        return cairo_image_surface_create(CAIRO_FORMAT_RGB24, w, h);
    case POSTPROC_SVG: {
        cairo_surface_t *s = cairo_svg_surface_create_for_stream(put, file, w, h);
        cairo_svg_surface_set_document_unit(s, CAIRO_SVG_UNIT_PX);
        return s;
    }
    case POSTPROC_PDF: {
        cairo_surface_t *s = cairo_pdf_surface_create_for_stream(put, file, point * w, point * h);
        cairo_surface_set_device_scale(s, point, point);
        return s;
    }
    case POSTPROC_FORMATS:
        break;
    }
    ENSURE(0, "format %d", (int)format);
}

static void draw(const struct postproc_figure *f, enum postproc_format format, FILE *file) {
    cairo_surface_t *s = surface_new(format, f, file);
    cairo_t *c = cairo_create(s);
    cairo_surface_t *layer[] = {f->pixels, cairo_get_target(f->cairo)};
    for (int k = 0; k < 2; k++) {
        cairo_set_source_surface(c, layer[k], 0, 0);
        cairo_paint(c);
    }
    if (format != POSTPROC_SVG) draw_texts(c, f);
    cairo_destroy(c);
    if (format == POSTPROC_PNG) cairo_surface_write_to_png_stream(s, put, file);
    cairo_surface_finish(s);
    cairo_surface_destroy(s);
}

static int write_format(const struct postproc_figure *f, enum postproc_format format, const char *path) {
    FILE *file = atomic_write_open(path);
    if (!file) return -1;
    if (format == POSTPROC_SVG) {
        char *svg = NULL;
        size_t length = 0;
        FILE *memory = open_memstream(&svg, &length);
        draw(f, format, memory);
        fclose(memory);
        put_svg(file, svg, f);
        free(svg);
    } else
        draw(f, format, file);
    const int bad = ferror(file);
    return atomic_write_close(file, path, bad);
}

int postproc_figure_write(struct postproc_figure *f, const char *folder, const char *name, int all) {
    static const char *const end[] = {[POSTPROC_PNG] = "png", [POSTPROC_SVG] = "svg", [POSTPROC_PDF] = "pdf"};
    int status = 0;
    for (int k = 0; k < (all ? POSTPROC_FORMATS : 1) && !status; k++) {
        char path[FOLDER_PATH], file[256];
        snprintf(file, sizeof file, "%s.%s", name, end[k]);
        status = write_format(f, (enum postproc_format)k, folder_path(path, folder, file));
    }
    const int fault = errno;
    cairo_surface_destroy(f->pixels);
    cairo_destroy(f->cairo);
    memory_free(f);
    errno = fault;
    return status;
}

int postproc_figure_write_pixels(const char *path, int width, int height, const uint32_t *pixel) {
    FILE *file = atomic_write_open(path);
    if (!file) return -1;
    cairo_surface_t *s = cairo_image_surface_create_for_data((unsigned char *)(uintptr_t)pixel, CAIRO_FORMAT_RGB24,
                                                             width, height, 4 * width);
    const cairo_status_t status = cairo_surface_write_to_png_stream(s, put, file);
    cairo_surface_destroy(s);
    return atomic_write_close(file, path, status != CAIRO_STATUS_SUCCESS);
}
