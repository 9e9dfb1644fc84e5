/* Draws slices.csv and rev.csv: porosity and solid area of the slices, and how porosity and k by Kozeny and Carman
 * scatter among sub-volumes of growing size. */
#include "postproc/charts/charts.h"
#include "base/arena.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { TIMES = 2, DIRECTIONS = 3, TITLE = 64 };

static double cell(const struct table_data *d, long row, int column) { return d->value[row * d->columns + column]; }

/* The last time in column t that is not later than `until`; NAN if all are later. */
static double time_until(const struct table_data *d, int t, double until) {
    double last = NAN;
    for (long i = 0; i < d->rows; i++)
        if (cell(d, i, t) <= until) last = cell(d, i, t);
    return last;
}

/* The slices across one direction at one time; */
struct profile {
    long n;
    double *at, *porosity; /* [n] m, 1 */
};

/* All profiles: of the last sample, and before it of the last one up to the start of the last stage, if that is an
 * earlier one with other values. */
struct slices {
    int times;
    double time[TIMES]; /* s */
    struct profile profile[TIMES][DIRECTIONS];
};

static void profiles_read(struct profile p[DIRECTIONS], const struct table_data *d, double time) {
    const int t = table_read_column(d, "t"), direction = table_read_column(d, "direction");
    const int at = table_read_column(d, "at"), porosity = table_read_column(d, "porosity");
    for (int c = 0; c < DIRECTIONS; c++) {
        p[c] =
            (struct profile){0, arena_new((size_t)d->rows, sizeof(double)), arena_new((size_t)d->rows, sizeof(double))};
        for (long i = 0; i < d->rows; i++) {
            if (cell(d, i, t) != time || cell(d, i, direction) != c) continue;
            p[c].at[p[c].n] = cell(d, i, at);
            p[c].porosity[p[c].n++] = cell(d, i, porosity);
        }
    }
}

static int are_same(const struct profile a[DIRECTIONS], const struct profile b[DIRECTIONS]) {
    for (int c = 0; c < DIRECTIONS; c++) {
        if (a[c].n != b[c].n) return 0;
        for (long i = 0; i < a[c].n; i++)
            if (a[c].porosity[i] != b[c].porosity[i]) return 0;
    }
    return 1;
}

/* No times if the table is missing or is none of slices. */
static void slices_read(struct slices *s, const struct postproc_history *h) {
    const struct table_data *d = h->slices;
    *s = (struct slices){0};
    if (!d || d->rows == 0 || table_read_column(d, "t") < 0 || table_read_column(d, "direction") < 0 ||
        table_read_column(d, "at") < 0 || table_read_column(d, "porosity") < 0)
        return;
    const int t = table_read_column(d, "t");
    const double before = time_until(d, t, h->origin), end = time_until(d, t, INFINITY);
    if (before < end) {
        s->time[s->times] = before;
        profiles_read(s->profile[s->times++], d, before);
    }
    s->time[s->times] = end;
    profiles_read(s->profile[s->times++], d, end);
    if (s->times < TIMES || !are_same(s->profile[0], s->profile[1])) return;
    s->times--;
    s->time[0] = end;
}

static void title_of(char title[TITLE], const struct postproc_history *h, const struct slices *s, int time, int axis) {
    const double at = postproc_history_when(h, s->time[time]);
    const int used = snprintf(title, TITLE, "across %c", "xyz"[axis]);
    if (s->times > 1)
        snprintf(title + used, (size_t)(TITLE - used), ", %s = %.3g", h->t0 > 0 ? "t/t0" : "t [s]",
                 fabs(at) < 1e-9 ? 0 : at);
}

/* Slices are one cell thick, so the box is one cell longer than the distance of the first and the last. */
static double length_of(const struct profile *p) {
    return p->n > 1 ? (p->at[p->n - 1] - p->at[0]) * (double)p->n / (double)(p->n - 1) : 0;
}

static void slices_draw(struct postproc_charts *charts, const struct postproc_history *h, const char *folder,
                        const struct slices *s) {
    static const char *const solid[DIRECTIONS] = {
        "Solid area of the slices across x", "Solid area of the slices across y", "Solid area of the slices across z"};
    struct postproc_curve curve[TIMES * DIRECTIONS];
    char title[TIMES * DIRECTIONS][TITLE], xlabel[TITLE], ylabel[TITLE];
    double *x[TIMES * DIRECTIONS], *y[TIMES], longest = 0;
    const char *unit, *side;
    int n = 0, areas = 0;
    const int axis = postproc_history_axis(h);
    for (int c = 0; c < DIRECTIONS; c++) longest = fmax(longest, length_of(&s->profile[0][c]));
    const double metre = postproc_plot_unit(longest, &unit);
    for (int q = 0; q < s->times; q++)
        for (int c = 0; c < DIRECTIONS; c++, n++) {
            const struct profile *p = &s->profile[q][c];
            x[n] = arena_new((size_t)p->n, sizeof(double));
            for (long i = 0; i < p->n; i++) x[n][i] = p->at[i] / metre;
            title_of(title[n], h, s, q, c);
            curve[n] = (struct postproc_curve){.title = title[n], .n = p->n, .x = x[n], .y = p->porosity};
        }
    snprintf(xlabel, sizeof xlabel, "place of the slice  [%s]", unit);
    struct postproc_plot plot = {.folder = folder,
                                 .name = "slices_porosity",
                                 .title = "Porosity of the slices",
                                 .xlabel = xlabel,
                                 .ylabel = "porosity",
                                 .curves = longest > 0 ? n : 0,
                                 .curve = curve};
    postproc_charts_add(charts, &plot);
    /* of the direction of the medium: void is gone, what remains is solid */
    const double area = length_of(&s->profile[0][(axis + 1) % 3]) * length_of(&s->profile[0][(axis + 2) % 3]);
    const double square = postproc_plot_unit(5 * sqrt(area), &side); /* areas of 0.04 to 40,000 */
    for (int q = 0; q < s->times; q++, areas++) {
        const struct profile *p = &s->profile[q][axis];
        y[q] = arena_new((size_t)p->n, sizeof(double));
        for (long i = 0; i < p->n; i++) y[q][i] = (1 - p->porosity[i]) * area / (square * square);
        title_of(title[q], h, s, q, axis);
        curve[q] = (struct postproc_curve){.title = title[q], .n = p->n, .x = x[q * DIRECTIONS + axis], .y = y[q]};
    }
    snprintf(ylabel, sizeof ylabel, "solid area  [%s^2]", side);
    plot.name = "slices_solid";
    plot.title = solid[axis];
    plot.ylabel = ylabel;
    plot.curves = area > 0 ? areas : 0;
    postproc_charts_add(charts, &plot);
}

