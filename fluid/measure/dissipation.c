/* Viscous dissipation of kinetic energy, consistent with the discrete equations. */
/* Kinetic energy lost to viscosity: q times nu lap q, summed by parts over the advanced faces,
 *     epsilon = rho nu V sum_c sum_d w ((q_c(+1) - q_c)/d_d)^2,
 * over the pairs of neighbours along d. w = 1/2 for a pair across a side, whose other end is a ghost: half a cell
 * belongs to such a pair. */
#include "base/par.h"
#include "fluid/grid/boundary.h"
#include "fluid/internal.h"

/* Squared differences of component c between neighbours along d, with the higher end in plane k of this rank, m2/s2. A
 * pair belongs to the rank that has its higher end; a pair across a high side belongs to the rank at that side. c == d:
 * the neighbours are the faces of a cell, all inside. c != d: across a side, the neighbours are a value and its
 * ghost. */
static double sum_of_squares(const struct fluid *f, int c, int d, int k) {
    const struct fluid_grid *g = f->grid;
    const ptrdiff_t s = fluid_boundary_stride(g, d);
    const struct fluid_boundary_side *side = f->boundary->side[d];
    const int sides = c != d, first = 0, last = g->m[d] - 1 + (sides && side[1].here);
    int low[3], high[3];
    double sum = 0;
    fluid_boundary_advanced(f->boundary, f->grid, c, low, high);
    low[d] = first;
    high[d] = last + 1;
    for (int j = low[1]; j < high[1] && k >= low[2] && k < high[2]; j++) {
        const double *q = fluid_component(&f->state, c) + fluid_grid_at(g, 0, j, k);
        const int at = d == 1 ? j : k;
        double part = 0;
#pragma omp simd reduction(+ : part)
        for (int i = low[0]; i < high[0]; i++) {
            const double step = q[i] - q[i - s];
            part += step * step;
        }
        if (sides && d == 0) { /* the two ends of the row */
            const double left = q[0] - q[-1], right = q[last] - q[last - 1];
            part -= 0.5 * ((side[0].here ? left * left : 0) + (side[1].here ? right * right : 0));
        } else if (sides && ((at == first && side[0].here) || (at == last && side[1].here))) {
            part *= 0.5;
        }
        sum += part;
    }
    return sum;
}

double fluid_dissipation_in(const struct fluid *f, int k) {
    const struct fluid_grid *g = f->grid;
    double sum = 0;
    for (int c = 0; c < 3; c++)
        for (int d = 0; d < 3; d++) sum += sum_of_squares(f, c, d, k) / (g->d[d] * g->d[d]);
    return f->in.density * f->in.viscosity * g->d[0] * g->d[1] * g->d[2] * sum;
}

double fluid_dissipation(struct fluid *f) {
    double sum = 0;
    for (int k = 0; k <= f->grid->m[2]; k++) sum += fluid_dissipation_in(f, k);
    return par_sum(sum);
}
