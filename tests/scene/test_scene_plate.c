/* A plate's values are read, defaults are filled in, and --set changes them. */
#include "base/par.h"
#include "scene/outline.h"
#include "tests/scene/scene_sample.h"
#include "tests/check.h"

#include <math.h>

static void test_a_plate_is_read(void **state) {
    (void)state;
    struct scene *s = read_or_fail("plate.yaml", 0, NULL);
    const struct scene_solid *p = s->solid;
    assert_int_equal(s->dimension, 2);
    assert_vector(s->domain.size, 0.1, 0.04, 0);
    assert_false(s->fluid);
    assert_false(s->coupling);
    check_equal(s->domain.cells[0], 0);
    assert_false(s->domain.periodic[2]);
    check_equal(p->model, PHYSICS_PLANE_STRESS);
    check_equal(p->thickness, 0.002);
    assert_vector(p->lattice_offset, 0.25, -0.5, 0);
    check_equal(p->partial_volume, SOLID_PARTIAL_RAMP);
    check_equal(p->horizons, SOLID_ONE_SIDED);
    check_equal(p->material[0].micromodulus, PHYSICS_CONICAL);
    check_equal(p->material[1].horizon_ratio, 5);
    check_equal(p->material[0].poisson_ratio, 1.0 / 3);
    check_equal(p->material[1].poisson_ratio, 0.3333);
    assert_vector(p->body_force, 0, -9.81, 0);
    check_equal(p->cracks, 1);
    check_equal(p->crack[0].points, 3);
    assert_string_equal(p->crack[0].name, "notch");
    assert_vector(p->crack[0].point[2], 0.02, 0.021, 0);
    const struct scene_constraint *held = &p->constraint[0], *pulled = &p->constraint[1];
    assert_false(held->has_displacement);
    assert_false(held->direction[0]);
    assert_true(held->direction[1]);
    check_equal(held->time.n, 0);
    assert_true(pulled->has_displacement && pulled->direction[0] && pulled->direction[1] && !pulled->direction[2]);
    assert_vector(pulled->displacement, 0, 1e-5, 0);
    assert_vector(pulled->velocity, 0, 0, 0);
    check_equal(pulled->time.n, 2);
    check_equal(pulled->time.t[1], 1e-6);
    check_equal(pulled->time.factor[1], 1);
    check_equal(p->load[0].kind, SOLID_LOAD_REGION);
    check_equal(p->load[1].kind, SOLID_LOAD_EDGE);
    check_equal(p->load[0].time.n, 3);
    check_equal(p->load[0].time.t[2], 3e-6);
    check_equal(p->load[0].time.factor[2], 0);
    check_equal(p->load[1].over_horizon, 1);
    check_equal(p->load[2].over_horizon, 0);
    check_equal(p->load[1].edge[0][1], 0.04);
    check_equal(p->load[1].edge[1][0], 0.06);
    assert_vector(p->load[2].traction, -1e6, 0, 0);
    check_equal(p->initial[0].along, 1);
    check_equal(p->initial[0].width, 0.005);
    assert_vector(p->initial[0].displacement, 0, 1e-6, 0);
    const struct scene_refinement *r = p->refinement;
    check_equal(r->levels, 2);
    check_equal(r->energy, 0);
    check_equal(r->damage, 0.1);
    check_equal(r->from, 1e-6);
    check_equal(r->every, 5);
    assert_false(r->horizon_kept);
    assert_false(r->interface_corrected);
    assert_true(r->held_refine);
    check_equal(r->starts, 1);
    assert_vector(r->high, 0.08, 0.03, 0);
    check_equal(r->start[0].level, 2);
    check_equal(r->start[0].low[1], 0.015);
    check_equal(s->output.crack->damage, 0.4);
    /* ten spacings at Rayleigh's speed in steel, sqrt(2 - 2/sqrt(3)) of the shear waves' at nu = 1/3 in plane stress */
    check_close(s->output.crack->window, 0.01 / (sqrt(2 - 2 / sqrt(3)) * sqrt(2e11 / (2 * 4. / 3 * 7800))), 1e-10);
    check_equal(s->output.crack->every, 4);
    assert_vector(s->output.crack->direction, 1, 1, 0);
    check_equal(s->output.probes->places, 2);
    check_equal(s->output.probes->every, 2);
    assert_vector(s->output.probes->at[1], 0.01, 0.03, 0);
    scene_free(s);
}