/* One measure of the sub-volumes of the last sample, with its scatter, over their edge. */
struct measure {
    const char *column, *name, *title, *of_deviation, *title_of_deviation, *ylabel;
    int log_y;
    const char *whole_column, *whole; /* of the series: of the whole box; NULL: none */
};

static void measure_draw(struct postproc_charts *charts, const struct postproc_history *h, const char *folder,
                         const struct measure *m) {
    enum { DEVIATION = 3, PARTS };
    static const char *const part[PARTS] = {"mean", "largest", "least", "deviation"};
    const struct table_data *d = h->rev;
    const int t = table_read_column(d, "t"), edge = table_read_column(d, "edge");
    int column[PARTS], whole = t >= 0 && edge >= 0;
    char name[64], xlabel[TITLE];
    for (int k = 0; k < PARTS; k++) {
        snprintf(name, sizeof name, "%s_%s", m->column, part[k]);
        column[k] = table_read_column(d, name);
        whole = whole && column[k] >= 0;
    }
    if (!whole || d->rows == 0) return;
    const double end = time_until(d, t, INFINITY);
    double longest = 0, *x = arena_new((size_t)d->rows, sizeof *x), *y = arena_new(PARTS * (size_t)d->rows, sizeof *y);
    struct postproc_curve curve[PARTS + 1];
    const char *unit;
    long n = 0;
    for (long i = 0; i < d->rows; i++)
        if (cell(d, i, t) == end) longest = fmax(longest, cell(d, i, edge));
    const double metre = postproc_plot_unit(longest, &unit);
    for (long i = 0; i < d->rows; i++) {
        if (cell(d, i, t) != end) continue;
        x[n] = cell(d, i, edge) / metre;
        for (int k = 0; k < PARTS; k++) y[k * d->rows + n] = cell(d, i, column[k]);
        n++;
    }
    int curves = 0;
    for (int k = 0; k < DEVIATION; k++)
        curve[curves++] = (struct postproc_curve){.title = part[k], .n = n, .x = x, .y = y + k * d->rows, .points = 1};
    long first = 0; /* of the smallest sub-volumes that all have a value */
    while (first < n - 1 && !isfinite(y[first])) first++;
    const double value = m->whole_column ? postproc_history_value(h, m->whole_column, end) : NAN;
    const double wx[2] = {n > 0 ? x[first] : 0, n > 0 ? x[n - 1] : 0}, wy[2] = {value, value};
    if (value > 0) curve[curves++] = (struct postproc_curve){.title = m->whole, .n = 2, .x = wx, .y = wy};
    snprintf(xlabel, sizeof xlabel, "edge of a sub-volume  [%s]", unit);
    struct postproc_plot plot = {.folder = folder,
                                 .name = m->name,
                                 .title = m->title,
                                 .xlabel = xlabel,
                                 .ylabel = m->ylabel,
                                 .curves = n > 1 ? curves : 0,
                                 .curve = curve,
                                 .log_y = m->log_y};
    postproc_charts_add(charts, &plot);
    curve[0] =
        (struct postproc_curve){.title = part[DEVIATION], .n = n, .x = x, .y = y + DEVIATION * d->rows, .points = 1};
    plot.name = m->of_deviation;
    plot.title = m->title_of_deviation;
    plot.curves = n > 1;
    plot.log_y = 0; /* it may vanish */
    postproc_charts_add(charts, &plot);
}

void postproc_charts_texture_draw(struct postproc_charts *charts, const struct postproc_history *h,
                                  const char *folder) {
    static const struct measure measure[] = {
        {"porosity", "rev_porosity", "Porosity of sub-volumes", "rev_porosity_deviation",
         "Deviation of the porosity of sub-volumes", "porosity", 0, NULL, NULL},
        {"carman", "rev_permeability", "Permeability of sub-volumes by Kozeny and Carman", "rev_permeability_deviation",
         "Deviation of the permeability of sub-volumes by Kozeny and Carman", "{/Symbol f}^3/(5 S^2)  [m^2]", 1,
         "permeability", "k measured in the box"}};
    struct slices s;
    slices_read(&s, h);
    if (s.times) slices_draw(charts, h, folder, &s);
    for (size_t k = 0; h->rev && k < sizeof measure / sizeof *measure; k++)
        measure_draw(charts, h, folder, &measure[k]);
}
