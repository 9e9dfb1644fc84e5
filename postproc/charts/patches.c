/* Writes the gnuplot script of a map of quadrilaterals and runs it. */
#include "postproc/charts/patches.h"
#include "base/memory.h"
#include "postproc/charts/plot.h"
#include "postproc/charts/slice.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    LEFT = 100,
    RIGHT = 120,
    TOP = 90,
    BOTTOM = 70,
    LONG = 520,
    TALL = 600,
    SHORT = 170,
    COLOURS = 20,
    CORNERS = 12
};

struct panel {
    double low[2], high[2]; /* m */
    double limit[2];        /* of the colours */
    enum postproc_map map;
    int wide, high_pixels, from; /* pixels; from the left */
};

struct corner {
    double x[2], v;
};

/* The part of a convex polygon on one side of a line x_c = at (sign 1: below it). Returns its corners. */
static int clip(struct corner *p, int n, int c, double at, double sign) {
    struct corner out[CORNERS];
    int m = 0;
    for (int k = 0; k < n; k++) {
        const struct corner *a = &p[k], *b = &p[(k + 1) % n];
        const double da = sign * (at - a->x[c]), db = sign * (at - b->x[c]);
        if (da >= 0) out[m++] = *a;
        if ((da > 0 && db < 0) || (da < 0 && db > 0)) {
            const double f = da / (da - db);
            out[m++] = (struct corner){{a->x[0] + f * (b->x[0] - a->x[0]), a->x[1] + f * (b->x[1] - a->x[1])},
                                       a->v + f * (b->v - a->v)};
        }
    }
    memcpy(p, out, (size_t)m * sizeof *p);
    return m;
}

/* The corners of a quadrilateral within the panel. */
static int clipped(const struct postproc_patches *p, const struct panel *panel, long quad, struct corner c[CORNERS]) {
    int n = 4;
    for (int k = 0; k < 4; k++)
        c[k] = (struct corner){{p->x[4 * quad + k][0], p->x[4 * quad + k][1]}, p->value[4 * quad + k]};
    for (int d = 0; d < 2 && n > 0; d++) {
        n = clip(c, n, d, panel->high[d], 1);
        if (n > 0) n = clip(c, n, d, panel->low[d], -1);
    }
    return n;
}

struct weighted {
    double value, weight;
};
static int by_value(const void *a, const void *b) {
    const double x = ((const struct weighted *)a)->value, y = ((const struct weighted *)b)->value;
    return x < y ? -1 : x > y;
}

/* Limits that hold all but a hundredth of the panel's area at each end, and the colours between them. */
static void set_limits(const struct postproc_patches *p, struct panel *panel) {
    struct weighted *all = memory_new(MEMORY_OUTPUT, (size_t)p->quads + 1, sizeof *all);
    double whole = 0, sum = 0;
    long n = 0;
    panel->map = p->map;
    panel->limit[0] = 0;
    panel->limit[1] = 1;
    for (long q = 0; q < p->quads; q++) {
        struct corner c[CORNERS];
        const int m = clipped(p, panel, q, c);
        double twice = 0, mean = 0;
        for (int k = 0; k < m; k++) {
            const struct corner *a = &c[k], *b = &c[(k + 1) % m];
            twice += a->x[0] * b->x[1] - a->x[1] * b->x[0];
            mean += a->v / m;
        }
        if (m < 3 || !isfinite(mean)) continue;
        all[n++] = (struct weighted){mean, 0.5 * fabs(twice)};
        whole += 0.5 * fabs(twice);
    }
    qsort(all, (size_t)n, sizeof *all, by_value);
    for (long k = 0; k < n; k++) {
        if (sum <= 0.01 * whole) panel->limit[0] = all[k].value;
        sum += all[k].weight;
        if (sum <= 0.99 * whole) panel->limit[1] = all[k].value;
    }
    memory_free(all);
    const double most = fmax(fabs(panel->limit[0]), fabs(panel->limit[1]));
    if (!(panel->limit[1] - panel->limit[0] > 1e-6 * most)) { /* one value, up to rounding */
        panel->limit[0] -= most > 0 ? 0.1 * most : 1;
        panel->limit[1] += most > 0 ? 0.1 * most : 1;
    } else if (panel->limit[0] > 0 && panel->limit[0] < 0.5 * panel->limit[1])
        panel->limit[0] = 0;
    else if (panel->limit[0] < 0 && panel->limit[1] > 0 && fmin(-panel->limit[0], panel->limit[1]) > 0.2 * most) {
        panel->map = POSTPROC_DIVERGING;
        panel->limit[0] = -most;
        panel->limit[1] = most;
    }
}

