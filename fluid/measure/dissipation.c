/* Viscous dissipation of kinetic energy, consistent with the discrete equations. */
/* Kinetic energy lost to viscosity: q times nu lap q, summed by parts over the advanced faces,
 *     epsilon = rho nu V sum_c sum_d w ((q_c(+1) - q_c)/d_d)^2,
 * over the pairs of neighbours along d. w = 1/2 for a pair across a side, whose other end is a ghost: half a cell
 * belongs to such a pair. */
#include "base/vec.h"
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

/* The sums of a plane's rows with all three pairs, a vec of cells at a time; beyond a row's end differences count as 0.
 */
struct squares {
    vec x, y, z;
};

static inline __attribute__((always_inline)) void add_row(const double *q, const struct fluid_grid *g, int n,
                                                          double in_y, struct squares *sum) {
    for (int i = 0; i < n; i += VEC_LANES) {
        const unsigned in = vec_first(n - i);
        const vec here = vec_load(q + i);
        const vec dx = vec_where(in, here - vec_load(q + i - 1)), dy = vec_where(in, here - vec_load(q + i - g->row)),
                  dz = vec_where(in, here - vec_load(q + i - g->plane));
        sum->x += dx * dx;
        sum->y += in_y * dy * dy;
        sum->z += dz * dz;
    }
}

/* Squared differences of component c between neighbours along the three directions, each over d squared, with the
 * higher end in plane k of this rank, 1/s2. A pair belongs to the rank that has its higher end; a pair across a high
 * side belongs to the rank at that side. Along the component's own direction the neighbours are the faces of a cell,
 * all inside; across a side else, a value and its ghost. */
static double sum_of_squares(const struct fluid *f, int c, int k) {
    const struct fluid_grid *g = f->grid;
    const ptrdiff_t row = g->row, plane = g->plane;
    int low[3], high[3], end[3]; /* faces that are advanced; end: one behind the last pair along each direction */
    double x = 0, y = 0, z = 0;
    struct squares most = {vec_set(0), vec_set(0), vec_set(0)};
    fluid_boundary_advanced(f->boundary, f->grid, c, low, high);
    for (int d = 0; d < 3; d++) end[d] = g->m[d] + (c != d && f->boundary->side[d][1].here);
    const int in_z = k >= low[2] && k < high[2], has_z = k >= 0 && k < end[2];
    const double less[2] = {1 - weight_of(f, c, 0, 0), 1 - weight_of(f, c, 0, end[0] - 1)}; /* at a row's two ends */
    for (int j = low[1]; j < end[1]; j++) {
        const double *q = fluid_component(&f->state, c) + fluid_grid_at(g, 0, j, k);
        const int in_y = j < high[1], has_y = j >= 0;
        const double in_row = weight_of(f, c, 1, j);
        if (in_y && in_z && has_y && has_z) { /* most rows: the cells with all three pairs first */
            add_row(q, g, high[0], in_row, &most);
            for (int i = high[0]; i < end[0]; i++) x += (q[i] - q[i - 1]) * (q[i] - q[i - 1]);
            for (int i = low[0]; i < 0; i++) {
                y += in_row * (q[i] - q[i - row]) * (q[i] - q[i - row]);
                z += (q[i] - q[i - plane]) * (q[i] - q[i - plane]);
            }
        } else {
            if (in_y && in_z) x += squares(q, 1, 0, end[0]);
            if (in_z && has_y) y += in_row * squares(q, row, low[0], high[0]);
            if (in_y && has_z) z += squares(q, plane, low[0], high[0]);
        }
        for (int e = 0; in_y && in_z && e < (end[0] > 1 ? 2 : 1); e++) {
            const double *at = q + (e ? end[0] - 1 : 0);
            x -= less[e] * (at[0] - at[-1]) * (at[0] - at[-1]);
        }
    }
    x += vec_sum(most.x);
    y += vec_sum(most.y);
    z += vec_sum(most.z);
    return x / (g->d[0] * g->d[0]) + y / (g->d[1] * g->d[1]) + weight_of(f, c, 2, k) * z / (g->d[2] * g->d[2]);
}

double fluid_dissipation_in(const struct fluid *f, int k) {
    const struct fluid_grid *g = f->grid;
    double sum = 0;
    for (int c = 0; c < 3; c++) sum += sum_of_squares(f, c, k);
    return f->in.density * f->in.viscosity * g->d[0] * g->d[1] * g->d[2] * sum;
}
