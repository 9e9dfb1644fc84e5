/* Writes the gnuplot script of the places of events and runs it. */
#include "postproc/charts/events.h"
#include "base/memory.h"
#include "postproc/charts/plot.h"
#include "postproc/charts/slice.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { MOST = 20000 };                            /* events that are drawn: those with the most energy */
static const double LARGEST = 4, SMALLEST = 0.35; /* point sizes */

struct one {
    double x[2], when, energy;
};

static int by_energy(const void *a, const void *b) {
    const struct one *p = a, *q = b;
    if (p->energy != q->energy) return p->energy > q->energy ? -1 : 1;
    return (p->when > q->when) - (p->when < q->when);
}

struct range {
    double low, high;
};

static void widen(struct range *r, double value) {
    r->low = fmin(r->low, value);
    r->high = fmax(r->high, value);
}

/* The large ones first, so that the small ones stand on them. An area goes with the energy to the power 2/3, which has
 * more than six decades. */
static void put_data(FILE *f, const struct one *list, long n, double unit) {
    fputs("$events << EOD\n", f);
    for (long i = 0; i < n; i++)
        fprintf(f, "%.8g %.8g %.8g %.4g\n", list[i].x[0] / unit, list[i].x[1] / unit, list[i].when,
                SMALLEST + (LARGEST - SMALLEST) * cbrt(list[i].energy / list[0].energy));
    fputs("EOD\n", f);
}

static void put_style(FILE *f, const struct postproc_events_plot *p, const struct range range[3], double unit,
                      const char *name) {
    const double margin = 0.06 * fmax(range[0].high - range[0].low, range[1].high - range[1].low);
    const int power = postproc_gnuplot_power(fmax(fabs(range[2].low), fabs(range[2].high)));
    const double least = fmax(margin, 1e-6 * unit);
    fputs("set encoding utf8\nset border 3 lw 1 lc rgb '#5a6068'\n"
          "set tics nomirror out scale 0.6 textcolor rgb '#23282e'\n"
          "set grid back lt 1 lw 0.6 lc rgb '#e4e7ea'\nunset key\nset size ratio -1\nset tmargin 5\nset lmargin 11\n",
          f);
    postproc_gnuplot_title(f, p->title);
    fprintf(f, "set xlabel '%c  [%s]'\nset ylabel '%c  [%s]'\nset rmargin 13\nset label 2 ", p->across[0], name,
            p->across[1], name);
    postproc_gnuplot_text(f, p->time);
    fprintf(f, " at graph 1, graph 1 left offset 1,%g tc rgb '#23282e'\n", power ? 2.3 : 0.9);
    if (power) fprintf(f, "set label 3 '× 10^{%d}' at graph 1, graph 1 left offset 1,0.9 tc rgb '#23282e'\n", power);
    postproc_slice_palette(f, POSTPROC_VIRIDIS, 0);
    for (int c = 0; c < 2; c++)
        fprintf(f, "set %crange [%.10g:%.10g]\n", "xy"[c], (range[c].low - least) / unit,
                (range[c].high + least) / unit);
    const double scale = pow(10, -power), some = range[2].high > range[2].low ? 0 : fmax(fabs(range[2].high), 1) * 0.5;
    fprintf(f, "set cbrange [%.10g:%.10g]\n", scale * (range[2].low - some), scale * (range[2].high + some));
    fprintf(f,
            "plot $events using 1:2:4:($3*1e%d) with points pt 7 ps variable lc palette notitle, \\\n"
            "     $events using 1:2:4 with points pt 6 ps variable lw 0.5 lc rgb '#a0000000' notitle\n",
            -power);
}

enum postproc_plot_status postproc_events_draw(const struct postproc_events_plot *p) {
    FILE *f = postproc_gnuplot_script_new(p->folder, p->name);
    if (!f) return POSTPROC_PLOT_NO_FILE;
    struct one *list = memory_new(MEMORY_OUTPUT, (size_t)p->n, sizeof *list);
    struct range range[3] = {{INFINITY, -INFINITY}, {INFINITY, -INFINITY}, {INFINITY, -INFINITY}};
    for (long i = 0; i < p->n; i++) {
        list[i] = (struct one){{p->at[0][i], p->at[1][i]}, p->when[i], p->energy[i]};
        for (int c = 0; c < 2; c++) widen(&range[c], list[i].x[c]);
        widen(&range[2], list[i].when);
    }
    qsort(list, (size_t)p->n, sizeof *list, by_energy);
    const char *name;
    const double unit = postproc_plot_unit(fmax(range[0].high - range[0].low, range[1].high - range[1].low), &name);
    put_data(f, list, p->n < MOST ? p->n : MOST, unit);
    postproc_gnuplot_terminal(f, POSTPROC_PNG, p->name, 1100, 800);
    put_style(f, p, range, unit, name);
    postproc_gnuplot_again(f, p->name, 1100, 800, "replot");
    memory_free(list);
    return postproc_gnuplot_script_end(f, p->folder, p->name);
}
