/* Writes the gnuplot script of an injection's record and runs it. */
#include "postproc/charts/injection.h"

#include <math.h>
#include <stdio.h>

enum { ROWS_MAX = 4000 };

static double largest(long n, const double *value) {
    double most = 0;
    for (long i = 0; i < n; i++)
        if (isfinite(value[i])) most = fmax(most, fabs(value[i]));
    return most;
}

/* The axis is `span` times as long as the values: the labels of marks stand above the curves; the rate lies below the
 * pressure's largest value. */
static void put_range(FILE *f, const char *axis, long n, const double *value, double scale, double span) {
    double low = 0, high = 0;
    for (long i = 0; i < n; i++) {
        if (!isfinite(value[i])) continue;
        low = fmin(low, value[i]);
        high = fmax(high, value[i]);
    }
    if (!(high > low)) return;
    fprintf(f, "set %s [%.10g:%.10g]\n", axis, scale * (low < 0 ? low - 0.05 * (high - low) : 0),
            scale * (low + span * (high - low)));
}

/* "rate  [10^{-6} m^3/s]" */
static void put_label(FILE *f, const char *axis, const char *what, int power, const char *unit) {
    if (power)
        fprintf(f, "set %s '%s  [10^{%d} %s]'\n", axis, what, power, unit);
    else
        fprintf(f, "set %s '%s  [%s]'\n", axis, what, unit);
}

static void put_style(FILE *f, const struct postproc_injection_plot *p, const int power[3]) {
    fputs("set encoding utf8\nset border 11 lw 1 lc rgb '#5a6068'\n"
          "set tics nomirror out scale 0.6 textcolor rgb '#23282e'\nset y2tics\n"
          "set grid back lt 1 lw 0.6 lc rgb '#e4e7ea'\nset lmargin 11\nset rmargin 11\nset tmargin 5\n"
          "set key at screen 0.97, screen 0.955 right vertical maxrows 1 samplen 2 textcolor rgb '#23282e'\n",
          f);
    postproc_gnuplot_title(f, p->title);
    if (power[0])
        fprintf(f, "set label 91 '× 10^{%d}' at graph 1, graph 0 right offset 0,-2.5 tc rgb '#23282e'\n", power[0]);
    fputs("set xlabel ", f);
    postproc_gnuplot_text(f, p->time);
    fputc('\n', f);
    put_label(f, "ylabel", "pressure at the injection", power[1], "Pa");
    put_label(f, "y2label", "rate of injection", power[2], "m^3/s");
    for (int k = 0; k < p->marks; k++) {
        const double x = p->mark[k].x / pow(10, power[0]);
        fprintf(f,
                "set arrow %d from first %.10g, graph 0 to first %.10g, graph %g nohead back dt 2 lw 1.2 lc rgb "
                "'#8a9199'\nset label %d ",
                k + 1, x, x, 0.99 - 0.055 * k, k + 2);
        postproc_gnuplot_text(f, p->mark[k].label);
        fprintf(f, " at first %.10g, graph %g left offset 0.6,0 front tc rgb '#5a6068'\n", x, 0.97 - 0.055 * k);
    }
}

enum postproc_plot_status postproc_injection_draw(const struct postproc_injection_plot *p) {
    FILE *f = postproc_gnuplot_script_new(p->folder, p->name);
    if (!f) return POSTPROC_PLOT_NO_FILE;
    const int power[3] = {postproc_gnuplot_power(largest(p->n, p->when)),
                          postproc_gnuplot_power(largest(p->n, p->pressure)),
                          postproc_gnuplot_power(largest(p->n, p->rate))};
    double scale[3];
    for (int k = 0; k < 3; k++) scale[k] = pow(10, -power[k]);
    fputs("$record << EOD\n", f);
    for (long i = 0, stride = p->n / ROWS_MAX + 1; i < p->n; i += stride)
        fprintf(f, "%.10g %.10g %.10g\n", scale[0] * p->when[i], scale[1] * p->pressure[i], scale[2] * p->rate[i]);
    fputs("EOD\n", f);
    const int is_peak = isfinite(p->peak[0]);
    if (is_peak) fprintf(f, "$peak << EOD\n%.10g %.10g\nEOD\n", scale[0] * p->peak[0], scale[1] * p->peak[1]);
    put_style(f, p, power);
    put_range(f, "yrange", p->n, p->pressure, scale[1], 1.2);
    put_range(f, "y2range", p->n, p->rate, scale[2], 1.5);
    postproc_gnuplot_terminal(f, POSTPROC_PNG, p->name, 1200, 760);
    fprintf(f,
            "plot $record using 1:3 axes x1y2 with lines lw 2 lc rgb '#E69F00' title 'rate', \\\n"
            "     $record using 1:2 with lines lw 2 lc rgb '#0072B2' title 'pressure'%s\n",
            is_peak ? ", \\\n     $peak using 1:2 with points pt 7 ps 1.4 lc rgb '#D55E00' notitle" : "");
    postproc_gnuplot_again(f, p->name, 1200, 760, "replot");
    return postproc_gnuplot_script_end(f, p->folder, p->name);
}
