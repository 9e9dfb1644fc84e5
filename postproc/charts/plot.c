/* Writes a gnuplot script and runs it. */
#include "postproc/charts/plot.h"
#include "base/memory.h"
#include "base/sort.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { ROWS_MAX = 4000, BAND = 4 };

/* Colours that colour-blind readers can distinguish.  (Okabe and Ito 2008) */
static const char *const palette[] = {"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000"};
enum { PALETTE = 7 };

/* Further curves than colours have another form of their points and lines. */
static const struct {
    int point, dash; /* gnuplot's numbers: disc, square, triangle, diamond */
} form[] = {{7, 1}, {5, 2}, {9, 4}, {13, 3}};
enum { FORMS = sizeof form / sizeof *form };

double postproc_plot_unit(double size, const char **name) {
    static const struct {
        double size;
        const char *name;
    } unit[] = {{1, "m"}, {1e-3, "mm"}, {1e-6, "µm"}, {1e-9, "nm"}};
    int k = 0;
    while (k < 3 && size < 0.9999 * unit[k].size) k++;
    *name = unit[k].name;
    return unit[k].size;
}

static void put_point(FILE *f, const struct postproc_plot *p, const struct postproc_curve *c, long i) {
    if (isfinite(c->y[i]) && isfinite(c->x[i]) && !(p->log_y && c->y[i] <= 0) && !(p->log_x && c->x[i] <= 0)) {
        fprintf(f, "%.10g %.10g", c->x[i], c->y[i]);
        if (c->label) {
            fputs(" \"", f);
            for (const char *at = c->label[i]; *at; at++) fputc(strchr("\"\\\n", *at) ? ' ' : *at, f);
            fputc('"', f);
        }
    }
    fputc('\n', f);
}

static void put_band(FILE *f, const struct postproc_plot *p, const struct postproc_curve *c, long i) {
    const double *low = &c->band[BAND * i];
    if (isfinite(low[0]) && !(p->log_y && low[0] <= 0) && !(p->log_x && c->x[i] <= 0))
        fprintf(f, "%.10g %.10g %.10g %.10g %.10g", c->x[i], low[0], low[1], low[2], low[3]);
    fputc('\n', f);
}

static void put_data(FILE *f, const struct postproc_plot *p) {
    for (int k = 0; k < p->curves; k++) {
        const struct postproc_curve *c = &p->curve[k];
        const long stride = c->n / ROWS_MAX + 1;
        fprintf(f, "$curve%d << EOD\n", k);
        for (long i = 0; i < c->n; i += c->bars ? 1 : stride) put_point(f, p, c, i);
        fputs("EOD\n", f);
        if (!c->band) continue;
        fprintf(f, "$band%d << EOD\n", k);
        for (long i = 0; i < c->n; i += stride) put_band(f, p, c, i);
        fputs("EOD\n", f);
    }
}

/* What the axes of a plot show. */
struct axes {
    int power[2];         /* 10^power is written once beside the axis; x, y */
    double unit[2];       /* 10^power */
    double y_low, y_high; /* NAN: from the data */
    double peak;          /* the value farthest beyond the range, NAN: none */
};

static int is_drawn(const struct postproc_plot *p, const struct postproc_curve *c, long i) {
    const int limited = isfinite(p->x_low) && isfinite(p->x_high) && p->x_high > p->x_low;
    if (!isfinite(c->x[i]) || !isfinite(c->y[i]) || (p->log_y && c->y[i] <= 0)) return 0;
    return !limited || (c->x[i] >= p->x_low && c->x[i] <= p->x_high);
}

/* A range around values that are all equal; gnuplot would warn about an empty one. */
static void flat_range(struct axes *a, const struct postproc_plot *p, double low, double high) {
    if (p->log_y) {
        a->y_low = 0.1 * high;
        a->y_high = 10 * high;
    } else {
        a->y_low = low > 0 ? 0 : 2 * low;
        a->y_high = low < 0 ? 0 : low > 0 ? 2 * low : 1;
    }
}

/* Where a spike at the start would set the range: from the 1 % to the 99 % quantile of the drawn values, if those
 * beyond are more than three times farther away, and all stand in the first fifth of the plot. */
