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

double fluid_measures_divergence_max(struct fluid *f) {
    const struct fluid_grid *g = f->grid;
    const double *const q[3] = {f->state.u, f->state.v, f->state.w};
    double most = 0;
    for (int k = 0; k < g->m[2]; k++) {
        double *plane = fluid_poisson_plane(f->poisson, k); /* scratch between steps */
        fluid_momentum_kernels_divergence(g, k, 1, q, plane);
        if (f->source) fluid_volume_source_subtract(f, k, 1, plane);
        double lost = 0; /* NaN if a value is no finite number, which `most` does not show */
#pragma omp simd reduction(max : most) reduction(+ : lost)
        for (int n = 0; n < g->m[0] * g->m[1]; n++) {
            most = fabs(plane[n]) > most ? fabs(plane[n]) : most;
            lost += 0 * plane[n];
        }
        if (!(lost == 0)) most = INFINITY;
    }
    return par_max(most);
}

/* Half the sum over cells of (low face^power + high face^power) of a component. */
static double sum_of_faces(const struct fluid *f, int c, int squared) {
    const struct fluid_grid *g = f->grid;
    const ptrdiff_t s = fluid_boundary_stride(g, c);
    double sum = 0;
    for (int k = 0; k < g->m[2]; k++)
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
    return par_sum(sum_of_faces(f, direction, 0)) / (double)fluid_grid_cells(f->grid);
}

double fluid_measures_kinetic_energy(struct fluid *f) {
    const double sum = sum_of_faces(f, 0, 1) + sum_of_faces(f, 1, 1) + sum_of_faces(f, 2, 1);
    return 0.5 * f->in.density * cell_volume(f->grid) * par_sum(sum);
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

void fluid_measures_momentum(struct fluid *f, double out[3]) {
    const struct fluid_grid *g = f->grid;
    for (int c = 0; c < 3; c++) {
        int low[3], high[3];
        fluid_boundary_advanced(f->boundary, f->grid, c, low, high);
        out[c] = 0;
        for (int k = low[2]; k < high[2]; k++)
            for (int j = low[1]; j < high[1]; j++) {
                const double *q = fluid_component(&f->state, c) + fluid_grid_at(g, 0, j, k);
                double part = 0;
#pragma omp simd reduction(+ : part)
                for (int i = low[0]; i < high[0]; i++) part += q[i];
                out[c] += part;
            }
        out[c] *= f->in.density * cell_volume(g);
    }
    par_sum_array(out, 3);
}