/* All curves of a body, as corners: rectangles and discs too. */
static void test_outlines_are_curves(void **state) {
    (void)state;
    struct scene *s = read_or_fail("plate.yaml", 0, NULL);
    const struct scene_body *plate = &s->solid->body[0], *ring = &s->solid->body[1];
    assert_int_equal(plate->outlines, 4); /* its own, a piece, two holes */
    assert_int_equal(plate->outline[0].corners, 6);
    check_equal(plate->outline[0].corner[2].turn, 1);
    check_equal(plate->outline[0].corner[2].centre[0], 0.07);
    check_equal(plate->outline[0].corner[3].turn, 0);
    check_equal(plate->outline[0].corner[3].at[0], 0.06);
    const struct scene_outline *piece = &plate->outline[1], *disc = &plate->outline[2];
    check_equal(piece->corners, 4);
    assert_false(piece->is_hole);
    check_equal(piece->corner[2].at[0], 0.095);
    check_equal(piece->corner[2].at[1], 0.01);
    check_equal(piece->corner[3].at[0], 0.085);
    check_equal(disc->corners, 2);
    assert_true(disc->is_hole);
    check_equal(disc->corner[0].turn, 1);
    check_equal(disc->corner[1].turn, 1);
    check_equal(disc->corner[0].at[0], 0.02 - 0.004);
    check_equal(disc->corner[1].at[0], 0.02 + 0.004);
    assert_true(plate->outline[3].is_hole);
    check_equal(plate->outline[3].corner[1].turn, -1);
    check_equal(ring->outlines, 2);
    assert_false(ring->outline[0].is_hole);
    assert_true(ring->outline[1].is_hole);
    check_equal(s->solid->body[2].outlines, 1);
    check_equal(s->solid->body[3].outlines, 0); /* points have none */
    scene_free(s);
}

static void assert_bounds(const struct scene_corner *corner, int n, double low_x, double low_y, double high_x,
                          double high_y) {
    struct scene_corner copy[4];
    double low[2], high[2];
    memcpy(copy, corner, (size_t)n * sizeof *copy);
    const struct scene_outline o = {n, copy, 0};
    scene_outline_bounds(&o, low, high);
    const double value[4] = {low[0], low[1], high[0], high[1]}, is[4] = {low_x, low_y, high_x, high_y};
    for (int i = 0; i < 4; i++)
        if (fabs(value[i] - is[i]) > 1e-15 * 8) fail_msg("%d: %.17g, should be %.17g", i, value[i], is[i]);
}

/* An arc's bounds are those of its extremes that it passes; round-off is that of atan2 and hypot. */
static void test_bounds_of_arcs(void **state) {
    (void)state;
    const double h = sqrt(0.5);
    const struct scene_corner quarter[] = {{.at = {0, 0}}, {{1, 0}, {0, 0}, 1}, {.at = {0, 1}}};
    const struct scene_corner top[] = {{{h, h}, {0, 0}, 1}, {.at = {-h, h}}};
    const struct scene_corner rest[] = {{{h, h}, {0, 0}, -1}, {.at = {-h, h}}};
    const struct scene_corner disc[] = {{{-1, 0}, {0, 0}, 1}, {{1, 0}, {0, 0}, 1}};
    const struct scene_corner bite[] = {{{-1, 0}, {0, 0}, 1}, {{1, 0}, {0, 0}, -1}};
    assert_bounds(quarter, 3, 0, 0, 1, 1);
    assert_bounds(top, 2, -h, h, h, 1);
    assert_bounds(rest, 2, -1, -1, 1, h);
    assert_bounds(disc, 2, -1, -1, 1, 1);
    assert_bounds(bite, 2, -1, -1, 1, 0);
}

/* A disc either way round, half a disc, a square with a bite, an arc of more than half a turn, and a ring. */
static void test_areas(void **state) {
    (void)state;
    struct scene_corner disc[2] = {{{1, 2}, {3, 2}, 1}, {{5, 2}, {3, 2}, 1}},
                        back[2] = {{{1, 2}, {3, 2}, -1}, {{5, 2}, {3, 2}, -1}};
    struct scene_corner half[2] = {{{1, 2}, {0, 0}, 0}, {{5, 2}, {3, 2}, 1}};
    struct scene_corner bite[4] = {{.at = {0, 0}}, {{4, 0}, {4, 2}, -1}, {.at = {4, 4}}, {.at = {0, 4}}};
    struct scene_corner wide[2] = {{{0, 1}, {0, 0}, 1},
                                   {{1, 0}, {0, 0}, 0}}; /* three quarters of a disc, and its chord */
    struct scene_outline one[2] = {{2, disc, 0}};
    struct scene_body body = {.outlines = 1, .outline = one};
    check_relative(scene_outline_area(&body), 4 * M_PI, 1e-14);
    one[0].corner = back;
    check_relative(scene_outline_area(&body), 4 * M_PI, 1e-14);
    one[0].corner = half;
    check_relative(scene_outline_area(&body), 2 * M_PI, 1e-14);
    one[0] = (struct scene_outline){4, bite, 0};
    check_relative(scene_outline_area(&body), 16 - 2 * M_PI, 1e-14);
    one[0] = (struct scene_outline){2, wide, 0};
    check_relative(scene_outline_area(&body), 0.75 * M_PI + 0.5, 1e-14);
    one[0] = (struct scene_outline){4, bite, 0};
    one[1] = (struct scene_outline){2, wide, 1};
    body.outlines = 2;
    check_relative(scene_outline_area(&body), 16 - 2 * M_PI - 0.75 * M_PI - 0.5, 1e-14);
}

