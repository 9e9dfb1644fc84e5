/* A step that does not hold is made again from the kept state; one that nothing helps is given up. */
#include "coupling/control/explain.h"
#include "coupling/control/accept.h"
#include "coupling/march.h"
#include "coupling/run.h"
#include "coupling/step.h"
#include "tests/coupling/scene_of.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *const flow = "title: test\n"
                                "domain: {size: [0.1, 0.05, 0.05], cells: [16, 12, 8]}\n"
                                "fluid:\n"
                                "  density: 1000\n"
                                "  viscosity: 1.0e-4\n"
                                "  initial: {velocity: [0.1, 0.02, 0]}\n"
                                "  driving: {type: bulk_velocity, direction: x, value: 0.1}\n"
                                "  sides:\n"
                                "    x_low: {type: periodic}\n    x_high: {type: periodic}\n"
                                "    y_low: {type: wall}\n    y_high: {type: wall}\n"
                                "    z_low: {type: periodic}\n    z_high: {type: periodic}\n"
                                "stages:\n";
static const char *const block =
    "title: test\n"
    "domain: {size: [0.2, 0.1, 0.1]}\n"
    "solid:\n"
    "  spacing: 0.005\n"
    "  materials:\n"
    "    - {name: soft, youngs_modulus: 1.0e6, density: 1000, fracture_energy: 1.0e4}\n"
    "  bodies:\n"
    "    - {name: one, shape: box, low: [0.05, 0.03, 0.03], high: [0.09, 0.06, 0.06]}\n"
    "  initial:\n"
    "    - {shape: sine, along: x, centre: 0.07, width: 0.04, displacement: [1.0e-6, 0, 0]}\n"
    "stages:\n";

/* The caller of a step: spoils it in its first attempts. */
struct caller {
    struct run *run;
    int attempts; /* of the present step */
    int failures; /* attempts that fail */
    void (*spoil)(struct run *r);
    double dt; /* of the first attempt, s */
};

static void begin_attempt(void *with) {
    struct caller *c = with;
    if (c->attempts++ < c->failures && c->spoil) c->spoil(c->run);
}

static void end_attempt(void *with, double *number, int n) {
    struct caller *c = with;
    if (c->attempts == 1) c->dt = c->run->dt;
    if (c->attempts <= c->failures) number[ACCEPT_FAILED] = 1;
    par_max_array(number, n);
}

/* One step whose first attempts fail; what march_step returns. */
static int step(struct march *m, struct run *r, int failures, void (*spoil)(struct run *r), struct caller *seen,
                struct step_status *status) {
    struct caller c = {.run = r, .failures = failures, .spoil = spoil};
    const int holds =
        march_step(m, 1, &(struct march_caller){.with = &c, .before = begin_attempt, .largest = end_attempt}, status);
    if (seen) *seen = c;
    return holds;
}

static void steps(struct march *m, struct run *r, int n) {
    for (int k = 0; k < n; k++) {
        struct step_status status;
        assert_true(step(m, r, 0, NULL, NULL, &status));
        assert_true(march_save_state(m, &status));
    }
}

static void assert_same(struct run *one, struct run *other) {
    const struct fluid_state *a = fluid_state_of(one->fluid), *b = fluid_state_of(other->fluid);
    const size_t bytes = fluid_grid_of(one->fluid)->size * sizeof(double);
    assert_true(one->t == other->t && one->dt == other->dt && one->step == other->step);
    assert_memory_equal(a->u, b->u, bytes);
    assert_memory_equal(a->v, b->v, bytes);
    assert_memory_equal(a->p, b->p, bytes);
}

/* An automatic step that fails once is made again with a quarter of its length, from the kept state and the same steps
 * from there; it is then the step that one with that length would have been. */
static void test_made_again(void **state) {
    (void)state;
    struct scene *scene = scene_of(flow, "  - {name: flow, steps: 100, time_step: auto}\n", 0, NULL);
    struct run *r = run_new(scene), *other = run_new(scene);
    struct march *m = march_new(r), *n = march_new(other);
    struct step_status status;
    struct caller seen;
    step_begin_stage(r);
    march_begin(m);
    steps(m, r, 4);
    assert_true(step(m, r, 1, NULL, &seen, &status));
    assert_int_equal(seen.attempts, 2);
    assert_int_equal(r->step, 5);
    assert_true(r->dt == 0.25 * seen.dt);
    assert_true(march_save_state(m, &status));
    assert_int_equal(r->control.repeated, 1);
    step_begin_stage(other);
    march_begin(n);
    steps(n, other, 4);
    other->control.dt_max = 0.25 * seen.dt;
    steps(n, other, 1);
    assert_int_equal(other->control.repeated, 0);
    assert_same(r, other);
    steps(m, r, 3); /* and what follows is the same */
    steps(n, other, 3);
    assert_same(r, other);
    assert_true(r->dt > 0.25 * seen.dt);
    march_free(m);
    march_free(n);
    run_free(r);
    run_free(other);
    scene_free(scene);
}

