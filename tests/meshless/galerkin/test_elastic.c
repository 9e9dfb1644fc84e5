/* Elasticity without a crack: patch test, a cantilever's order, the constraints against a null-space solution. */
#include "base/par.h"
#include "meshless/galerkin/assemble.h"
#include "meshless/galerkin/cells.h"
#include "meshless/galerkin/constraint.h"
#include "tests/meshless/galerkin/make.h"

#include <lapacke.h>
#include <stdlib.h>

static void linear(const double x[2], double u[2]) {
    u[0] = 0.3 + 1.1 * x[0] - 0.7 * x[1];
    u[1] = -0.2 + 0.4 * x[0] + 0.9 * x[1];
}

static double worst_of_linear(const struct galerkin *g) {
    static const double slope[2][2] = {{1.1, -0.7}, {0.4, 0.9}};
    unsigned seed = 11;
    double worst = 0;
    for (int k = 0; k < 200; k++) {
        const double x[2] = {2 * make_random(&seed), make_random(&seed)};
        struct galerkin_place at = {{x[0], x[1]}, {x[0], x[1]}};
        double u[2], grad[2][2], exact[2];
        linear(x, exact);
        meshless_field_at(g, &at, u, grad);
        for (int c = 0; c < 2; c++) {
            worst = check_worst(worst, u[c] - exact[c]);
            for (int d = 0; d < 2; d++) worst = check_worst(worst, 0.1 * (grad[c][d] - slope[c][d]));
        }
    }
    return worst;
}

/* A linear displacement on the whole outline, on a lattice and on disordered nodes, in both models, with few Gauss
 * points. */
static void patch(void **state) {
    (void)state;
    static const double corner[4][2] = {{0, 0}, {2, 0}, {2, 1}, {0, 1}};
    for (int disordered = 0; disordered < 2; disordered++)
        for (int strain = 0; strain < 2; strain++)
            for (int update = GALERKIN_CONJUGATE; update <= GALERKIN_HESTENES_POWELL; update++) {
                struct galerkin_input in = make_input(2, 1, 12);
                struct galerkin_fixed fix[4];
                unsigned seed = 5;
                struct meshless_nodes nodes = make_nodes(&in, 0, NULL);
                for (int i = 0; i < nodes.n && disordered; i++)
                    for (int c = 0; c < 2; c++) nodes.x[i][c] += 0.3 * in.spacing * (make_random(&seed) - 0.5);
                for (int k = 0; k < 4; k++) {
                    fix[k] = (struct galerkin_fixed){.direction = {1, 1}, .value = linear};
                    memcpy(fix[k].from, corner[k], sizeof corner[k]);
                    memcpy(fix[k].to, corner[(k + 1) % 4], sizeof corner[k]);
                }
                in.plane_strain = strain;
                in.poisson_ratio = strain ? 0.45 : 0;
                in.gauss = 2;
                in.fixed = 4;
                in.fix = fix;
                in.update = (enum galerkin_update)update;
                in.penalty = update ? 1e4 : 100;
                struct galerkin *g = meshless_galerkin_new(&in);
                meshless_galerkin_solve(g);
                assert_true(g->solution.converged);
                check_below(worst_of_linear(g), 1e-10);
                if (update == GALERKIN_HESTENES_POWELL && g->solution.iterations > 3)
                    for (int k = 1; k < 3; k++) /* each update reduces what is left */
                        check_below(g->solution.history[k], g->solution.history[k - 1]);
                meshless_galerkin_free(g);
                make_nodes_free(&nodes);
            }
}

/* A bar pulled at both ends: tractions of constant stress need no constraint but three, and stay exact. */
static void pulled(void **state) {
    (void)state;
    struct galerkin_input in = make_input(2, 1, 8);
    struct meshless_nodes nodes = make_nodes(&in, 0, NULL);
    struct galerkin_fixed fix[2] = {{.direction = {1, 1}}, {.from = {2, 0}, .to = {2, 0}, .direction = {0, 1}}};
    struct galerkin_pull pull[2] = {{.to = {0, 1}, .traction = {-5, 0}},
                                    {.from = {2, 0}, .to = {2, 1}, .traction = {5, 0}}};
    in.fixed = in.pulls = 2;
    in.fix = fix;
    in.pull = pull;
    struct galerkin *g = meshless_galerkin_new(&in);
    meshless_galerkin_solve(g);
    struct galerkin_place at = {{1.37, 0.41}, {1.37, 0.41}};
    double u[2], grad[2][2];
    meshless_field_at(g, &at, u, grad);
    check_close(u[0], 5e-3 * 1.37, 1e-12);
    check_close(u[1], -0.3 * 5e-3 * 0.41, 1e-12);
    meshless_galerkin_free(g);
    make_nodes_free(&nodes);
}

/* Timoshenko's cantilever of length L and depth D, held at x = 0 as in the exact solution, with the load P at its end;
 * plane stress. */
static const double L = 4, D = 1, P = 1, E = 1000, NU = 0.3;
static void beam(const double x[2], double u[2]) {
    const double i = D * D * D / 12, y = x[1] - D / 2, f = -P / (6 * E * i);
    u[0] = f * y * ((6 * L - 3 * x[0]) * x[0] + (2 + NU) * (y * y - D * D / 4));
    u[1] = -f * (3 * NU * y * y * (L - x[0]) + (4 + 5 * NU) * D * D * x[0] / 4 + (3 * L - x[0]) * x[0] * x[0]);
}
static void beam_stress(const double x[2], double stress[3]) {
    const double i = D * D * D / 12, y = x[1] - D / 2;
    stress[0] = -P * (L - x[0]) * y / i;
    stress[1] = 0;
    stress[2] = P / (2 * i) * (D * D / 4 - y * y);
}
static void beam_end(const double x[2], double t[2]) {
    double stress[3];
    beam_stress(x, stress);
    t[0] = stress[0];
    t[1] = stress[2];
}

