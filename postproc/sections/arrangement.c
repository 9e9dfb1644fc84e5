/* Section of the report with a picture of points that are not on a lattice: their places, coloured by their volumes. */
#include "base/files/folder.h"
#include "postproc/sections/sections.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { WHOLE = 560, MANY = 1500, ACROSS = 24 }; /* more points than MANY: a part of ACROSS spacings beside the whole */

struct points {
    long n;
    double (*x)[3], *volume; /* [n] m, over their mean */
    double low[2], high[2], spacing;
};

/* The points of a field file; 0 if it has none, or no volumes. */
static int points_read(struct points *p, const char *path) {
    struct vtkhdf_source *s = vtkhdf_read_open(path, NULL);
    *p = (struct points){.low = {INFINITY, INFINITY}, .high = {-INFINITY, -INFINITY}};
    if (!s) return 0;
    p->n = s->points;
    p->x = vtkhdf_read_points(s);
    p->volume = vtkhdf_read_double(s, "volume");
    vtkhdf_read_close(s);
    double mean = 0;
    for (long i = 0; p->x && p->volume && i < p->n; i++) {
        mean += p->volume[i] / (double)p->n;
        for (int c = 0; c < 2; c++) {
            p->low[c] = fmin(p->low[c], p->x[i][c]);
            p->high[c] = fmax(p->high[c], p->x[i][c]);
        }
    }
    if (!(mean > 0)) return 0;
    for (long i = 0; i < p->n; i++) p->volume[i] /= mean;
    p->spacing = sqrt((p->high[0] - p->low[0]) * (p->high[1] - p->low[1]) / (double)p->n);
    return p->spacing > 0;
}

static void put_panel(FILE *f, const double low[2], const double high[2], double from, double to, double top,
                      double bottom, double size, const char *unit, double length) {
    fprintf(f,
            "set lmargin at screen %.6g\nset rmargin at screen %.6g\nset tmargin at screen %.6g\nset bmargin at screen "
            "%.6g\nset xrange [%.8g:%.8g]\nset yrange [%.8g:%.8g]\nset xlabel 'x  [%s]'\nset ylabel 'y  [%s]'\n",
            from, to, top, bottom, low[0] / length, high[0] / length, low[1] / length, high[1] / length, unit, unit);
    fprintf(f, "plot $points using 1:2:3 with points pt 7 ps %.3g palette\nunset label\nunset colorbox\n", size);
}

