/* Divergence and correction of one plane: exact for linear fields, and adjoint to each other. */
#include "base/par_halo.h"
#include "fluid/momentum/momentum.h"
#include "tests/fluid/fluid_case.h"

#include <stdlib.h>

enum { NX = 7, NY = 5, NZ = 6 };

static struct fluid_grid *grid(int periodic) {
    return fluid_grid_new((int[]){NX, NY, NZ}, (double[]){0.7, 1.5, 2.4}, (int[]){periodic, periodic, periodic}, 1,
                          NULL);
}

static double *array(const struct fluid_grid *g) { return calloc(g->size, sizeof(double)); }

/* The divergence of (2x - y, 3y + z, -4z + x) is 1 everywhere. */
static void divergence_of_a_linear_field(void **state) {
    (void)state;
    struct fluid_grid *g = grid(0);
    double *q[3] = {array(g), array(g), array(g)}, rhs[NX * NY];
    for (int k = -1; k < NZ; k++)
        for (int j = -1; j < NY; j++)
            for (int i = -1; i < NX; i++) {
                const size_t n = fluid_grid_at(g, i, j, k);
                const double x = (i + 0.5) * g->d[0], y = (j + 0.5) * g->d[1], z = (k + 0.5) * g->d[2];
                q[0][n] = 2 * (x + g->d[0] / 2) - y; /* each on its own face */
                q[1][n] = 3 * (y + g->d[1] / 2) + z;
                q[2][n] = -4 * (z + g->d[2] / 2) + x;
            }
    for (int k = 0; k < NZ; k++) {
        fluid_momentum_kernels_divergence(g, k, 5, (const double *const *)q, rhs);
        for (int n = 0; n < NX * NY; n++) check_close(rhs[n], 5, 1e-12);
    }
    for (int c = 0; c < 3; c++) free(q[c]);
    fluid_grid_free(g);
}

/* q = predicted - c grad phi + shift, p += share (pi + phi), pi += w phi, for phi = x - 2y + 3z: into other arrays,
 * with p from 0 on; in place; in place with p the same array as pi. */
static void correction_by_a_linear_field(void **state) {
    (void)state;
    struct fluid_grid *g = grid(0);
    const double c = 0.3, shift[3] = {10, 20, 30}, gradient[3] = {1, -2, 3};
    double *p = array(g), *pi = array(g), *phi = array(g), *predicted[3], *q[3];
    const struct fluid_momentum_pressure pressure[3] = {{p, pi, 0.25, 0.4, 1}, {p, pi, 0.5, 0.6, 0}, {pi, pi, 1, 1, 0}};
    for (int d = 0; d < 3; d++) predicted[d] = array(g), q[d] = array(g);
    for (int k = 0; k <= NZ; k++)
        for (int j = 0; j <= NY; j++)
            for (int i = 0; i <= NX; i++) {
                const size_t n = fluid_grid_at(g, i, j, k);
                phi[n] = i * g->d[0] - 2 * j * g->d[1] + 3 * k * g->d[2];
                pi[n] = random_at(3, i, j, k);
                p[n] = 1e3; /* of the step before */
                for (int d = 0; d < 3; d++) predicted[d][n] = random_at(d, i, j, k);
            }
    for (int turn = 0; turn < 3; turn++)
        for (int k = 0; k < NZ; k++)
            fluid_momentum_kernels_correct(g, k, c, shift, phi + fluid_grid_at(g, 0, 0, k),
                                           phi + fluid_grid_at(g, 0, 0, k + 1), predicted, turn ? predicted : q,
                                           &pressure[turn]);
    for (int k = 0; k < NZ; k++)
        for (int j = 0; j < NY; j++)
            for (int i = 0; i < NX; i++) {
                const size_t n = fluid_grid_at(g, i, j, k);
                check_close(p[n], random_at(3, i, j, k) + (0.4 + 0.6 * 1.25) * phi[n], 1e-13);
                check_close(pi[n], random_at(3, i, j, k) + 1.75 * phi[n], 1e-13);
                for (int d = 0; d < 3; d++) {
                    const double change = shift[d] - c * gradient[d];
                    check_close(q[d][n], random_at(d, i, j, k) + change, 1e-13);
                    check_close(predicted[d][n], q[d][n] + change, 1e-13); /* it was corrected twice */
                }
            }
    for (int d = 0; d < 3; d++) free(predicted[d]), free(q[d]);
    free(phi);
    free(pi);
    free(p);
    fluid_grid_free(g);
}

/* In a periodic box sum phi div q = - sum q . grad phi for any q and phi. */
static void divergence_and_gradient_are_adjoint(void **state) {
    (void)state;
    struct fluid_grid *g = grid(1);
    const double none[3] = {0, 0, 0};
    double *phi = array(g), *p = array(g), *q[3], *zero[3], *gradient[3], rhs[NX * NY];
    const struct fluid_momentum_pressure pressure = {p, p, 1, 1, 1};
    for (int d = 0; d < 3; d++) q[d] = array(g), zero[d] = array(g), gradient[d] = array(g);
    for (int k = 0; k < NZ; k++)
        for (int j = 0; j < NY; j++)
            for (int i = 0; i < NX; i++) {
                const size_t n = fluid_grid_at(g, i, j, k);
                phi[n] = random_at(3, i, j, k);
                for (int d = 0; d < 3; d++) q[d][n] = random_at(d, i, j, k);
            }
    par_halo_fill(g->halos, 3, q, 1);
    par_halo_fill(g->halos, 1, &phi, 1);
    double left = 0, right = 0, size = 0;
    for (int k = 0; k < NZ; k++) {
        fluid_momentum_kernels_divergence(g, k, 1, (const double *const *)q, rhs);
        fluid_momentum_kernels_correct(g, k, -1, none, phi + fluid_grid_at(g, 0, 0, k),
                                       phi + fluid_grid_at(g, 0, 0, k + 1), zero, gradient, &pressure);
        for (int j = 0; j < NY; j++)
            for (int i = 0; i < NX; i++) {
                const size_t n = fluid_grid_at(g, i, j, k);
                left += phi[n] * rhs[j * NX + i];
                size += fabs(phi[n] * rhs[j * NX + i]);
                for (int d = 0; d < 3; d++) right += q[d][n] * gradient[d][n];
            }
    }
    check_above(fabs(left), 1e-3 * size);
    check_close(left, -right, 1e-13 * size);
    for (int d = 0; d < 3; d++) free(q[d]), free(zero[d]), free(gradient[d]);
    free(phi);
    free(p);
    fluid_grid_free(g);
}

FLUID_TEST_MAIN(cmocka_unit_test(divergence_of_a_linear_field), cmocka_unit_test(correction_by_a_linear_field),
                cmocka_unit_test(divergence_and_gradient_are_adjoint))
