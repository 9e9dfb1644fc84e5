/* Cracks of several parts and holes: a straight crack in parts, a bent crack's sides, the stress about a hole. */
#include "base/par.h"
#include "meshless/galerkin/cells.h"
#include "meshless/galerkin/cut.h"
#include "tests/meshless/galerkin/make.h"

/* An edge crack under tension, straight or with bends. */
static struct galerkin *cracked(struct galerkin_input *in, struct meshless_nodes *nodes, int bends,
                                const double (*bend)[2], enum galerkin_method method) {
    static struct galerkin_crack crack;
    struct galerkin *plain = make_edge_crack(in, 0.5, nodes);
    crack = (struct galerkin_crack){{{0, 1.5}, {0.5, 1.5}}, bends, bend};
    meshless_galerkin_free(plain);
    in->crack = &crack;
    in->method = method;
    struct galerkin *g = meshless_galerkin_new(in);
    meshless_galerkin_solve(g);
    assert_true(g->solution.converged);
    return g;
}

/* In three parts that lie in line a crack has the K of one part. */
static void in_line(void **state) {
    (void)state;
    static const double bend[2][2] = {{0.2, 1.5}, {0.41, 1.5}};
    for (int method = 0; method < 2; method++) {
        struct galerkin_input in = make_input(1, 3, 8);
        struct meshless_nodes nodes;
        double k[2], t[2];
        in.levels = 2;
        for (int parts = 0; parts < 2; parts++) {
            struct galerkin *g =
                cracked(&in, &nodes, parts ? 2 : 0, bend, method ? GALERKIN_VISIBILITY : GALERKIN_VIRTUAL);
            const struct galerkin_intensity is = meshless_intensity_of(g, 0, 0.08);
            k[parts] = is.k[0];
            t[parts] = is.t;
            meshless_galerkin_free(g);
            make_nodes_free(&nodes);
        }
        check_relative(k[1], k[0], 1e-7);
        check_relative(t[1], t[0], 1e-5);
    }
}

/* Which nodes points beside a bent crack see: those on their own side, round a bend too. */
static void sides(void **state) {
    (void)state;
    static const double bend[1][2] = {{0.3, 1.5}};
    struct galerkin_input in = make_input(1, 3, 12);
    struct meshless_nodes nodes;
    struct galerkin *plain = make_edge_crack(&in, 0.5, &nodes);
    struct galerkin_crack crack = {{{0, 1.5}, {0.5, 1.7}}, 1, bend};
    meshless_galerkin_free(plain);
    in.crack = &crack;
    in.method = GALERKIN_VISIBILITY;
    struct galerkin *g = meshless_galerkin_new(&in);
    int across = 0, beside = 0;
    unsigned random = 7;
    for (int n = 0; n < 4000; n++) {
        struct galerkin_place at;
        const double x = 0.1 + 0.38 * make_random(&random), y = 1.35 + 0.4 * make_random(&random);
        const double line = x < 0.3 ? 1.5 : 1.5 + (x - 0.3); /* of the crack at x */
        at.x[0] = at.see[0] = x;
        at.x[1] = at.see[1] = y;
        for (int i = 0; i < in.nodes; i++) {
            double gradient[2];
            const double *node = in.node[i], its = node[0] < 0.3 ? 1.5 : 1.5 + (node[0] - 0.3);
            if (node[0] > 0.45 || hypot(x - node[0], y - node[1]) >= g->radius[i]) continue;
            const int sees = isfinite(meshless_cut_distance(g, &at, i, gradient));
            const int same = (y > line) == (node[1] > its);
            assert_int_equal(sees, same);
            across += !same;
            beside += same;
        }
    }
    assert_true(across > 1000 && beside > 1000);
    /* the pieces fill the body (meshless_cells_new asks for that), and none lies on both sides */
    for (int k = 0; k < g->cells.pieces; k++) {
        int sign = 0;
        for (int i = 0; i < g->cells.piece[k].corners; i++) {
            const double *x = g->cells.corner[g->cells.piece[k].first + i];
            if (x[0] > 0.5 + 1e-9) break; /* beyond the tip a piece may lie on both */
            const double off = x[1] - (x[0] < 0.3 ? 1.5 : 1.5 + (x[0] - 0.3));
            if (fabs(off) < 1e-6) continue;
            assert_true(sign == 0 || (sign > 0) == (off > 0));
            sign = off > 0 ? 1 : -1;
        }
    }
    meshless_galerkin_free(g);
    make_nodes_free(&nodes);
}

