/* Taylor and Green's vortices along all axes, which deform: a flow without an exact solution, for orders in time. */
#pragma once
#include "tests/check.h"
#include "tests/fluid/fluid_case.h"

enum { VORTICES = 16, VORTICES_CELLS = VORTICES * VORTICES * VORTICES, VORTICES_VALUES = 3 * VORTICES_CELLS };

/* in: what differs from the default. */
static inline struct fluid *vortices_new(struct fluid_input in) {
    in.density = 2;
    in.viscosity = 0.02;
    in.vortices.velocity = 1;
    for (int d = 0; d < 3; d++) {
        in.n[d] = VORTICES;
        in.length[d] = 2 * M_PI;
        in.vortices.along[d] = 1;
    }
    return fluid_new(&in);
}

/* The velocity on every rank, u [VORTICES_VALUES]. */
static inline void vortices_gather(struct fluid *f, double *u) {
    const struct fluid_grid *g = fluid_grid_of(f);
    memset(u, 0, VORTICES_VALUES * sizeof *u);
    for (int c = 0; c < 3; c++)
        for (int k = 0; k < g->m[2]; k++)
            for (int j = 0; j < g->m[1]; j++)
                for (int i = 0; i < g->m[0]; i++)
                    u[((c * VORTICES + k + g->lo[2]) * VORTICES + j + g->lo[1]) * VORTICES + i] =
                        component(f, c)[fluid_grid_at(g, i, j, k)];
    par_sum_array(u, VORTICES_VALUES);
}

static inline double vortices_distance(const double *a, const double *b) {
    double worst = 0;
    for (int i = 0; i < VORTICES_VALUES; i++) worst = check_worst(worst, a[i] - b[i]);
    return worst;
}
