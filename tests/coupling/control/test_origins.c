/* Times that count from the start of a stage act as the same times of the run, also in a stage whose start is not known
 * beforehand and after a stage that has ended. */
#include "coupling/control/origins.h"
#include "coupling/run.h"
#include "coupling/step.h"
#include "solid/imposed/time.h"
#include "tests/check.h"
#include "tests/coupling/scene_of.h"

#include <math.h>
#include <stdio.h>

/* %s: times of a load and of a constraint. The first stage lasts 20 steps of 2^-19 s, an exact number. */
static const char *const bar =
    "title: test\n"
    "domain: {size: [0.02, 0.1]}\n"
    "solid:\n"
    "  spacing: 0.002\n"
    "  model: plane_stress\n"
    "  materials: [{name: m, youngs_modulus: 1.0e9, density: 1000, horizon_ratio: 2}]\n"
    "  bodies: [{shape: rectangle, low: [0, 0], high: [0.02, 0.1]}]\n"
    "  constraints: [{low: [0, 0], high: [0.02, 0.004], displacement: [0, -1.0e-5], time: %s}]\n"
    "  loads: [{edge: {from: [0, 0.1], to: [0.02, 0.1]}, traction: [0, 1.0e5], time: %s}]\n";
#define STAGES                                                                                                         \
    "stages:\n"                                                                                                        \
    "  - {name: wait, steps: 20, time_step: 1.9073486328125e-06}\n"                                                    \
    "  - {name: pull, steps: 20, time_step: 1.9073486328125e-06}\n"                                                    \
    "  - {name: hold, steps: 20, time_step: 1.9073486328125e-06}\n"

/* The sum of |d| of all particles after each of the 60 steps. */
static void run_all(const char *constraint, const char *load, double sum[60]) {
    char text[1536];
    snprintf(text, sizeof text, bar, constraint, load);
    struct scene *scene = scene_of(text, STAGES, 0, NULL);
    struct run *r = run_new(scene);
    for (int n = 0; n < 60; n++) {
        if (n % 20 == 0) r->stage = n / 20, r->stage_step = 0;
        if (n % 10 == 0) step_begin_stage(r); /* also in the middle of a stage, as a resumed run does */
        step_advance(r);
        double mine = 0;
        for (int h = 0; h < r->solid->n; h++) mine += fabs(r->solid->d[0][h]) + fabs(r->solid->d[1][h]);
        sum[n] = par_sum(mine);
    }
    run_free(r);
    scene_free(scene);
}

/* 20, 25, 50 and 20, 45 steps are 3.814697265625e-05, 4.76837158203125e-05, 9.5367431640625e-05 and
 * 8.58306884765625e-05 s. The constraint's ramp goes on in the stage after. */
static void times_from_a_stage(void **state) {
    (void)state;
    double of_run[60], of_stage[60];
    run_all("[[3.814697265625e-05, 0], [8.58306884765625e-05, 1]]",
            "[[4.76837158203125e-05, 0], [9.5367431640625e-05, 1]]", of_run);
    run_all("[[0, 0], [4.76837158203125e-05, 1]], time_from: pull",
            "[[9.5367431640625e-06, 0], [5.7220458984375e-05, 1]], time_from: pull", of_stage);
    for (int n = 0; n < 60; n++) check_close(of_stage[n], of_run[n], 1e-12 * of_run[59]);
    for (int n = 0; n < 20; n++) check_equal(of_stage[n], 0);
    check_above(of_stage[59], 0);
}

/* Before the stage the first factor holds, with and without a mean. */
static void before_the_stage(void **state) {
    (void)state;
    const double t[] = {0, 1}, factor[] = {3, 5};
    const struct solid_time before = {2, t, factor, INFINITY}, after = {2, t, factor, 10};
    check_equal(solid_time_factor(&before, 100), 3);
    check_equal(solid_time_mean(&before, 100, 101), 3);
    check_equal(solid_time_ends(&before), -INFINITY);
    check_equal(solid_time_factor(&after, 10.5), 4);
    check_equal(solid_time_mean(&after, 10, 11), 4);
    check_close(solid_time_mean(&after, 9, 11), 3.5, 1e-15);
    check_equal(solid_time_ends(&after), 11);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(times_from_a_stage), cmocka_unit_test(before_the_stage)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