static void spike_range(struct axes *a, const struct postproc_plot *p, long n, const double low[2],
                        const double high[2]) {
    double *sorted = memory_new(MEMORY_OUTPUT, (size_t)n + 1, sizeof *sorted);
    long m = 0;
    for (int k = 0; k < p->curves; k++)
        for (long i = 0; i < p->curve[k].n; i++)
            if (is_drawn(p, &p->curve[k], i)) sorted[m++] = p->curve[k].y[i];
    sort_ascending(sorted, (size_t)m);
    const double first = sorted[(long)(0.01 * (double)(m - 1))], last = sorted[(long)(0.99 * (double)(m - 1))];
    const double span = last - first;
    memory_free(sorted);
    if (!(span > 0) || (high[1] - last <= 3 * span && first - low[1] <= 3 * span)) return;
    for (int k = 0; k < p->curves; k++)
        for (long i = 0; i < p->curve[k].n; i++) {
            const double y = p->curve[k].y[i];
            if (!is_drawn(p, &p->curve[k], i) || (y >= first - 0.08 * span && y <= last + 0.08 * span)) continue;
            if (p->curve[k].x[i] > low[0] + 0.2 * (high[0] - low[0])) return;
        }
    a->y_low = fmin(first - 0.08 * span, 0 <= first && first < span ? 0 : INFINITY);
    a->y_high = last + 0.08 * span;
    a->peak = high[1] - last > first - low[1] ? high[1] : low[1];
}

static void band_extend(const struct postproc_curve *c, long i, double *low, double *high) {
    if (!c->band) return;
    *low = fmin(*low, c->band[BAND * i]);
    *high = fmax(*high, c->band[BAND * i + BAND - 1]);
}

static struct axes axes_of(const struct postproc_plot *p) {
    struct axes a = {.unit = {1, 1}, .y_low = NAN, .y_high = NAN, .peak = NAN};
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    long n = 0;
    int bars = 0;
    for (int k = 0; k < p->curves; k++) {
        bars = bars || p->curve[k].bars;
        for (long i = 0; i < p->curve[k].n; i++) {
            if (!is_drawn(p, &p->curve[k], i)) continue;
            const double at[2] = {p->curve[k].x[i], p->curve[k].y[i]};
            for (int d = 0; d < 2; d++) {
                low[d] = fmin(low[d], at[d]);
                high[d] = fmax(high[d], at[d]);
            }
            band_extend(&p->curve[k], i, &low[1], &high[1]);
            n++;
        }
    }
    if (n == 0) return a;
    if (high[1] - low[1] <= 1e-9 * fabs(high[1]))
        flat_range(&a, p, low[1], high[1]);
    else if (!p->log_y && !bars && !p->whole)
        spike_range(&a, p, n, low, high);
    const int is_log[2] = {p->log_x, p->log_y};
    const double most[2] = {fmax(fabs(low[0]), fabs(high[0])),
                            isnan(a.peak) ? fmax(fabs(low[1]), fabs(high[1])) : fmax(fabs(a.y_low), fabs(a.y_high))};
    for (int d = 0; d < 2; d++) {
        a.power[d] = is_log[d] ? 0 : postproc_gnuplot_power(most[d]);
        a.unit[d] = pow(10, a.power[d]);
    }
    return a;
}

/* The axes' powers of ten, and a note where a value is beyond the range. */
static void put_powers(FILE *f, const struct axes *a) {
    if (a->power[1])
        fprintf(f, "set label 90 '× 10^{%d}' at graph 0, graph 1 left offset 0,0.8 tc rgb '#23282e'\n", a->power[1]);
    if (a->power[0])
        fprintf(f, "set label 91 '× 10^{%d}' at graph 1, graph 0 right offset 0,-2.5 tc rgb '#23282e'\n", a->power[0]);
    if (!isnan(a->peak))
        fprintf(f,
                "set label 92 'extreme at the start, beyond the axis: %.3g' at graph 1, graph 1 right offset 0,0.8 "
                "noenhanced "
                "front tc rgb '#5a6068'\n",
                a->peak);
}

