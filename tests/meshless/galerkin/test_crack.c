/* Cracked plates: an edge crack's K against Kaya and Erdogan, independence of radius and penalty, the virtual crack's
 * jump, quadrature of cells. */
#include "base/par.h"
#include "meshless/galerkin/cells.h"
#include "tests/meshless/galerkin/make.h"

#define EDGE 2.8246 /* K_I/(sigma sqrt(pi a)) at a/W = 0.5 (Kaya and Erdogan 1987) */

static double k_of(double a) { return sqrt(M_PI * a); }

/* a/W = 0.5, half the height 1.5 W: within 1 % with 320 nodes; with one more level of nodes about the tip within 0.3 %,
 * at every radius, and so independent of it. */
static void edge_of(int levels, int expected, double tolerance) {
    struct galerkin_input in = make_input(1, 3, 8);
    struct meshless_nodes nodes;
    in.levels = levels;
    struct galerkin *g = make_edge_crack(&in, 0.5, &nodes);
    check_equal(in.nodes, expected);
    assert_true(g->solution.converged);
    const double widest = meshless_intensity_widest(g, 0);
    for (int k = 3; k < 10; k++) {
        const struct galerkin_intensity is = meshless_intensity_of(g, 0, 0.1 * k * widest);
        check_relative(is.k[0], EDGE * k_of(0.5), tolerance);
        check_relative(is.k_j, EDGE * k_of(0.5), tolerance);
        check_close(is.k[1], 0, 1e-8);
    }
    meshless_galerkin_free(g);
    make_nodes_free(&nodes);
}

static void edge(void **state) {
    (void)state;
    edge_of(2, 320, 0.01);
    edge_of(3, 372, 0.003);
}

/* The same K for penalties over four decades, and by the updates of Hestenes and Powell at the largest. */
static void penalty(void **state) {
    (void)state;
    double k[6];
    for (int e = 0; e < 6; e++) {
        struct galerkin_input in = make_input(1, 3, 8);
        struct meshless_nodes nodes;
        in.levels = 1;
        in.penalty = pow(10, e < 5 ? e : 4);
        in.update = e < 5 ? GALERKIN_CONJUGATE : GALERKIN_HESTENES_POWELL;
        in.tolerance = 1e-10;
        struct galerkin *g = make_edge_crack(&in, 0.5, &nodes);
        assert_true(g->solution.converged);
        check_below(g->solution.violation, 1e-10);
        k[e] = meshless_intensity_of(g, 0, 0.4).k[0];
        meshless_galerkin_free(g);
        make_nodes_free(&nodes);
    }
    for (int e = 1; e < 6; e++) check_relative(k[e], k[0], 1e-7);
}

/* Jump of displacement and strain at the points of the extension. */
static void jump(void **state) {
    (void)state;
    struct galerkin_input in = make_input(1, 3, 8);
    struct meshless_nodes nodes;
    in.levels = 1;
    struct galerkin *g = make_edge_crack(&in, 0.5, &nodes);
    double ahead = 0, worst = 0, opening = 0;
    int points = 0;
    while (ahead < g->line[0].reach[1] && 0.5 + ahead < 1) { /* h is 1/16 within 1/4 of the tip, 1/8 beyond */
        const double h = ahead < 0.25 - 1e-9 ? 1. / 16 : 1. / 8;
        struct galerkin_place at[2] = {{{0.5 + ahead + h / 2, 1.5}, {0.5 + ahead + h / 2, 1.5 + 1e-7}},
                                       {{0.5 + ahead + h / 2, 1.5}, {0.5 + ahead + h / 2, 1.5 - 1e-7}}};
        double u[2][2], grad[2][2][2];
        if (0.5 + ahead + h / 2 > 1 || ahead + h / 2 > g->line[0].reach[1]) break;
        for (int s = 0; s < 2; s++) meshless_field_at(g, &at[s], u[s], grad[s]);
        for (int c = 0; c < 2; c++) {
            worst = check_worst(worst, u[0][c] - u[1][c]);
            worst = check_worst(worst, h * (grad[0][c][c] - grad[1][c][c]));
        }
        worst = check_worst(worst, h * (grad[0][0][1] + grad[0][1][0] - grad[1][0][1] - grad[1][1][0]));
        ahead += h;
        points++;
    }
    check_above(points, 3);
    struct galerkin_place lip[2] = {{{0.2, 1.5}, {0.2, 1.5 + 1e-7}}, {{0.2, 1.5}, {0.2, 1.5 - 1e-7}}};
    double u[2][2], grad[2][2];
    for (int s = 0; s < 2; s++) meshless_field_at(g, &lip[s], u[s], grad);
    opening = u[0][1] - u[1][1];
    check_above(opening, 1e-3);
    check_below(worst, 1e-8 * opening);
    meshless_galerkin_free(g);
    make_nodes_free(&nodes);
}

/* Pieces fill the plate, edges close around each piece, and 1/r is integrated about the tip, as the energy needs it. */
static void quadrature(void **state) {
    (void)state;
    struct galerkin_input in = make_input(2, 2, 12);
    struct meshless_nodes nodes;
    static struct galerkin_place at[MESHLESS_CELLS_CORNERS * MESHLESS_CELLS_GAUSS * MESHLESS_CELLS_GAUSS];
    double weight[sizeof at / sizeof *at], normal[2], area = 0, singular = 0;
    in.levels = 2;
    in.gauss = in.gauss_tip = 12; /* 4 and 6 points reach 1e-5 */
    struct galerkin *g = make_edge_crack(&in, 1, &nodes);
    for (int p = 0; p < g->cells.pieces; p++) {
        double closed[2] = {0, 0}, flux = 0;
        for (int q = 0, n = meshless_cells_inside(g, p, at, weight); q < n; q++) {
            area += weight[q];
            singular += weight[q] / hypot(at[q].x[0] - 1, at[q].x[1] - 1);
        }
        for (int k = 0; k < g->cells.piece[p].corners; k++)
            for (int q = 0, n = meshless_cells_edge(g, p, k, at, weight, normal); q < n; q++)
                for (int c = 0; c < 2; c++) {
                    closed[c] += weight[q] * normal[c];
                    flux += weight[q] * normal[c] * at[q].x[c];
                }
        check_close(closed[0], 0, 1e-14);
        check_close(closed[1], 0, 1e-14);
        check_relative(flux, 2 * meshless_cells_area(g, p), 1e-12);
    }
    check_close(area, 4, 1e-12);
    check_relative(singular, 8 * log(1 + sqrt(2)), 1e-7); /* 8 int_0^(pi/4) dt/cos t */
    meshless_galerkin_free(g);
    make_nodes_free(&nodes);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(edge), cmocka_unit_test(penalty), cmocka_unit_test(jump),
                                       cmocka_unit_test(quadrature)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
