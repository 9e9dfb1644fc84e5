/* Shape functions of moving least squares: the basis is reproduced, gradients are those of the functions. */
#include "base/par.h"
#include "meshless/galerkin/cut.h"
#include "tests/meshless/galerkin/make.h"

struct plate {
    struct galerkin_input in;
    struct meshless_nodes nodes;
    struct galerkin_crack crack;
    struct galerkin_fixed fix;
    struct galerkin *g;
};

/* A square of 10 by 10 nodes with the tip of a slanted crack in it; the basis is whole everywhere. */
static void plate_new(struct plate *p, enum galerkin_basis basis, enum galerkin_weight weight, double support,
                      enum galerkin_method method, double zone) {
    p->in = make_input(1, 1, 10);
    p->in.basis = basis;
    p->in.weight = weight;
    p->in.support = support;
    p->in.method = method;
    p->in.tip_radius = zone;
    p->crack = (struct galerkin_crack){.end = {{0, 0.42}, {0.513, 0.537}}};
    p->fix = (struct galerkin_fixed){.to = {1, 0}, .direction = {1, 1}};
    p->in.cracks = 1;
    p->in.crack = &p->crack;
    p->in.fixed = 1;
    p->in.fix = &p->fix;
    p->nodes = make_nodes(&p->in, 0, NULL);
    p->g = meshless_galerkin_new(&p->in);
}

static void plate_free(struct plate *p) {
    meshless_galerkin_free(p->g);
    make_nodes_free(&p->nodes);
}

/* Functions 1, x, y and those of the tip, with gradients, at x seen from x. */
static int functions(const struct galerkin *g, const double x[2], double value[7], double gradient[7][2]) {
    value[0] = 1, value[1] = x[0], value[2] = x[1];
    for (int k = 0; k < 3; k++) gradient[k][0] = k == 1, gradient[k][1] = k == 2;
    return 3 + meshless_mls_functions(g->in.basis, &g->tip[0], x, x, value + 3, gradient + 3);
}

/* Largest error of sum phi f(x_I) = f(x) and of its gradient times the spacing, over all functions f. */
static double reproduction(const struct galerkin *g, const double x[2], int terms) {
    struct galerkin_place at = {{x[0], x[1]}, {x[0], x[1]}};
    struct galerkin_shape shape;
    double value[7], gradient[7][2], worst = 0;
    assert_int_equal(meshless_mls_shape(g, &at, &shape), MESHLESS_MLS_DONE);
    functions(g, x, value, gradient);
    for (int k = 0; k < terms; k++) {
        double sum = -value[k], slope[2] = {-gradient[k][0], -gradient[k][1]};
        for (int i = 0; i < shape.n; i++) {
            double values[7], unused[7][2];
            functions(g, g->in.node[shape.node[i]], values, unused);
            sum += shape.phi[i] * values[k];
            for (int c = 0; c < 2; c++) slope[c] += shape.d[i][c] * values[k];
        }
        worst = check_worst(worst, sum);
        for (int c = 0; c < 2; c++) worst = check_worst(worst, slope[c] * g->in.spacing);
    }
    return worst;
}

static void reproduces(void **state) {
    (void)state;
    static const double support[] = {2.5, 2.7, 3.5}; /* for the wedge between crack and side too */
    for (int basis = GALERKIN_LINEAR; basis <= GALERKIN_TIP; basis++)
        for (int weight = GALERKIN_CUBIC; weight <= GALERKIN_QUARTIC; weight++)
            for (int method = GALERKIN_VIRTUAL; method <= GALERKIN_VISIBILITY; method++) {
                struct plate p;
                unsigned seed = 7;
                plate_new(&p, (enum galerkin_basis)basis, (enum galerkin_weight)weight, support[basis],
                          (enum galerkin_method)method, 1e9);
                const int terms = basis == GALERKIN_TIP ? 7 : 3 + basis;
                for (int k = 0; k < 200; k++) {
                    const double x[2] = {make_random(&seed), make_random(&seed)};
                    check_below(reproduction(p.g, x, terms), 1e-12);
                }
                plate_free(&p);
            }
}

/* Where the tip's basis goes over into the linear one, linear functions are still exact, and gradients are those of
 * the functions: against central differences, whose error is of the order of the step squared. */
static void gradients(void **state) {
    (void)state;
    for (int method = GALERKIN_VIRTUAL; method <= GALERKIN_VISIBILITY; method++) {
        struct plate p;
        unsigned seed = 3;
        plate_new(&p, GALERKIN_TIP, GALERKIN_QUARTIC, 3.2, (enum galerkin_method)method, 4);
        for (int k = 0; k < 60; k++) {
            const double x[2] = {0.2 + 0.7 * make_random(&seed), 0.6 + 0.3 * make_random(&seed)}, step = 1e-6;
            struct galerkin_shape here, side[2];
            struct galerkin_place at = {{x[0], x[1]}, {x[0], x[1]}};
            check_below(reproduction(p.g, x, 3), 1e-12);
            assert_int_equal(meshless_mls_shape(p.g, &at, &here), MESHLESS_MLS_DONE);
            for (int c = 0; c < 2; c++) {
                for (int e = 0; e < 2; e++) {
                    struct galerkin_place moved = at;
                    moved.x[c] += e ? step : -step;
                    moved.see[c] = moved.x[c];
                    assert_int_equal(meshless_mls_shape(p.g, &moved, &side[e]), MESHLESS_MLS_DONE);
                }
                if (side[0].n != here.n || side[1].n != here.n) continue;
                for (int i = 0; i < here.n; i++) {
                    assert_int_equal(side[0].node[i], here.node[i]);
                    check_close(here.d[i][c], (side[1].phi[i] - side[0].phi[i]) / (2 * step), 2e-5);
                }
            }
        }
        plate_free(&p);
    }
}

/* A point above the crack does not see a node below it behind the tip, and sees it beyond the tip's extension. */
static void hides(void **state) {
    (void)state;
    struct plate p;
    plate_new(&p, GALERKIN_LINEAR, GALERKIN_CUBIC, 2.5, GALERKIN_VIRTUAL, 1e9);
    double gradient[2];
    int hidden = 0, seen = 0;
    for (int i = 0; i < p.in.nodes; i++) {
        const double *x = p.in.node[i];
        const double line = 0.42 + 0.117 / 0.513 * x[0];
        if (fabs(x[1] - line) > 0.1) continue;
        const struct galerkin_place above = {{x[0], line + 0.02}, {x[0], line + 0.02}};
        const double distance = meshless_cut_distance(p.g, &above, i, gradient);
        if (x[1] > line) check_close(distance, fabs(x[1] - line - 0.02), 1e-12);
        if (x[1] > line) continue;
        if (x[0] < 0.513) check_equal(isinf(distance), 1);
        hidden += isinf(distance);
        seen += isfinite(distance);
    }
    check_above(hidden, 5);
    check_above(seen, 0); /* nodes whose supports meet the extension alone are not cut */
    plate_free(&p);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(reproduces), cmocka_unit_test(gradients),
                                       cmocka_unit_test(hides)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