/* A square plate of side 8 with a hole of radius 1 under tension 1: the stress at
 * the hole (3.23 by Heywood's formula; the spacing is a quarter of the radius), the force through the middle. */
static void hole(void **state) {
    (void)state;
    enum { CORNERS = 48 };
    double corner[CORNERS][2];
    struct galerkin_hole ring = {CORNERS, (const double(*)[2])corner};
    struct galerkin_input in = make_input(8, 8, 32);
    for (int k = 0; k < CORNERS; k++) {
        corner[k][0] = 4 + cos(2 * M_PI * k / CORNERS);
        corner[k][1] = 4 + sin(2 * M_PI * k / CORNERS);
    }
    in.holes = 1;
    in.hole = &ring;
    const struct galerkin_fixed fix[2] = {{.direction = {1, 1}}, {.from = {8, 0}, .to = {8, 0}, .direction = {0, 1}}};
    const struct galerkin_pull pull[2] = {{.to = {8, 0}, .traction = {0, -1}},
                                          {.from = {0, 8}, .to = {8, 8}, .traction = {0, 1}}};
    in.fixed = in.pulls = 2;
    in.fix = fix;
    in.pull = pull;
    struct meshless_nodes nodes = make_nodes(&in, 0, NULL);
    struct galerkin *g = meshless_galerkin_new(&in);
    meshless_galerkin_solve(g);
    double force = 0;
    for (int side = -1; side < 2; side += 2)
        for (int k = 0; k < 300; k++) {
            const double x = 4 + side * (1 + 3 * (k + 0.5) / 300);
            const struct galerkin_place at = {{x, 4}, {x, 4}};
            double u[2], grad[2][2], stress[3];
            meshless_field_at(g, &at, u, grad);
            meshless_field_stress(g, grad, stress);
            force += 3. / 300 * stress[1];
            if (k == 0) check_relative(stress[1], 3.23, 0.12);
            if (k == 150) check_relative(stress[1], 1 + 0.5 / 6.25 + 1.5 / 39.0625, 0.06);
        }
    check_relative(force, 8, 0.01);
    meshless_galerkin_free(g);
    make_nodes_free(&nodes);
}

/* Nodes along a tip lie the same about it, however it is turned. */
static void turned(void **state) {
    (void)state;
    struct galerkin_input in = make_input(1, 3, 8);
    const double tip[1][2] = {{0.51, 1.47}};
    in.levels = 3;
    int count = 0;
    for (int n = 0; n < 3; n++) {
        const double angle = 0.7 * n, along[1][2] = {{cos(angle), sin(angle)}};
        struct meshless_nodes nodes = meshless_nodes_new(&in, (const double[2]){0.5, 0}, 1, tip, along);
        int near = 0;
        for (int i = 0; i < nodes.n; i++) {
            const double dx = nodes.x[i][0] - tip[0][0], dy = nodes.x[i][1] - tip[0][1];
            const double xi = dx * along[0][0] + dy * along[0][1], eta = dy * along[0][0] - dx * along[0][1];
            const double h = in.spacing / 8;
            if (fmax(fabs(xi), fabs(eta)) > 3.9 * h) continue;
            near++;
            check_close(xi / h, round(xi / h), 1e-9);
            check_close(eta / h + 0.5, round(eta / h + 0.5), 1e-9);
        }
        if (n == 0) count = near;
        assert_int_equal(near, count);
        assert_true(near == 7 * 8);
        make_nodes_free(&nodes);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(in_line), cmocka_unit_test(sides), cmocka_unit_test(hole),
                                       cmocka_unit_test(turned)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