/* Ranges of a plot with two logarithmic axes: of the data and of the levels, with space for labels on the right. */
static void put_log_range(FILE *f, char axis, double low, double high, double right) {
    if (!(low > 0) || !isfinite(high)) return;
    const double margin = fmax(0.08 * log(high / low), 0.25);
    fprintf(f, "set %crange [%.4g:%.4g]\n", axis, low * exp(-margin), high * exp(margin * right));
    if (high >= 30 * low) return;
    const double end[2] = {low, high}, length = log(high / low) + margin * (1 + right);
    fprintf(f, "set format %c '%%g'\n", axis);
    for (int k = 0; k < 2; k++) { /* their labels, where there is room beside that of a power of ten */
        const double decade = M_LN10 * round(log10(end[k]));
        if (fabs(log(end[k]) - decade) > 0.06 * length) fprintf(f, "set %ctics add (%.2g)\n", axis, end[k]);
    }
}

static void put_log_ranges(FILE *f, const struct postproc_plot *p) {
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (int k = 0; k < p->curves; k++)
        for (long i = 0; i < p->curve[k].n; i++) {
            const double at[2] = {p->curve[k].x[i], p->curve[k].y[i]};
            if (!(at[0] > 0 && at[1] > 0 && isfinite(at[0]) && isfinite(at[1]))) continue;
            for (int d = 0; d < 2; d++) {
                low[d] = fmin(low[d], at[d]);
                high[d] = fmax(high[d], at[d]);
            }
            if (!p->curve[k].band || p->curve[k].band[BAND * i] > 0) band_extend(&p->curve[k], i, &low[1], &high[1]);
        }
    for (int k = 0; k < p->levels; k++) {
        low[1] = fmin(low[1], p->level[k].y);
        high[1] = fmax(high[1], p->level[k].y);
    }
    put_log_range(f, 'x', low[0], high[0], 2);
    put_log_range(f, 'y', low[1], high[1], 1);
}

/* The legend beside the plot, where gnuplot leaves it its room; below, if its titles are so long that they would take
 * the plot's. */
static void put_legend(FILE *f, const struct postproc_plot *p) {
    size_t longest = 0;
    for (int k = 0; k < p->curves && p->curves > 1; k++)
        if (strlen(p->curve[k].title) > longest) longest = strlen(p->curve[k].title);
    const int is_below = longest > 36, columns = longest > 60 ? 1 : 2;
    fprintf(f, "set key %s vertical Left reverse samplen 2 textcolor rgb '#23282e'",
            is_below ? "outside center bottom" : "outside right top");
    if (is_below) fprintf(f, " maxrows %d height 1.5", (p->curves + columns - 1) / columns);
    fputc('\n', f);
    if (p->curves < 2 || is_below) fputs("set rmargin 5\n", f);
}

static void put_style(FILE *f, const struct postproc_plot *p, const struct axes *a) {
    fputs("set encoding utf8\nset border 3 lw 1 lc rgb '#5a6068'\n"
          "set tics nomirror out scale 0.6 textcolor rgb '#23282e'\n"
          "set grid back lt 1 lw 0.6 lc rgb '#e4e7ea'\n"
          "set lmargin 11\nset tmargin 5\n"
          "set datafile missing 'nan'\n",
          f);
    postproc_gnuplot_title(f, p->title);
    put_legend(f, p);
    fputs("set xlabel ", f);
    postproc_gnuplot_text(f, p->xlabel);
    fputs("\nset ylabel ", f);
    postproc_gnuplot_text(f, p->ylabel);
    fputs(" offset -1,0\n", f);
    if (p->log_y) fputs("set logscale y\nset format y '10^{%T}'\n", f);
    if (p->log_x) fputs("set logscale x\nset format x '10^{%T}'\nset mxtics 10\nset mytics 10\n", f);
    if (p->log_x && p->log_y)
        put_log_ranges(f, p);
    else
        put_powers(f, a);
    if (!(p->log_x && p->log_y) && !isnan(a->y_low))
        fprintf(f, "set yrange [%.10g:%.10g]\n", a->y_low / a->unit[1], a->y_high / a->unit[1]);
    if (isfinite(p->x_low) && isfinite(p->x_high) && p->x_high > p->x_low)
        fprintf(f, "set xrange [%.10g:%.10g]\n", p->x_low / a->unit[0], p->x_high / a->unit[0]);
    for (int k = 0; k < p->marks; k++) {
        fprintf(f,
                "set arrow %d from first %.10g, graph 0 to first %.10g, graph 1 nohead back dt 2 lw 1.2 lc "
                "rgb '#8a9199'\n",
                k + 1, p->mark[k].x / a->unit[0], p->mark[k].x / a->unit[0]);
        fprintf(f, "set label %d ", k + 2);
        postproc_gnuplot_text(f, p->mark[k].label);
        fprintf(f, " at first %.10g, graph 0.97 left offset 0.6,0 front tc rgb '#5a6068'\n", p->mark[k].x / a->unit[0]);
    }
}

