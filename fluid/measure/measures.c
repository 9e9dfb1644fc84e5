/* Integral measures of the flow: divergence, energy, bulk velocity, mean pressure, momentum. */
#include "base/par.h"
#include "base/par_halo.h"
#include "base/vec.h"
#include "fluid/grid/boundary.h"
#include "fluid/internal.h"
#include "fluid/measure/side_flux.h"
#include "fluid/momentum/momentum.h"
#include "fluid/poisson/poisson.h"

#include <math.h>
#include <string.h>

static double cell_volume(const struct fluid_grid *g) { return g->d[0] * g->d[1] * g->d[2]; }

/* Of the cells of a plane, from the faces of each; the low ones are u[-1], v[-row], w[-plane]. */
struct cells {
    double divergence;    /* largest |div u|, 1/s */
    double rate;          /* largest sum of |velocity|/d, the larger of both faces of each direction, 1/s */
    double flow, squares; /* half the sums of u, m/s, and of all squared velocities, m2/s2, over both faces */
};

/* The largest divergence in plane k less what enters at points, 1/s. */
static double divergence_beside_points(struct fluid *f, int k) {
    const struct fluid_grid *g = f->grid;
    const double *const q[3] = {f->state.u, f->state.v, f->state.w};
    double *plane = fluid_poisson_plane(f->poisson, k), most = 0; /* scratch between steps */
    fluid_momentum_kernels_divergence(g, k, 1, q, plane);
    fluid_volume_source_subtract(f, k, 1, plane);
    for (int n = 0; n < g->m[0] * g->m[1]; n++) most = fmax(most, fabs(plane[n]));
    return most;
}

/* A vec of cells at a time; beyond a row's end the velocity counts as 0. */
static struct cells cells_in(struct fluid *f, int k) {
    const struct fluid_grid *g = f->grid;
    const double x = 1 / g->d[0], y = 1 / g->d[1], z = 1 / g->d[2];
    vec divergence = vec_set(0), rate = vec_set(0), squares = vec_set(0), flow = vec_set(0);
    for (int j = 0; j < g->m[1]; j++) {
        const size_t n = fluid_grid_at(g, 0, j, k);
        const double *u = f->state.u + n, *v = f->state.v + n, *w = f->state.w + n;
        for (int i = 0; i < g->m[0]; i += VEC_LANES) {
            const unsigned in = vec_first(g->m[0] - i);
            const vec u1 = vec_where(in, vec_load(u + i)), u0 = vec_where(in, vec_load(u + i - 1));
            const vec v1 = vec_where(in, vec_load(v + i)), v0 = vec_where(in, vec_load(v + i - g->row));
            const vec w1 = vec_where(in, vec_load(w + i)), w0 = vec_where(in, vec_load(w + i - g->plane));
            divergence = vec_absmax(divergence, x * (u1 - u0) + y * (v1 - v0) + z * (w1 - w0));
            rate = vec_max(rate, x * vec_absmax(u1, u0) + y * vec_absmax(v1, v0) + z * vec_absmax(w1, w0));
            squares += (u1 * u1 + u0 * u0) + (v1 * v1 + v0 * v0) + (w1 * w1 + w0 * w0);
            flow += u1 + u0;
        }
    }
    struct cells c = {.divergence = vec_highest(divergence),
                      .rate = vec_highest(rate),
                      .flow = 0.5 * vec_sum(flow),
                      .squares = 0.5 * vec_sum(squares)};
    if (f->source) c.divergence = divergence_beside_points(f, k);
    if (!isfinite(c.squares)) c.divergence = c.rate = INFINITY; /* a NaN need not be a largest value */
    return c;
}

static double bulk_velocity(const struct fluid *f, double flow) { return flow / (double)fluid_grid_cells(f->grid); }

static double kinetic_energy(const struct fluid *f, double squares) {
    return 0.5 * f->in.density * cell_volume(f->grid) * squares;
}

double fluid_measures_kinetic_energy(struct fluid *f) {
    double squares = 0;
    for (int k = 0; k < f->grid->m[2]; k++) squares += cells_in(f, k).squares;
    return kinetic_energy(f, par_sum(squares));
}

