/* Viscous dissipation of kinetic energy, consistent with the discrete equations. */
/* Kinetic energy lost to viscosity: q times nu lap q, summed by parts over the advanced faces,
 *     epsilon = rho nu V sum_c sum_d w ((q_c(+1) - q_c)/d_d)^2,
 * over the pairs of neighbours along d. w = 1/2 for a pair across a side, whose other end is a ghost: half a cell
 * belongs to such a pair. */
#include "base/par.h"
#include "fluid/grid/boundary.h"
#include "fluid/internal.h"

/* Weight of the pair whose higher end has the index `at` along d: 1/2 across a side. */
static double weight_of(const struct fluid *f, int c, int d, int at) {
    const struct fluid_boundary_side *side = f->boundary->side[d];
    return c != d && ((at == 0 && side[0].here) || (at == f->grid->m[d] && side[1].here)) ? 0.5 : 1;
}

static double squares(const double *q, ptrdiff_t s, int from, int to) {
    double sum = 0;
#pragma omp simd reduction(+ : sum)
    for (int i = from; i < to; i++) sum += (q[i] - q[i - s]) * (q[i] - q[i - s]);
    return sum;
}

/* Squared differences of component c between neighbours along the three directions, each over d squared, with the
 * higher end in plane k of this rank, 1/s2. A pair belongs to the rank that has its higher end; a pair across a high
 * side belongs to the rank at that side. Along the component's own direction the neighbours are the faces of a cell,
 * all inside; across a side else, a value and its ghost. */
static double sum_of_squares(const struct fluid *f, int c, int k) {
    const struct fluid_grid *g = f->grid;
    const ptrdiff_t row = g->row, plane = g->plane;
    int low[3], high[3], end[3]; /* faces that are advanced; end: one behind the last pair along each direction */
    double per[3], sum = 0;
    fluid_boundary_advanced(f->boundary, f->grid, c, low, high);
    for (int d = 0; d < 3; d++) {
        end[d] = g->m[d] + (c != d && f->boundary->side[d][1].here);
        per[d] = 1 / (g->d[d] * g->d[d]);
    }
    const int in_z = k >= low[2] && k < high[2], has_z = k >= 0 && k < end[2];
    for (int j = low[1]; j < end[1]; j++) {
        const double *q = fluid_component(&f->state, c) + fluid_grid_at(g, 0, j, k);
        const int in_y = j < high[1], has_y = j >= 0;
        double x = 0, y = 0, z = 0;
        if (in_y && in_z && has_y && has_z) { /* most rows: the cells with all three pairs first */
#pragma omp simd reduction(+ : x, y, z)
            for (int i = 0; i < high[0]; i++) {
                const double dx = q[i] - q[i - 1], dy = q[i] - q[i - row], dz = q[i] - q[i - plane];
                x += dx * dx;
                y += dy * dy;
                z += dz * dz;
            }
            x += squares(q, 1, high[0], end[0]);
            y += squares(q, row, low[0], 0);
            z += squares(q, plane, low[0], 0);
        } else {
            if (in_y && in_z) x = squares(q, 1, 0, end[0]);
            if (in_z && has_y) y = squares(q, row, low[0], high[0]);
            if (in_y && has_z) z = squares(q, plane, low[0], high[0]);
        }
        for (int i = 0; in_y && in_z && i<end[0]; i += end[0]> 1 ? end[0] - 1 : 1) /* the two ends of the row */
            x -= (1 - weight_of(f, c, 0, i)) * squares(q, 1, i, i + 1);
        sum += per[0] * x + per[1] * weight_of(f, c, 1, j) * y + per[2] * weight_of(f, c, 2, k) * z;
    }
    return sum;
}

double fluid_dissipation_in(const struct fluid *f, int k) {
    const struct fluid_grid *g = f->grid;
    double sum = 0;
    for (int c = 0; c < 3; c++) sum += sum_of_squares(f, c, k);
    return f->in.density * f->in.viscosity * g->d[0] * g->d[1] * g->d[2] * sum;
}

double fluid_dissipation(struct fluid *f) {
    double sum = 0;
    for (int k = -1; k <= f->grid->m[2]; k++) sum += fluid_dissipation_in(f, k);
    return par_sum(sum);
}
