/* Static equilibrium by adaptive dynamic relaxation. */
#include "make.h"

/* A cantilever (clamped over the horizon) under a load P spread over its end: E b w/P = 4 (L/h)^3 + 2 (1 + nu)/kappa L/h
 * with nu = 1/4, kappa = 5/6. At h = 8 spacings and with the surface correction the lattice comes within 6 %. */
static void test_cantilever(void **state) {
    (void)state;
    const int height = 8, breadth = 6, length = 40;
    const struct solid_constraint clamp = {.low = {-1, -1, -1}, .high = {3 * SPACING, 1, 1}, .direction = {1, 1, 1}};
    struct solid *s = make((struct make){.sites = {length + 3, height, breadth}, .constraints = 1, .constraint = &clamp});
    const double end = (length + 2) * SPACING, force = 1e-3;
    for (int h = 0; h < s->n; h++)
        if (s->x0[0][h] > end) s->load[1][h] = force / (height * breadth * pow(SPACING, 3));
    const int steps = solid_relax(s, 1e-5, 40000);
    assert_true(steps > 100);
    double tip = 0, reaction = 0;
    for (int h = 0; h < s->n; h++) {
        if (s->x0[0][h] > end) tip += s->d[1][h] / (height * breadth);
        for (int c = 0; c < 3; c++) assert_true(s->v[c][h] == 0);
    }
    const double slender = (double)length / height;
    const double expected = 4 * pow(slender, 3) + 3 * slender;
    assert_near(par_sum(tip) * YOUNG * breadth * SPACING / force / expected, 1, 0.06);
    /* what the clamp carries is what was put on: the force of the free particles on the clamped, one sweep later */
    solid_force(s, 0);
    for (int h = 0; h < s->n; h++) reaction += fabs(s->a[1][h]) * DENSITY * s->volume[h];
    assert_true(par_sum(reaction) < 1e-3 * force);
    solid_free(s);
}

/* Far from the clamp a bar pulled by its own weight stretches as the lattice's Young's modulus says. */
static void test_hanging_bar(void **state) {
    (void)state;
    const int length = 30, width = 8;
    const struct solid_constraint clamp = {.low = {-1, -1, -1}, .high = {3 * SPACING, 1, 1}, .direction = {1, 1, 1}};
    struct solid *s = make((struct make){.sites = {length + 3, width, width},
                                         .constraints = 1,
                                         .constraint = &clamp,
                                         .body_force = {10, 0, 0}});
    assert_true(solid_relax(s, 1e-6, 40000) > 0);
    double low = 0, high = 0;
    const int from = 11, to = 23; /* layers */
    for (int h = 0; h < s->n; h++) {
        const int layer = (int)floor(s->x0[0][h] / SPACING);
        if (layer == from) low += s->d[0][h] / (width * width);
        if (layer == to) high += s->d[0][h] / (width * width);
    }
    const double span = (to - from) * SPACING, middle = 0.5 * (from + to + 1) * SPACING;
    const double stretch = (par_sum(high) - par_sum(low)) / span;
    /* mean stress over the span: the weight of what hangs below its middle */
    const double stress = DENSITY * 10 * ((length + 3) * SPACING - middle);
    assert_near(stretch * YOUNG / stress, 1, 0.04);
    solid_free(s);
}

static void test_nothing_to_do(void **state) {
    (void)state;
    struct solid *s = make((struct make){.sites = {8, 8, 8}});
    assert_int_equal(solid_relax(s, 1e-6, 10), 0);
    for (int h = 0; h < s->n; h++) s->load[0][h] = 1;
    assert_int_equal(solid_relax(s, 1e-6, 10), -1); /* free in space under a load: no equilibrium */
    solid_free(s);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_cantilever),
        cmocka_unit_test(test_hanging_bar),
        cmocka_unit_test(test_nothing_to_do),
    };
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
