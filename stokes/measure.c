/* Means over a box. */
#include "stokes/measure.h"
#include "base/par.h"

#include <math.h>
#include <string.h>

/* The part of cell i within low .. high. */
static double part_of(int i, double low, double high) { return fmax(0, fmin(high, i + 1) - fmax(low, i)); }

struct stokes_measure stokes_measure_box(const struct stokes *s, int axis, const double low[3], const double high[3]) {
    const struct stokes_cells *c = s->cells;
    double sum[4] = {0}, volume = 1;
    int at[3];
    for (int d = 0; d < 3; d++) volume *= high[d] - low[d];
    if (c->n > 0) stokes_mask_find(s->mask, c->first[par_rank()], at);
    for (int i = 0; i < c->n; i++) {
        double weight = 1, u[3];
        if (i > 0) stokes_mask_next(s->mask, at);
        for (int d = 0; d < 3; d++) {
            weight *= part_of(at[d] - (d == s->g.axis), low[d], high[d]);
            u[d] = 0.5 * (s->u[i][d] + s->u[c->next[i][2 * d]][d]);
        }
        if (stokes_grid_is_outside(&s->g, at)) continue;
        for (int d = 0; d < 3; d++) sum[d] += weight * u[d];
        sum[3] += weight * sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
    }
    par_sum_array(sum, 4);
    return (struct stokes_measure){{sum[0] / volume, sum[1] / volume, sum[2] / volume}, sum[3] / sum[axis]};
}

void stokes_measure_sections(const struct stokes *s, int axis, struct stokes_measure_section *section) {
    const struct stokes_cells *c = s->cells;
    const int layer = axis == s->g.axis, n = s->mask->n[axis] - 2 * layer;
    int at[3];
    memset(section, 0, (size_t)n * sizeof *section);
    if (c->n > 0) stokes_mask_find(s->mask, c->first[par_rank()], at);
    for (int i = 0; i < c->n; i++) {
        if (i > 0) stokes_mask_next(s->mask, at);
        if (stokes_grid_is_outside(&s->g, at)) continue;
        section[at[axis] - layer].p += s->p[i];
        section[at[axis] - layer].pores += 1;
    }
    par_sum_array(&section->p, 2 * n);
    for (int k = 0; k < n; k++)
        if (section[k].pores > 0) section[k].p /= section[k].pores;
}