static void put_script(FILE *f, const struct points *p, const char *title, const char *subtitle, const char *unit,
                       double length) {
    const double size[2] = {p->high[0] - p->low[0] + p->spacing, p->high[1] - p->low[1] + p->spacing};
    const double scale = WHOLE / fmax(size[0], size[1]);
    const int part = p->n > MANY, pixels[2] = {(int)fmax(scale * size[0], 160), (int)fmax(scale * size[1], 160)};
    const int wide = 100 + pixels[0] + 150 + (part ? WHOLE + 110 : 0),
              high = 160 + (part && pixels[1] < WHOLE ? WHOLE : pixels[1]);
    double low[2][2], top[2][2], least = INFINITY, most = 0;
    for (int c = 0; c < 2; c++) {
        const double middle = 0.5 * (p->low[c] + p->high[c]), half = 0.5 * ACROSS * p->spacing;
        low[0][c] = p->low[c] - 0.5 * p->spacing;
        top[0][c] = p->high[c] + 0.5 * p->spacing;
        low[1][c] = middle - half;
        top[1][c] = middle + half;
    }
    fputs("$points << EOD\n", f);
    for (long i = 0; i < p->n; i++) {
        least = fmin(least, p->volume[i]);
        most = fmax(most, p->volume[i]);
        fprintf(f, "%.7g %.7g %.6g\n", p->x[i][0] / length, p->x[i][1] / length, p->volume[i]);
    }
    fputs("EOD\n", f);
    if (!(most - least > 1e-6)) least = 0.9, most = 1.1; /* equal volumes */
    for (int k = 0; k < POSTPROC_FORMATS; k++) {
        postproc_gnuplot_terminal(f, (enum postproc_format)k, "arrangement", wide, high);
        fputs("set encoding utf8\nunset key\nset border 15 front lw 1 lc rgb '#5a6068'\nset tics nomirror out scale "
              "0.6 textcolor rgb '#23282e'\nset cblabel 'volume over their mean'\nset multiplot\nset label 1 ",
              f);
        postproc_gnuplot_text(f, title);
        fprintf(f, " at screen %.6g, screen %.6g left noenhanced font ',15' tc rgb '#23282e'\nset label 2 ",
                20.0 / wide, 1 - 24.0 / high);
        postproc_gnuplot_text(f, subtitle);
        fprintf(f, " at screen %.6g, screen %.6g left noenhanced tc rgb '#5a6068'\n", 20.0 / wide, 1 - 50.0 / high);
        fprintf(f, "set palette defined (%.6g '#0072B2', 1 '#e4e7ea', %.6g '#D55E00')\nset cbrange [%.6g:%.6g]\n",
                least, most, least, most);
        fprintf(f, "set colorbox user origin screen %.6g, screen %.6g size screen %.6g, screen %.6g\n",
                (100.0 + pixels[0] + 14) / wide, 1 - (90.0 + pixels[1]) / high, 16.0 / wide, (double)pixels[1] / high);
        put_panel(f, low[0], top[0], 100.0 / wide, (100.0 + pixels[0]) / wide, 1 - 90.0 / high,
                  1 - (90.0 + pixels[1]) / high, fmin(fmax(0.12 * scale * p->spacing, 0.12), 2), unit, length);
        if (part)
            put_panel(f, low[1], top[1], (100.0 + pixels[0] + 240) / wide, (100.0 + pixels[0] + 240 + WHOLE) / wide,
                      1 - 90.0 / high, 1 - (90.0 + WHOLE) / high, 0.1 * WHOLE / ACROSS, unit, length);
        fputs("unset multiplot\n", f);
    }
}

/* Whether the scene's points are not on a lattice. */
static int is_arranged(const struct scene *s) {
    if (s->nonlocal) return s->nonlocal->dimension == 2;
    int any = 0;
    for (int b = 0; s->solid && s->dimension == 2 && b < s->solid->bodies; b++)
        any |= s->solid->body[b].arrangement.kind != MESHLESS_LATTICE;
    return any;
}

void postproc_sections_arrangement(struct postproc_output *out, const struct postproc_history *h) {
    char path[FOLDER_PATH], file[FOLDER_PATH], folder[FOLDER_PATH], subtitle[160];
    struct points p;
    if (!is_arranged(h->scene)) return;
    snprintf(file, sizeof file, "fields/%s", h->solid.n > 0 ? h->solid.entry[0].file : "solution.hdf");
    if (points_read(&p, folder_path(path, h->folder, file))) {
        const char *unit;
        const double length = postproc_plot_unit(fmax(p.high[0] - p.low[0], p.high[1] - p.low[1]), &unit);
        folder_path(folder, out->folder, "pictures");
        snprintf(subtitle, sizeof subtitle, "%ld points%s", p.n,
                 p.n > MANY ? "; right: the middle, 24 mean spacings across" : "");
        FILE *f = postproc_gnuplot_script_new(folder, "arrangement");
        if (f) put_script(f, &p, h->scene->title, subtitle, unit, length);
        const enum postproc_plot_status status =
            f ? postproc_gnuplot_script_end(f, folder, "arrangement") : POSTPROC_PLOT_NO_FILE;
        if (status == POSTPROC_PLOT_NO_FILE)
            postproc_sections_fail(out, folder);
        else if (status != POSTPROC_PLOT_DONE)
            out->charts.worst = status;
        else
            postproc_sections_picture(out, "arrangement", "The points, coloured by their volumes");
    }
    free(p.x);
    free(p.volume);
}