static void test_defaults_of_a_plate(void **state) {
    (void)state;
    const char *const set[] = {"solid.refinement={}", "output.crack={}", "output.probes={at: [[0, 0]]}"};
    struct scene *s = read_or_fail("pulled.yaml", 3, set);
    const struct scene_solid *p = s->solid;
    check_equal(p->model, PHYSICS_PLANE_STRAIN);
    check_equal(p->thickness, 1);
    check_equal(p->material[0].poisson_ratio, 0.25);
    assert_vector(p->lattice_offset, 0, 0, 0);
    check_equal(p->partial_volume, SOLID_PARTIAL_EXACT);
    check_equal(p->horizons, SOLID_DUAL_HORIZON);
    check_equal(p->material[0].micromodulus, PHYSICS_CONSTANT);
    check_equal(p->material[0].horizon_ratio, 3);
    assert_string_equal(p->constraint[0].directions, "xy");
    assert_true(p->constraint[0].direction[1] && !p->constraint[0].direction[2]);
    assert_false(p->constraint[0].has_displacement);
    check_equal(p->load[0].time.n, 0);
    assert_false(p->load[1].over_horizon);
    const struct scene_refinement *r = p->refinement;
    check_equal(r->levels, 1);
    check_equal(r->energy, 0.4);
    check_equal(r->damage, 0);
    check_equal(r->from, 0);
    check_equal(r->every, 10);
    assert_false(r->horizon_kept);
    assert_false(r->interface_corrected);
    assert_false(r->held_refine);
    check_equal(r->starts, 0);
    for (int d = 0; d < 3; d++) {
        check_equal(r->low[d], -INFINITY);
        check_equal(r->high[d], INFINITY);
    }
    check_equal(s->output.crack->damage, 0.35);
    check_close(s->output.crack->window, 0.01 / (sqrt(2 - 2 / sqrt(3)) * sqrt(7.2e10 / (2.5 * 2235))), 1e-15);
    check_equal(s->output.crack->every, 10);
    assert_vector(s->output.crack->direction, 1, 0, 0);
    check_equal(s->output.probes->places, 1);
    check_equal(s->output.probes->every, 10);
    scene_free(s);
    s = read_or_fail("block.yaml", 0, NULL); /* in 3D */
    assert_int_equal(s->dimension, 3);
    check_equal(s->solid->model, PHYSICS_3D);
    assert_false(s->solid->refinement);
    check_equal(s->solid->crack[0].points, 4);
    assert_vector(s->solid->lattice_offset, 0.5, 0, 0);
    assert_vector(s->solid->crack[0].point[2], 0.01, 0.005, 0.01);
    assert_string_equal(s->solid->constraint[0].directions, "xyz");
    assert_vector(s->output.crack->direction, 1, 0, 0);
    scene_free(s);
}

static void test_settings_of_a_plate(void **state) {
    (void)state;
    const char *const set[] = {
        "solid.cracks.notch.points[1]=[0.011, 0.02]",   "solid.bodies.plate.outline[0]=[0.001, 0]",
        "solid.bodies.plate.outline[2].centre[0]=0.07", "solid.refinement.energy=0.5",
        "solid.loads[1].time=[[0, 0], [1, 1]]",         "solid.initial[0].shape=sine"};
    const char *const wrong[][2] = {
        {"solid.bodies.plate.outline[0].at=[0, 0]",
         "--set solid.bodies.plate.outline[0].at: there is no entry named at in the list"},
        {"solid.bodies.plate.outline[0]=[0, 0, 0]",
         "--set solid.bodies.plate.outline[0]: solid.bodies[0].outline[0].at = [0, 0, 0]: must be a list of "
         "2 "
         "numbers (m)"},
        {"solid.cracks.notch.points[3]=[0, 0]",
         "--set solid.cracks.notch.points[3]: there is no entry 3: points has 0 to 2"}};
    struct scene *s = read_or_fail("plate.yaml", 6, set);
    assert_vector(s->solid->crack[0].point[1], 0.011, 0.02, 0);
    assert_int_equal(s->solid->initial[0].shape, SOLID_SINE);
    check_equal(s->solid->body[0].own.corner[0].at[0], 0.001);
    check_equal(s->solid->refinement->energy, 0.5);
    assert_int_equal(s->solid->load[1].time.n, 2);
    scene_free(s);
    sample_check_settings(SCENES "plate.yaml", sizeof wrong / sizeof *wrong, wrong);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_plate_is_read),     cmocka_unit_test(test_outlines_are_curves),
        cmocka_unit_test(test_bounds_of_arcs),      cmocka_unit_test(test_defaults_of_a_plate),
        cmocka_unit_test(test_settings_of_a_plate), cmocka_unit_test(test_areas)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