/* Error in the energy norm over the exact energy's root. */
static double beam_error(int across) {
    struct galerkin_input in = make_input(L, D, across);
    struct meshless_nodes nodes = make_nodes(&in, 0, NULL);
    struct galerkin_fixed fix = {.to = {0, D}, .direction = {1, 1}, .value = beam};
    struct galerkin_pull pull = {.from = {L, 0}, .to = {L, D}, .value = beam_end};
    static struct galerkin_place at[MESHLESS_CELLS_CORNERS * MESHLESS_CELLS_GAUSS * MESHLESS_CELLS_GAUSS];
    double weight[sizeof at / sizeof *at], apart = 0, whole = 0;
    in.fixed = in.pulls = 1;
    in.fix = &fix;
    in.pull = &pull;
    struct galerkin *g = meshless_galerkin_new(&in);
    meshless_galerkin_solve(g);
    assert_true(g->solution.converged);
    for (int p = 0; p < g->cells.pieces; p++)
        for (int q = 0, n = meshless_cells_inside(g, p, at, weight); q < n; q++) {
            double u[2], grad[2][2], ours[3], exact[3];
            meshless_field_at(g, &at[q], u, grad);
            meshless_field_stress(g, grad, ours);
            beam_stress(at[q].x, exact);
            for (int pass = 0; pass < 2; pass++) {
                const double s[3] = {pass ? exact[0] : ours[0] - exact[0], pass ? exact[1] : ours[1] - exact[1],
                                     pass ? exact[2] : ours[2] - exact[2]};
                *(pass ? &whole : &apart) +=
                    weight[q] * (s[0] * s[0] + s[1] * s[1] - 2 * NU * s[0] * s[1] + 2 * (1 + NU) * s[2] * s[2]);
            }
        }
    meshless_galerkin_free(g);
    make_nodes_free(&nodes);
    return sqrt(apart / whole);
}

static void cantilever(void **state) {
    (void)state;
    const double error[3] = {beam_error(16), beam_error(32), beam_error(64)};
    print_message("cantilever: energy-norm errors %.3e %.3e %.3e, orders %.2f %.2f\n", error[0], error[1], error[2],
                  log2(error[0] / error[1]), log2(error[1] / error[2]));
    check_at_least(log2(error[0] / error[1]), 1);
    check_at_least(log2(error[1] / error[2]), 1);
    check_below(error[2], 0.02);
}

/* The whole system of K, G and the multipliers by a null-space solution: LAPACK's dggglse minimises
 * |R u - R^-T f| over G u = g, with K + G^T G = R^T R. */
static void null_space(void **state) {
    (void)state;
    struct galerkin_input in = make_input(1, 1, 6);
    struct meshless_nodes nodes = make_nodes(&in, 0, NULL);
    struct galerkin_fixed fix = {.to = {1, 0}, .direction = {1, 1}, .displacement = {0.02, 0.01}};
    struct galerkin_pull pull = {.from = {0, 1}, .to = {1, 1}, .traction = {3, 4}};
    in.fixed = in.pulls = 1;
    in.fix = &fix;
    in.pull = &pull;
    struct galerkin *g = meshless_galerkin_new(&in);
    meshless_galerkin_solve(g);
    assert_true(g->solution.converged);
    const int n = 2 * in.nodes, rows = g->rows.rows, high = g->half_band + 1;
    double *band = calloc((size_t)n * (size_t)high, sizeof *band), *load = calloc((size_t)n, sizeof *load);
    double *k = calloc((size_t)n * (size_t)n, sizeof *k), *c = calloc((size_t)rows * (size_t)n, sizeof *c);
    double *given = calloc((size_t)rows, sizeof *given), *u = calloc((size_t)n, sizeof *u);
    meshless_assemble(g, 1000, band, load);
    for (int j = 0; j < n; j++)
        for (int i = j; i < n && i - j < high; i++) k[j * n + i] = k[i * n + j] = band[j * high + i - j];
    for (int r = 0; r < rows; r++) {
        given[r] = g->rows.given[r];
        for (int e = g->rows.first[r]; e < g->rows.first[r + 1]; e++) {
            const int place = meshless_assemble_place(g, g->rows.unknown[e]);
            c[place * rows + r] += g->rows.value[e];
            load[place] += 1000 * g->rows.value[e] * given[r];
        }
    }
    assert_int_equal(LAPACKE_dpotrf(LAPACK_COL_MAJOR, 'U', n, k, n), 0);
    for (int j = 0; j < n; j++)
        for (int i = j + 1; i < n; i++) k[j * n + i] = 0;
    assert_int_equal(LAPACKE_dtrtrs(LAPACK_COL_MAJOR, 'U', 'T', 'N', n, 1, k, n, load, n), 0);
    assert_int_equal(LAPACKE_dgglse(LAPACK_COL_MAJOR, n, n, rows, k, n, c, rows, load, given, u), 0);
    for (int i = 0; i < n; i++) check_close(g->solution.u[i], u[meshless_assemble_place(g, i)], 1e-9);
    check_below(g->solution.equilibrium, 1e-9);
    free(band), free(load), free(k), free(c), free(given), free(u);
    meshless_galerkin_free(g);
    make_nodes_free(&nodes);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(patch), cmocka_unit_test(pulled), cmocka_unit_test(cantilever),
                                       cmocka_unit_test(null_space)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