void fluid_measures_mean_pressure(struct fluid *f, int direction, double *mean) {
    const struct fluid_grid *g = f->grid;
    const int n = g->n[direction];
    memset(mean, 0, (size_t)n * sizeof *mean);
    for (int k = 0; k < g->m[2]; k++)
        for (int j = 0; j < g->m[1]; j++) {
            const double *p = f->state.p + fluid_grid_at(g, 0, j, k);
            const int section = direction == 1 ? j + g->lo[1] : k + g->lo[2];
            for (int i = 0; i < g->m[0]; i++) mean[direction == 0 ? i : section] += p[i];
        }
    par_sum_array(mean, n);
    for (int i = 0; i < n; i++) mean[i] *= n / (double)fluid_grid_cells(f->grid);
}

/* 0, 1, 2, ... */
static vec lanes(void) {
    double number[VEC_LANES];
    for (int i = 0; i < VEC_LANES; i++) number[i] = i;
    return vec_load(number);
}

/* The momentum along c in plane k, kg m/s. Adds its moment about the domain's centre, kg m2/s, with each velocity at
 * the place of its face. */
static double momentum_in(const struct fluid *f, int c, int k, double angular[3]) {
    const struct fluid_grid *g = f->grid;
    const double mass = f->in.density * cell_volume(g);
    const int a = (c + 1) % 3, b = (c + 2) % 3;
    int low[3], high[3];
    vec sum = vec_set(0), along = vec_set(0), across = vec_set(0);
    fluid_boundary_advanced(f->boundary, g, c, low, high);
    if (k < low[2] || k >= high[2]) return 0;
    const vec number = lanes();
    for (int j = low[1]; j < high[1]; j++) {
        const double *q = fluid_component(&f->state, c) + fluid_grid_at(g, 0, j, k);
        const vec y = vec_set(fluid_side_flux_place(g, 1, c, j));
        for (int i = low[0]; i < high[0]; i += VEC_LANES) {
            const vec here = vec_where(vec_first(high[0] - i), vec_load(q + i));
            sum += here;
            along += (number + (double)i) * here;
            across += y * here;
        }
    }
    const double all = vec_sum(sum);
    const double moment[3] = {g->d[0] * vec_sum(along) + fluid_side_flux_place(g, 0, c, 0) * all, vec_sum(across),
                              fluid_side_flux_place(g, 2, c, k) * all};
    angular[a] += mass * moment[b];
    angular[b] -= mass * moment[a];
    return mass * all;
}

void fluid_measures_momentum(struct fluid *f, double momentum[3], double angular[3]) {
    double sum[6] = {0};
    for (int k = -1; k < f->grid->m[2]; k++)
        for (int c = 0; c < 3; c++) sum[c] += momentum_in(f, c, k, sum + 3);
    par_sum_array(sum, 6);
    if (momentum) memcpy(momentum, sum, 3 * sizeof *sum);
    if (angular) memcpy(angular, sum + 3, 3 * sizeof *sum);
}

/* Each plane is read while it is in the cache. A free face at a low side is in plane -1, and dissipation has pairs
 * across a high side. */
struct fluid_measures fluid_measures_of(struct fluid *f) {
    const int planes = f->grid->m[2];
    double most[2] = {0}, sum[9] = {0};
    for (int k = -1; k <= planes; k++) {
        sum[2] += fluid_dissipation_in(f, k);
        for (int d = 0; d < 3; d++) sum[3 + d] += momentum_in(f, d, k, sum + 6);
        if (k < 0 || k == planes) continue;
        const struct cells c = cells_in(f, k);
        most[0] = fmax(most[0], c.divergence);
        most[1] = fmax(most[1], c.rate);
        sum[0] += c.flow;
        sum[1] += c.squares;
    }
    par_max_array(most, 2);
    par_sum_array(sum, 9);
    return (struct fluid_measures){.divergence_max = most[0],
                                   .convection_rate = most[1],
                                   .bulk_velocity = bulk_velocity(f, sum[0]),
                                   .kinetic_energy = kinetic_energy(f, sum[1]),
                                   .dissipation = sum[2],
                                   .momentum = {sum[3], sum[4], sum[5]},
                                   .angular = {sum[6], sum[7], sum[8]}};
}
