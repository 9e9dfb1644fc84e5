/* Flows that are too fast for their cells: which driving ends a run, and that an initial flow does not. */
#include "coupling/control/unresolved.h"
#include "coupling/control/overstep.h"
#include "tests/coupling/marching.h"

#include <math.h>

/* The acceleration is 1 m/s2; a cell is 1 m wide. */
static const char *const box = "title: test\n"
                               "domain: {size: [4, 4, 4], cells: [4, 4, 4]}\n"
                               "fluid:\n"
                               "  density: 2\n"
                               "  viscosity: 1.0e-7\n";
static const char *const periodic = SCENE_OF_PERIODIC_SIDES "stages:\n  - {name: a, steps: 60, time_step: 0.01}\n";
static const char *const pressed =
    "  sides: {x_low: {type: pressure, pressure: 8}, x_high: {type: pressure}, y_low: {type: periodic}, "
    "y_high: {type: periodic}, z_low: {type: periodic}, z_high: {type: periodic}}\n"
    "stages:\n  - {name: a, steps: 60, time_step: 0.01}\n";

struct outcome {
    int ended;
    long step;            /* of the state that is kept */
    double logged, value; /* Reynolds numbers of a cell */
};

static struct outcome run_of(const char *sides, int n, const char *const *set) {
    struct marching q = marching_new(box, sides, n, set);
    struct outcome o = {.ended = 0};
    marching_begin(&q);
    for (int k = 0; k < 60 && !o.ended; k++) o.ended = !marching_step(&q);
    o.logged = q.r->watch.logged_unresolved;
    o.value = q.status.value;
    if (o.ended) {
        assert_int_equal(q.status.seen_in, STEP_STATUS_UNRESOLVED);
        const struct march_failure loss = march_abort(q.march, &q.status);
        assert_non_null(strstr(loss.what, "the flow has become too fast for its cells by step 50: "));
        assert_non_null(strstr(loss.why, "at most 1e+06 goes, which at this velocity takes a viscosity of "));
    }
    o.step = q.r->step;
    marching_free(&q);
    return o;
}

/* u = 1 m/s2 t is 0.5 m/s after 50 steps; the number is at least that of the largest component over sqrt(3). */
static void driven(void **state) {
    (void)state;
    const char *const gradient[] = {"fluid.driving={type: pressure_gradient, value: 2}"};
    const char *const force[] = {"fluid.body_force=[0, 0, 1]"};
    const struct outcome o[] = {run_of(periodic, 1, gradient), run_of(periodic, 1, force), run_of(pressed, 0, NULL)};
    for (int k = 0; k < 3; k++) {
        assert_true(o[k].ended);
        check_relative(o[k].value, 0.5 / 1e-7 / sqrt(3), 1e-9);
        check_equal(o[k].step, 0);
    }
}

/* Below a million: said in the run, and again at its end where it has grown. */
static void warned(void **state) {
    (void)state;
    const char *const set[] = {"fluid.driving={type: pressure_gradient, value: 2}", "fluid.viscosity=1.0e-5"};
    const struct outcome o = run_of(periodic, 2, set);
    assert_false(o.ended);
    check_relative(o.logged, 0.6 / 1e-5 / sqrt(3), 1e-9);
    const char *const slow[] = {"fluid.driving={type: pressure_gradient, value: 2}", "fluid.viscosity=1.0e-3"};
    check_equal(run_of(periodic, 2, slow).logged, 0);
}

/* What the scene itself gives is said at the start, and goes on: of a flow at rest a force makes less than half. */
static void given(void **state) {
    (void)state;
    const char *const initial[] = {"fluid.initial.velocity=[1, 0, 0]"};
    const char *const less[] = {"fluid.initial.velocity=[1, 0, 0]", "fluid.body_force=[1, 0, 0]"};
    struct outcome o = run_of(periodic, 1, initial);
    assert_false(o.ended);
    check_equal(o.logged, 0);
    o = run_of(periodic, 2, less);
    assert_false(o.ended);
    check_equal(o.logged, 0);
}

/* A step that is short for viscosity is not short for a flow that a force speeds up. */
static void moves(void **state) {
    (void)state;
    const char *const still[] = {"fluid.viscosity=1.0e-9"}, *const force[] = {"fluid.viscosity=1.0e-9",
                                                                              "fluid.body_force=[0, 0, 1]"};
    for (int k = 1; k <= 2; k++) {
        char sentence[OVERSTEP_MAX][OVERSTEP_SENTENCE];
        struct scene *scene = scene_of(box, periodic, k, k == 1 ? still : force);
        struct run *r = run_new(scene);
        check_equal(overstep_of(r, sentence), k == 1);
        run_free(r);
        scene_free(scene);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(driven), cmocka_unit_test(warned), cmocka_unit_test(given),
                                       cmocka_unit_test(moves)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