/* A quadrilateral as a grid of two by two points; what the panel's border cuts becomes triangles. */
static void put_quads(FILE *f, const struct postproc_patches *p, const struct panel *panel, int number, double unit,
                      double scale) {
    fprintf(f, "$quads%d << EOD\n", number);
    for (long q = 0; q < p->quads; q++) {
        struct corner c[CORNERS];
        const int m = clipped(p, panel, q, c);
        for (int k = 1; k + 1 < m; k += m == 4 ? 2 : 1) {
            const struct corner *const at[4] = {&c[0], &c[k], &c[m == 4 ? 3 : k + 1], &c[k + 1]};
            for (int i = 0; i < 4; i++)
                fprintf(f, "%.7g %.7g %.6g\n%s", at[i]->x[0] / unit, at[i]->x[1] / unit, at[i]->v / scale,
                        i == 1   ? "\n"
                        : i == 3 ? "\n\n"
                                 : "");
        }
    }
    fputs("EOD\n", f);
}

static void put_lines(FILE *f, const struct postproc_patches *p, double unit) {
    for (int k = 0; k < p->lines; k++) {
        const struct postproc_patches_line *line = &p->line[k];
        fprintf(f, "$line%d << EOD\n", k);
        for (long i = 0; i < line->n; i++) {
            if (isfinite(line->x[i][0]))
                fprintf(f, "%.7g %.7g\n", line->x[i][0] / unit, line->x[i][1] / unit);
            else
                fputc('\n', f);
        }
        fputs("EOD\n", f);
    }
}

static void put_panel(FILE *f, const struct postproc_patches *p, const struct panel *panel, int number, double unit,
                      const char *name, int power, int wide, int high) {
    const double top = 1 - (double)TOP / high;
    fprintf(f,
            "set lmargin at screen %.6g\nset rmargin at screen %.6g\nset tmargin at screen %.6g\nset bmargin at screen "
            "%.6g\nset xrange [%.10g:%.10g]\nset yrange [%.10g:%.10g]\n",
            (double)panel->from / wide, (double)(panel->from + panel->wide) / wide, top,
            top - (double)panel->high_pixels / high, panel->low[0] / unit, panel->high[0] / unit, panel->low[1] / unit,
            panel->high[1] / unit);
    if (p->value) {
        postproc_slice_palette(f, panel->map, COLOURS);
        fprintf(f, "set cbrange [%.6g:%.6g]\n", panel->limit[0] / pow(10, power), panel->limit[1] / pow(10, power));
        fprintf(f, "set colorbox user origin screen %.6g, screen %.6g size screen %.6g, screen %.6g\n",
                (panel->from + panel->wide + 14.0) / wide, top - (double)panel->high_pixels / high, 16.0 / wide,
                (double)panel->high_pixels / high);
    }
    /* the colours by splot, which puts tics at wrong distances; lines and tics by plot over them */
    fputs("set border 15 front lw 1 lc rgb '#5a6068'\n", f);
    if (p->value)
        fprintf(f,
                "unset xtics\nunset ytics\nunset xlabel\nunset ylabel\nset cbtics nomirror out scale 0.6 textcolor rgb "
                "'#23282e'\nsplot $quads%d using "
                "1:2:3 with pm3d\nunset label\n",
                number);
    fprintf(f, "set xlabel 'x  [%s]'\nset ylabel 'y  [%s]'\n", name, name);
    for (int c = 0; c < 2; c++) fprintf(f, "set %ctics nomirror out scale 0.6 textcolor rgb '#23282e'\n", "xy"[c]);
    fputs("plot NaN notitle", f);
    for (int k = 0; k < p->lines; k++)
        if (!p->line[k].detail || number > 0 || !(p->half > 0))
            fprintf(f, ", \\\n     $line%d %s", k, p->line[k].style);
    fputc('\n', f);
    fputs("unset label\n", f);
}

