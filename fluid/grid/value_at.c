/* Velocity and pressure at a point by linear interpolation. */
#include "base/memory.h"
#include "base/par.h"
#include "fluid/internal.h"

#include <math.h>
#include <string.h>

void fluid_value_at(struct fluid *f, const double x[3], double value[4]) {
    const struct fluid_grid *g = f->grid;
    for (int q = 0; q < 4; q++) value[q] = 0;
    if (fluid_grid_rank_of(g, x) != par_rank()) return;
    for (int q = 0; q < 4; q++) {
        const double *field = q < 3 ? fluid_component(&f->state, q) : f->state.p;
        double part[3];
        int low[3];
        for (int d = 0; d < 3; d++) {
            double at = x[d] / g->d[d];
            if (g->periodic[d]) at -= g->n[d] * floor(at / g->n[d]);
            at -= g->lo[d] + (q == d ? 1.0 : 0.5);
            low[d] = (int)fmin(floor(at), g->m[d] - 1 - (q == d)); /* a point on the domain's far end */
            part[d] = at - low[d];
        }
        for (int corner = 0; corner < 8; corner++) {
            const int up[3] = {corner & 1, corner >> 1 & 1, corner >> 2};
            double weight = 1;
            for (int d = 0; d < 3; d++) weight *= up[d] ? part[d] : 1 - part[d];
            value[q] += weight * field[fluid_grid_at(g, low[0] + up[0], low[1] + up[1], low[2] + up[2])];
        }
    }
}

void fluid_value_at_points(struct fluid *f, int n, const double (*x)[3], double (*value)[4]) {
    double *const field[] = {f->state.u, f->state.v, f->state.w, f->state.p, f->state.pi};
    const int fields = f->state.pi == f->state.p ? 4 : 5;
    const size_t size = f->grid->size;
    double *kept = memory_new(MEMORY_FLUID, fields * size, sizeof *kept);
    for (int k = 0; k < fields; k++) memcpy(kept + k * size, field[k], size * sizeof *kept);
    fluid_state_refresh(f);
    for (int k = 0; k < n; k++) fluid_value_at(f, x[k], value[k]);
    for (int k = 0; k < fields; k++) memcpy(field[k], kept + k * size, size * sizeof *kept);
    memory_free(kept);
}
