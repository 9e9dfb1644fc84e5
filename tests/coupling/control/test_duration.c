/* A stage that has a duration ends at its time, whatever its steps are; without one its steps end it. */
#include "coupling/control/duration.h"
#include "coupling/run.h"
#include "coupling/stage.h"
#include "coupling/step.h"
#include "tests/check.h"
#include "tests/coupling/scene_of.h"

#include <math.h>

static const char *const bar = "title: test\n"
                               "domain: {size: [0.02, 0.1]}\n"
                               "solid:\n"
                               "  spacing: 0.002\n"
                               "  model: plane_stress\n"
                               "  materials: [{name: m, youngs_modulus: 1.0e9, density: 1000, horizon_ratio: 2}]\n"
                               "  bodies: [{shape: rectangle, low: [0, 0], high: [0.02, 0.1]}]\n"
                               "  loads: [{edge: {from: [0, 0.1], to: [0.02, 0.1]}, traction: [0, 1.0e5]}]\n";
static const char *const flow = "title: test\n"
                                "domain: {size: [8, 8, 8], cells: [8, 8, 8]}\n"
                                "fluid:\n"
                                "  density: 1\n"
                                "  viscosity: 0.1\n"
                                "  body_force: [1.0e-2, 0, 0]\n" SCENE_OF_PERIODIC_SIDES;

/* Takes the stages of a scene and checks when each ends. steps: expected number of each, -1: any from 3 on. */
static void lasts(const char *what, const char *stages, const double *duration, const int *steps) {
    struct scene *scene = scene_of(what, stages, 0, NULL);
    struct run *r = run_new(scene);
    double end = 0;
    long foreseen = 0;
    for (r->stage = 0; r->stage < scene->stages; r->stage++, r->stage_step = 0) {
        double first = 0, last = 0;
        step_begin_stage(r);
        while (!stage_has_ended(r)) {
            const double before = r->t;
            const int may_end = duration_may_end(r);
            assert_true(step_advance(r));
            last = r->t - before;
            if (r->stage_step == 1) first = last;
            if (r->stage_step == 1) foreseen = duration_steps(r);
            check_above(last, 0);
            if (duration_is_over(r)) assert_true(may_end);
        }
        end += duration[r->stage];
        print_message("stage %d: %ld steps from %g to %g s, ends at %.17g s\n", r->stage, r->stage_step, first, last,
                      r->t);
        check_relative(r->t, end, 1e-12);
        check_at_most(last, first * (1 + 1e-9));
        assert_int_equal(duration_steps(r), r->stage_step);
        if (steps[r->stage] >= 0) check_at_most(fabs((double)(foreseen - r->stage_step)), 1);
        if (steps[r->stage] >= 0)
            assert_int_equal(r->stage_step, steps[r->stage]);
        else
            check_at_least(r->stage_step, 3);
    }
    run_free(r);
    scene_free(scene);
}

/* 20.5 steps are 20 and a half; 20 steps of a number that is no binary fraction are no 21; the second stage counts from
 * its own start. */
static void given_steps(void **state) {
    (void)state;
    static const char *const stages = "stages:\n"
                                      "  - {name: a, steps: 100, time_step: 1.0e-6, duration: 2.05e-5}\n"
                                      "  - {name: b, steps: 100, time_step: 1.1e-6, duration: 2.2e-5}\n"
                                      "  - {name: c, steps: 5, time_step: 1.0e-6, duration: 4.5e-6}\n";
    lasts(bar, stages, (const double[]){2.05e-5, 2.2e-5, 4.5e-6}, (const int[]){21, 20, 5});
}

static void steps_of_a_solid(void **state) {
    (void)state;
    lasts(bar, "stages: [{name: a, steps: 1000, duration: 3.0e-5}, {name: b, steps: 1000, duration: 1.0e-8}]\n",
          (const double[]){3e-5, 1e-8}, (const int[]){-1, 1});
}

/* The last automatic steps are two halves. */
static void automatic_steps(void **state) {
    (void)state;
    static const char *const stages = "stages:\n"
                                      "  - {name: a, steps: 1000, duration: 20}\n"
                                      "  - {name: b, steps: 1000, duration: 7.3}\n"
                                      "  - {name: c, steps: 100, duration: 1.0, time_step: 0.3}\n";
    lasts(flow, stages, (const double[]){20, 7.3, 1}, (const int[]){-1, -1, 4});
}

/* The steps end before the time. */
static void steps_end_first(void **state) {
    (void)state;
    struct scene *scene = scene_of(bar, "stages: [{name: a, steps: 7, time_step: 1.0e-6, duration: 1.0}]\n", 0, NULL);
    struct run *r = run_new(scene);
    step_begin_stage(r);
    while (!stage_has_ended(r)) assert_true(step_advance(r));
    assert_int_equal(r->stage_step, 7);
    assert_false(duration_is_over(r));
    run_free(r);
    scene_free(scene);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(given_steps), cmocka_unit_test(steps_of_a_solid),
                                       cmocka_unit_test(automatic_steps), cmocka_unit_test(steps_end_first)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