/* Horizontal lines, and the positions of their labels. */
static void put_levels(FILE *f, const struct postproc_plot *p, const struct axes *a) {
    const double unit = a->unit[1];
    for (int k = 0; k < p->levels; k++) {
        fprintf(f,
                "set arrow %d from graph 0, first %.10g to graph 1, first %.10g nohead back dt 2 lw 1.2 lc rgb "
                "'#8a9199'\nset label %d ",
                100 + k, p->level[k].y / unit, p->level[k].y / unit, 100 + k);
        postproc_gnuplot_text(f, p->level[k].label);
        fprintf(f, " at graph 0.99, first %.10g right offset 0,0.5 front tc rgb '#5a6068'\n", p->level[k].y / unit);
    }
}

/* The columns of a curve, divided by the axes' powers of ten. */
static void put_using(FILE *f, const struct axes *a) {
    fputs("using ", f);
    for (int d = 0; d < 2; d++)
        if (a->power[d])
            fprintf(f, "%s($%d*1e%d)", d ? ":" : "", d + 1, -a->power[d]);
        else
            fprintf(f, "%s%d", d ? ":" : "", d + 1);
}

/* The shaded band of a curve and its dotted ends, below the curve. */
static void put_band_plot(FILE *f, const struct postproc_plot *p, const struct axes *a, int k) {
    const char *colour = palette[k % PALETTE];
    const double x = a->unit[0], y = a->unit[1];
    if (!p->curve[k].band) return;
    fprintf(f,
            "$band%d using ($1/%g):($3/%g):($4/%g) with filledcurves fs transparent solid 0.2 noborder lc rgb '%s' "
            "notitle, \\\n     ",
            k, x, y, y, colour);
    for (int end = 2; end <= 5; end += 3)
        fprintf(f, "$band%d using ($1/%g):($%d/%g) with lines lw 1.2 dt 3 lc rgb '%s' notitle, \\\n     ", k, x, end, y,
                colour);
}

static void put_curves(FILE *f, const struct postproc_plot *p, const struct axes *a) {
    fputs("plot ", f);
    for (int k = 0; k < p->curves; k++) {
        fputs(k ? ", \\\n     " : "", f);
        put_band_plot(f, p, a, k);
        fprintf(f, "$curve%d ", k);
        put_using(f, a);
        const int style = k / PALETTE % FORMS;
        if (p->curve[k].bars)
            fputs(" with histeps", f);
        else if (p->curve[k].label || p->curve[k].points)
            fprintf(f, " with linespoints pt %d ps 1.1", form[style].point);
        else
            fputs(" with lines", f);
        fprintf(f, " lw 2 dt %d lc rgb '%s' ", form[style].dash, palette[k % PALETTE]);
        if (p->curves > 1) {
            fputs("title ", f);
            postproc_gnuplot_text(f, p->curve[k].title);
            fputs(" noenhanced", f);
        } else
            fputs("notitle", f);
        if (p->curve[k].label) {
            fprintf(f, ", \\\n     $curve%d ", k);
            put_using(f, a);
            fprintf(f, ":3 with labels left offset 0.8,0.5 noenhanced font ',11' tc rgb '%s' notitle",
                    palette[k % PALETTE]);
        }
    }
    fputc('\n', f);
}

enum postproc_plot_status postproc_plot_draw(const struct postproc_plot *p) {
    FILE *f = postproc_gnuplot_script_new(p->folder, p->name);
    if (!f) return POSTPROC_PLOT_NO_FILE;
    put_data(f, p);
    const struct axes axes = axes_of(p);
    put_style(f, p, &axes);
    put_levels(f, p, &axes);
    postproc_gnuplot_terminal(f, POSTPROC_PNG, p->name, 1200, 760);
    put_curves(f, p, &axes);
    postproc_gnuplot_again(f, p->name, 1200, 760, "replot");
    return postproc_gnuplot_script_end(f, p->folder, p->name);
}