/* Where the panels are in the picture. Returns their number. */
static int panels_of(const struct postproc_patches *p, struct panel panel[2], int *wide, int *high) {
    const double size[2] = {p->high[0] - p->low[0], p->high[1] - p->low[1]};
    const double scale = fmin(LONG / size[0], TALL / size[1]);
    const int panels = p->half > 0 ? 2 : 1, bar = p->value ? RIGHT : 30;
    memset(panel, 0, 2 * sizeof *panel);
    for (int c = 0; c < 2; c++) {
        panel[0].low[c] = p->low[c];
        panel[0].high[c] = p->high[c];
        panel[1].low[c] = p->centre[c] - p->half;
        panel[1].high[c] = p->centre[c] + p->half;
    }
    panel[0].from = LEFT;
    panel[0].wide = (int)fmax(scale * size[0], SHORT);
    panel[0].high_pixels = (int)fmax(scale * size[1], SHORT);
    *wide = LEFT + panel[0].wide + bar;
    *high = TOP + BOTTOM + panel[0].high_pixels;
    if (panels == 2) {
        panel[1].from = *wide + LEFT;
        panel[1].wide = panel[1].high_pixels = LONG;
        *wide += LEFT + LONG + bar;
        *high = TOP + BOTTOM + (int)fmax(panel[0].high_pixels, LONG);
    }
    *wide = (int)fmax(*wide, 620);
    return panels;
}

enum postproc_plot_status postproc_patches_draw(const struct postproc_patches *p) {
    FILE *f = postproc_gnuplot_script_new(p->folder, p->name);
    if (!f) return POSTPROC_PLOT_NO_FILE;
    const char *unit;
    const double length = postproc_plot_unit(fmax(p->high[0] - p->low[0], p->high[1] - p->low[1]), &unit);
    struct panel panel[2];
    int wide, high, power = 0;
    const int panels = panels_of(p, panel, &wide, &high);
    put_lines(f, p, length);
    if (p->value) {
        for (int k = 0; k < panels; k++) set_limits(p, &panel[k]);
        power = postproc_gnuplot_power(fmax(fabs(panel[0].limit[0]), fabs(panel[0].limit[1])));
        for (int k = 0; k < panels; k++) put_quads(f, p, &panel[k], k, length, pow(10, power));
    }
    for (int k = 0; k < POSTPROC_FORMATS; k++) {
        if (k == POSTPROC_SVG && p->value) continue; /* some five megabytes */
        postproc_gnuplot_terminal(f, (enum postproc_format)k, p->name, wide, high);
        fprintf(f,
                "set encoding utf8\nunset key\nunset ztics\nset view map\nset pm3d corners2color mean border retrace "
                "interpolate %d,%d\nset multiplot\nset label 1 ",
                k ? 2 : 5, k ? 2 : 5);
        postproc_gnuplot_text(f, p->title);
        fprintf(f, " at screen %.6g, screen %.6g left noenhanced font ',15' tc rgb '#23282e'\nset label 2 ",
                20.0 / wide, 1 - 24.0 / high);
        postproc_gnuplot_text(f, p->subtitle);
        fprintf(f, " at screen %.6g, screen %.6g left noenhanced tc rgb '#5a6068'\n", 20.0 / wide, 1 - 50.0 / high);
        if (p->value) {
            fputs("set label 3 ", f);
            postproc_gnuplot_text(f, p->label);
            fprintf(f, " at screen %.6g, screen %.6g right noenhanced tc rgb '#23282e'\n", 1 - 10.0 / wide,
                    1 - 72.0 / high);
            if (power)
                fprintf(f, "set label 4 '× 10^{%d}' at screen %.6g, screen %.6g right tc rgb '#23282e'\n", power,
                        1 - 10.0 / wide, 1 - 50.0 / high);
        }
        for (int n = 0; n < panels; n++) put_panel(f, p, &panel[n], n, length, unit, power, wide, high);
        fputs("unset multiplot\n", f);
    }
    return postproc_gnuplot_script_end(f, p->folder, p->name);
}
