/* Integral measures of the flow: divergence, energy, bulk velocity, mean pressure, momentum. */
#include "base/par.h"
#include "base/par_halo.h"
#include "fluid/grid/boundary.h"
#include "fluid/internal.h"
#include "fluid/momentum/momentum.h"
#include "fluid/poisson/poisson.h"

#include <math.h>
#include <string.h>

static double cell_volume(const struct fluid_grid *g) { return g->d[0] * g->d[1] * g->d[2]; }

/* The largest divergence in plane k, INFINITY if one is NaN. */
static double divergence_max_in(struct fluid *f, int k) {
    const struct fluid_grid *g = f->grid;
    const double *const q[3] = {f->state.u, f->state.v, f->state.w};
    double *plane = fluid_poisson_plane(f->poisson, k); /* scratch between steps */
    double most = 0, lost = 0; /* lost: NaN if a value is no finite number, which `most` does not show */
    fluid_momentum_kernels_divergence(g, k, 1, q, plane);
    if (f->source) fluid_volume_source_subtract(f, k, 1, plane);
#pragma omp simd reduction(max : most) reduction(+ : lost)
    for (int n = 0; n < g->m[0] * g->m[1]; n++) {
        most = fabs(plane[n]) > most ? fabs(plane[n]) : most;
        lost += 0 * plane[n];
    }
    return lost == 0 ? most : INFINITY;
}

double fluid_measures_divergence_max(struct fluid *f) {
    double most = 0;
    for (int k = 0; k < f->grid->m[2]; k++) most = fmax(most, divergence_max_in(f, k));
    return par_max(most);
}

/* Half the sum over the cells of plane k of (low face^power + high face^power) of a component. */
static double sum_of_faces(const struct fluid *f, int c, int squared, int k) {
    const struct fluid_grid *g = f->grid;
    const ptrdiff_t s = fluid_boundary_stride(g, c);
    double sum = 0;
    for (int j = 0; j < g->m[1]; j++) {
        const double *q = fluid_component(&f->state, c) + fluid_grid_at(g, 0, j, k);
        double part = 0;
#pragma omp simd reduction(+ : part)
        for (int i = 0; i < g->m[0]; i++) part += squared ? q[i] * q[i] + q[i - s] * q[i - s] : q[i] + q[i - s];
        sum += part;
    }
    return 0.5 * sum;
}

double fluid_measures_bulk_velocity(struct fluid *f, int direction) {
    double sum = 0;
    for (int k = 0; k < f->grid->m[2]; k++) sum += sum_of_faces(f, direction, 0, k);
    return par_sum(sum) / (double)fluid_grid_cells(f->grid);
}

/* This rank's share of the kinetic energy in plane k, J. */
static double kinetic_energy_in(const struct fluid *f, int k) {
    const double sum = sum_of_faces(f, 0, 1, k) + sum_of_faces(f, 1, 1, k) + sum_of_faces(f, 2, 1, k);
    return 0.5 * f->in.density * cell_volume(f->grid) * sum;
}

double fluid_measures_kinetic_energy(struct fluid *f) {
    double sum = 0;
    for (int k = 0; k < f->grid->m[2]; k++) sum += kinetic_energy_in(f, k);
    return par_sum(sum);
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

/* The momentum along c in plane k, kg m/s. */
static double momentum_in(const struct fluid *f, int c, int k) {
    int low[3], high[3];
    double sum = 0;
    fluid_boundary_advanced(f->boundary, f->grid, c, low, high);
    for (int j = low[1]; j < high[1] && k >= low[2] && k < high[2]; j++) {
        const double *q = fluid_component(&f->state, c) + fluid_grid_at(f->grid, 0, j, k);
        double part = 0;
#pragma omp simd reduction(+ : part)
        for (int i = low[0]; i < high[0]; i++) part += q[i];
        sum += part;
    }
    return f->in.density * cell_volume(f->grid) * sum;
}

void fluid_measures_momentum(struct fluid *f, double out[3]) {
    for (int c = 0; c < 3; c++) {
        out[c] = 0;
        for (int k = 0; k < f->grid->m[2]; k++) out[c] += momentum_in(f, c, k);
    }
    par_sum_array(out, 3);
}

/* Each plane is read while it is in the cache; dissipation looks at one plane more (fluid_dissipation_in). */
struct fluid_measures fluid_measures_of(struct fluid *f) {
    const int planes = f->grid->m[2];
    double most[2] = {0}, sum[6] = {0};
    for (int k = 0; k <= planes; k++) {
        sum[2] += fluid_dissipation_in(f, k);
        if (k == planes) break;
        most[0] = fmax(most[0], divergence_max_in(f, k));
        most[1] = fmax(most[1], fluid_limits_convection_rate_in(f, k, NULL));
        sum[0] += sum_of_faces(f, 0, 0, k);
        sum[1] += kinetic_energy_in(f, k);
        for (int c = 0; c < 3; c++) sum[3 + c] += momentum_in(f, c, k);
    }
    par_max_array(most, 2);
    par_sum_array(sum, 6);
    return (struct fluid_measures){.divergence_max = most[0],
                                   .convection_rate = most[1],
                                   .bulk_velocity = sum[0] / (double)fluid_grid_cells(f->grid),
                                   .kinetic_energy = sum[1],
                                   .dissipation = sum[2],
                                   .momentum = {sum[3], sum[4], sum[5]}};
}