static void lose_velocity(struct run *r) {
    if (r->solid->n > 0) r->solid->v[0][0] = NAN;
    r->solid->a_holds = 0;
}

/* A fault of the solid is answered with twice the substeps, again and again, and in the end with nothing. */
static void test_finer(void **state) {
    (void)state;
    struct scene *scene = scene_of(block, "  - {name: swing, steps: 100, time_step: 1.0e-5}\n", 0, NULL);
    struct run *r = run_new(scene);
    struct march *m = march_new(r);
    struct step_status status;
    struct caller seen;
    step_begin_stage(r);
    march_begin(m);
    steps(m, r, 3);
    const int before = r->substeps;
    assert_true(step(m, r, 2, lose_velocity, &seen, &status));
    assert_int_equal(seen.attempts, 3);
    assert_int_equal(r->step, 4);
    assert_int_equal(r->substeps, 4 * before);
    for (int h = 0; h < r->solid->n; h++) assert_true(isfinite(r->solid->v[0][h]) && isfinite(r->solid->d[0][h]));
    assert_true(march_save_state(m, &status));
    assert_false(step(m, r, 100, lose_velocity, &seen, &status));
    assert_true(seen.attempts > 2 && seen.attempts < 100);
    assert_int_equal(status.seen_in, STEP_STATUS_SOLID);
    march_free(m);
    run_free(r);
    scene_free(scene);
}

/* The same in a stage in which nothing can touch, so that no part of the step sets the number of substeps: it is as
 * before once the step is accepted. */
static void test_finer_intact(void **state) {
    (void)state;
    struct scene *scene =
        scene_of(block, "  - {name: swing, steps: 100, time_step: 1.0e-5, breakage: false}\n", 0, NULL);
    struct run *r = run_new(scene);
    struct march *m = march_new(r);
    struct step_status status;
    struct caller seen;
    step_begin_stage(r);
    march_begin(m);
    steps(m, r, 3);
    const int before = r->substeps;
    assert_true(step(m, r, 2, lose_velocity, &seen, &status));
    assert_int_equal(seen.attempts, 3);
    assert_int_equal(r->substeps, 4 * before);
    assert_true(march_save_state(m, &status));
    assert_int_equal(r->substeps, before);
    assert_true(step(m, r, 1, lose_velocity, &seen, &status)); /* the state kept by then has the usual number too */
    assert_int_equal(r->substeps, 2 * before);
    assert_true(march_save_state(m, &status));
    assert_int_equal(r->substeps, before);
    march_free(m);
    run_free(r);
    scene_free(scene);
}

static void lose_flow(struct run *r) {
    const struct fluid_state *q = fluid_state_of(r->fluid);
    for (size_t i = 0; i < fluid_grid_of(r->fluid)->size; i++) q->u[i] = NAN;
}

/* A given step is not changed: the run is given up, and stands where the last good state does. */
static void test_given_up(void **state) {
    (void)state;
    struct scene *scene = scene_of(flow, "  - {name: flow, steps: 100, time_step: 1.0e-3}\n", 0, NULL);
    for (int taken = 3; taken <= 53; taken += 50) {
        struct run *r = run_new(scene), *good = run_new(scene);
        struct march *m = march_new(r), *n = march_new(good);
        struct step_status status;
        struct caller seen;
        const int kept = taken / 50 * 50;
        step_begin_stage(r);
        march_begin(m);
        steps(m, r, taken);
        assert_false(step(m, r, 1, lose_flow, &seen, &status));
        assert_int_equal(seen.attempts, 1);
        assert_int_equal(status.seen_in, STEP_STATUS_FLUID);
        const struct march_failure loss = march_abort(m, &status);
        assert_int_equal(loss.step, kept);
        assert_int_equal(r->step, kept);
        char what[64];
        snprintf(what, sizeof what, "unstable in step %d: ", taken + 1);
        assert_memory_equal(loss.what, what, strlen(what));
        assert_non_null(strstr(loss.why, "what diffusion would allow"));
        step_begin_stage(good);
        march_begin(n);
        steps(n, good, kept);
        assert_same(r, good);
        march_free(m);
        march_free(n);
        run_free(r);
        run_free(good);
    }
    scene_free(scene);
}

/* A solid without bonds has no limit, so no limit is named. */
static void test_no_limit(void **state) {
    (void)state;
    char why[256];
    struct scene *scene = scene_of(block, "  - {name: swing, steps: 100, time_step: 1.0e-5}\n", 0, NULL);
    struct run *r = run_new(scene);
    step_begin_stage(r);
    explain_abort(r, 1e-5, 1, why, sizeof why);
    assert_non_null(strstr(why, "of what bonds would allow"));
    r->solid_rates = (struct solid_rates){.sum = 1, .difference = 1};
    explain_abort(r, 1e-5, 1, why, sizeof why);
    assert_string_equal(why, "nothing limits the step of 1e-05 s in the last good state");
    run_free(r);
    scene_free(scene);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_made_again), cmocka_unit_test(test_finer),
                                       cmocka_unit_test(test_finer_intact), cmocka_unit_test(test_given_up),
                                       cmocka_unit_test(test_no_limit)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
