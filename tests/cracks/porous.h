/* Porous plates for tests: columns under a load, their modulus, their pressures. */
#pragma once
#include "tests/cracks/make.h"

/* A column of n layers, periodic in x, with equal loads, Pa, on `deep` layers at both ends that press it together. */
static inline struct solid *porous_column(int n, double load, int deep) {
    const double h = SPACING, force = load / (deep * h);
    const struct solid_load end[2] = {
        {.kind = SOLID_LOAD_REGION, .high = {1, deep * h, 1}, .force = {0, force, 0}},
        {.kind = SOLID_LOAD_REGION, .low = {0, (n - deep) * h, 0}, .high = {1, n * h, 1}, .force = {0, -force, 0}}};
    return make((struct make){.sites = {8, n, 0}, .periodic = 2, .loads = 2, .load = end});
}

/* A substep well below the stable one. */
static inline double porous_dt(void) { return 0.5 * SPACING / sqrt(YOUNG / DENSITY); }

/* Critical for the lowest mode of a column that is free at both ends, 1/s. */
static inline double porous_damping(int n) { return 2 * acos(-1) * sqrt(1.2 * YOUNG / DENSITY) / (n * SPACING); }

/* The lattice's modulus of compression along y without strain along x, from the bonds of a particle in its
 * middle:
 *     K = 1/2 sum of alpha c Gamma V xi_y^4/|xi|^3 */
static inline double porous_confined(const struct solid *s) {
    static struct solid_family_view view;
    double most = 0;
    for (int h = 0; h < s->n; h++) {
        const double *high = s->in.body[0].high;
        if (fmax(fabs(s->x0[0][h] - 0.5 * high[0]), fabs(s->x0[1][h] - 0.5 * high[1])) > 0.75 * SPACING) continue;
        double sum = 0;
        solid_family_view(s, h, &view);
        for (int b = 0; b < view.n; b++) {
            const double *xi = view.xi[b], length = sqrt(xi[0] * xi[0] + xi[1] * xi[1] + xi[2] * xi[2]);
            sum += 0.5 * view.alpha[b] * view.micro[b] * view.weight[b] * pow(xi[1], 4) / pow(length, 3);
        }
        most = fmax(most, sum);
    }
    par_max_array(&most, 1);
    return most;
}

/* The mean pressure of a layer along x. */
static inline double porous_pressure(const struct cracks *c, int layer) {
    double sum[2] = {0, 0};
    for (int i = 0; i < c->struts.n; i++) {
        if ((int)floor(c->solid->x0[1][c->struts.h[i]] / SPACING) != layer) continue;
        sum[0] += c->p[i];
        sum[1]++;
    }
    par_sum_array(sum, 2);
    return sum[0] / sum[1];
}
