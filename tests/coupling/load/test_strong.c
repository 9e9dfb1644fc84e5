/* Strongly coupled step: one answer for every relaxation, no iterations where none are needed. */
/* The iterated step: its result does not depend on the iteration method; a body that moves with the flow needs no
 * iterations; steps that do not converge are counted. */
#include "tests/coupling/ball.h"
#include "coupling/load/strong.h"
#include "coupling/run.h"
#include "coupling/step.h"
#include "tests/coupling/scene_of.h"
#include "tests/check.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A light ball: half the fluid's density. */
static const char *const text = BALL_IN_A_BOX("500") "coupling: {scheme: strong, tolerance: 1.0e-7}\n"
                                                     "stages:\n"
                                                     "  - {name: drift, steps: 6, time_step: 2.0e-3}\n";

/* Six steps of a ball at rest in the flow; its mean velocity, and the fastest particle against it. */
static struct strong_count ball_after(int n, const char *const *set, double mean[3], double *shake) {
    struct scene *scene = scene_of(text, "", n, set);
    struct run *r = run_new(scene);
    step_begin_stage(r);
    while (r->stage_step < scene->stage[0].steps) step_advance(r);
    const struct strong_count count = r->strong ? strong_count_of(r->strong) : (struct strong_count){0};
    *shake = 0;
    for (int c = 0; c < 3; c++) {
        mean[c] = 0;
        for (int h = 0; h < r->solid->n; h++) mean[c] += r->solid->v[c][h];
        mean[c] = par_sum(mean[c]) / (double)r->solid->n_global;
        for (int h = 0; h < r->solid->n; h++) *shake = check_worst(*shake, r->solid->v[c][h] - mean[c]);
    }
    *shake = par_max(*shake);
    run_free(r);
    scene_free(scene);
    return count;
}

static void test_one_answer(void **state) {
    (void)state;
    static const char *const aitken[] = {"coupling.relaxation=aitken"};
    double a[3], b[3], shake, shake_b;
    const struct strong_count newton = ball_after(0, NULL, a, &shake);
    assert_int_equal(newton.steps, 6);
    assert_int_equal(newton.unconverged, 0);
    check_above(newton.iterations, newton.steps);
    check_between(a[0], 0.02, 0.1); /* moves with the fluid, not faster than the flow */
    const struct strong_count other = ball_after(1, aitken, b, &shake_b);
    assert_int_equal(other.unconverged, 0);
    for (int c = 0; c < 3; c++) check_close(a[c], b[c], 1e-6 * 0.1);
    check_close(shake, shake_b, 1e-5 * 0.1);
}

/* Verlet continues from its last sweep, which is part of the restored state. */
static void test_one_answer_of_verlet(void **state) {
    (void)state;
    static const char *const set[] = {"stages.drift.integrator=verlet", "coupling.relaxation=aitken"};
    double a[3], b[3], shake, shake_b;
    const struct strong_count newton = ball_after(1, set, a, &shake), other = ball_after(2, set, b, &shake_b);
    assert_int_equal(newton.unconverged + other.unconverged, 0);
    assert_true(newton.iterations != other.iterations); /* so the state was restored another number of times */
    for (int c = 0; c < 3; c++) check_close(a[c], b[c], 1e-6 * 0.1);
    check_close(shake, shake_b, 1e-5 * 0.1);
}

static void test_with_the_flow(void **state) {
    (void)state;
    const double velocity[3] = {0.1, 0.05, -0.02};
    struct scene *scene = scene_of(text, "", 0, NULL);
    struct run *r = run_new(scene);
    step_begin_stage(r);
    for (int c = 0; c < 3; c++)
        for (int h = 0; h < r->solid->n; h++) r->solid->v[c][h] = r->v_last[c][h] = velocity[c];
    while (r->stage_step < scene->stage[0].steps) step_advance(r);
    double error = 0;
    for (int c = 0; c < 3; c++)
        for (int h = 0; h < r->solid->n; h++)
            error = check_worst(error, fabs(r->solid->d[c][h] - velocity[c] * r->t) / r->t);
    check_below(par_max(error), 1e-8 * 0.1);
    run_free(r);
    scene_free(scene);
}

/* The fluid is given the mean velocity of the step, so the work of a constant load is the one that both see. */
static void test_mean_velocity(void **state) {
    (void)state;
    struct scene *scene = scene_of(text, "", 0, NULL);
    struct run *r = run_new(scene);
    const struct solid *s = r->solid;
    step_begin_stage(r);
    for (int n = 0; n < 3; n++) step_advance(r);
    const size_t bytes = (size_t)s->n * sizeof(double);
    double *before[3], off = 0, differs = 0, given = 0;
    const int interface = r->surface->n;
    int *const h_of = malloc((size_t)interface * sizeof *h_of + 1);
    memcpy(h_of, r->surface->h, (size_t)interface * sizeof *h_of);
    for (int c = 0; c < 3; c++) memcpy(before[c] = malloc(bytes + 1), s->d[c], bytes);
    step_advance(r);
    for (int c = 0; c < 3; c++)
        for (int h = 0; h < s->n; h++) {
            off = check_worst(off, r->v_last[c][h] - (s->d[c][h] - before[c][h]) / r->dt);
            differs = check_worst(differs, r->v_last[c][h] - s->v[c][h]);
        }
    for (int c = 0; c < 3; c++)
        for (int i = 0; i < interface; i++) given = check_worst(given, r->markers.v[c][i] - r->v_last[c][h_of[i]]);
    check_below(par_max(off), 1e-12);
    check_below(par_max(given), 1e-6);   /* the tolerance is of the change of velocity in the step */
    check_above(par_max(differs), 1e-4); /* the ball still speeds up, from 0 to some 0.05 m/s */
    for (int c = 0; c < 3; c++) free(before[c]);
    free(h_of);
    run_free(r);
    scene_free(scene);
}

static void test_too_few_iterations(void **state) {
    (void)state;
    static const char *const one[] = {"coupling.iterations=1"}, *const explicit[] = {"coupling={}"};
    double mean[3], shake;
    const struct strong_count count = ball_after(1, one, mean, &shake);
    assert_int_equal(count.iterations, 6);
    assert_int_equal(count.unconverged, 6);
    assert_int_equal(ball_after(1, explicit, mean, &shake).steps, 0);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_one_answer), cmocka_unit_test(test_one_answer_of_verlet),
                                       cmocka_unit_test(test_with_the_flow), cmocka_unit_test(test_mean_velocity),
                                       cmocka_unit_test(test_too_few_iterations)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
