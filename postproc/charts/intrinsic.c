/* Draws intrinsic.csv: the intrinsic permeability along the axes over time, beside the apparent one. */
#include "postproc/charts/charts.h"
#include "physics/darcy.h"
#include "scene/medium.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { CURVES = 4, TITLE = 64 };
#define OF_ROCK 1e-9 /* m2: smaller ones are given in mD */

/* A column over the time of the plots; returns how many of its values are known. */
static long curve_new(struct postproc_curve *curve, const struct postproc_history *h, const struct table_data *d,
                      const char *column) {
    double *x = postproc_history_values(d, "t"), *y = postproc_history_values(d, column);
    long known = 0, n = x && y ? d->rows : 0;
    for (long i = 0; i < n; i++) {
        x[i] = postproc_history_when(h, x[i]);
        if (!isfinite(y[i])) y[i] = NAN; /* nothing resists the flow */
        known += isfinite(y[i]) != 0;
    }
    curve->n = n;
    curve->x = x;
    curve->y = y;
    return known;
}

static double largest_of(const struct postproc_curve *curve, int curves) {
    double largest = 0;
    for (int k = 0; k < curves; k++)
        for (long i = 0; i < curve[k].n; i++) largest = fmax(largest, curve[k].y[i]); /* NaN is left out */
    return largest;
}

/* The direction of the apparent permeability. */
static void apparent_title(char title[TITLE], const struct postproc_history *h) {
    struct scene_medium m;
    int axis = -1, parts = 0;
    if (h->scene->coupling && h->scene->fluid) {
        scene_medium_of(h->scene, &m);
        for (int c = 0; c < 3; c++)
            if (m.along[c] != 0) axis = c, parts++;
    }
    if (parts == 1)
        snprintf(title, TITLE, "apparent, along %c", "xyz"[axis]);
    else
        snprintf(title, TITLE, "apparent");
}

void postproc_charts_intrinsic_draw(struct postproc_charts *charts, const struct postproc_history *h,
                                    const char *folder) {
    static const char *const column[CURVES] = {"apparent", "k_xx", "k_yy", "k_zz"};
    static const struct postproc_mark origin = {0, ""};
    struct postproc_curve curve[CURVES];
    char title[CURVES][TITLE] = {"", "intrinsic, along x", "intrinsic, along y", "intrinsic, along z"};
    int curves = 0;
    double first = INFINITY, last = -INFINITY;
    if (!h->intrinsic) return;
    apparent_title(title[0], h);
    for (int k = 0; k < CURVES; k++) {
        struct postproc_curve *c = &curve[curves];
        *c = (struct postproc_curve){.title = title[k], .points = k > 0};
        if (curve_new(c, h, h->intrinsic, column[k]) < 2) continue;
        curves++;
        const double span = c->x[c->n - 1] > 0 ? c->x[c->n - 1] : INFINITY; /* before time 0, as in the other plots */
        first = fmin(first, fmax(c->x[0], -0.25 * span));
        last = fmax(last, c->x[c->n - 1]);
    }
    const int of_rock = largest_of(curve, curves) < OF_ROCK;
    for (int k = 0; of_rock && k < curves; k++)
        for (long i = 0; i < curve[k].n; i++) ((double *)(size_t)curve[k].y)[i] *= 1e3 / PHYSICS_DARCY;
    postproc_charts_add(charts,
                        &(struct postproc_plot){.folder = folder,
                                                .name = "permeability_intrinsic",
                                                .title = "Permeability of the medium: of the flow, and intrinsic",
                                                .xlabel = postproc_history_when_name(h),
                                                .ylabel = of_rock ? "k  [mD]" : "k  [m^2]",
                                                .curves = curves,
                                                .curve = curve,
                                                .marks = h->origin > 0,
                                                .mark = &origin,
                                                .x_low = first,
                                                .x_high = last});
}
