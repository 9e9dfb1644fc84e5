/* A stage that begins where nothing changes goes on as if there were no stage; a rigid one brings the solid to rest. */
#include "coupling/run.h"
#include "coupling/step.h"
#include "solid/measure/energy.h"
#include "tests/check.h"
#include "tests/coupling/ball.h"
#include "tests/coupling/scene_of.h"

#include <math.h>
#include <stdio.h>

enum { STEPS = 12, SPLIT = 5 };

static const char *const box = BALL_IN_A_BOX("3000");

/* Displacements, velocities and loads of this rank's particles. */
struct answer {
    int n;
    double *value; /* [9][n] */
};

static struct answer answer_of(const struct run *r) {
    const struct solid *s = r->solid;
    struct answer a = {.n = s->n, .value = calloc(9 * (size_t)s->n + 1, sizeof(double))};
    for (int c = 0; c < 3; c++)
        for (int h = 0; h < s->n; h++) {
            a.value[c * s->n + h] = s->d[c][h];
            a.value[(3 + c) * s->n + h] = s->v[c][h];
            a.value[(6 + c) * s->n + h] = s->load[c][h];
        }
    return a;
}

static void advance(struct run *r, int steps) {
    step_begin_stage(r);
    for (int n = 0; n < steps; n++) step_advance(r);
}

/* The ball after the steps of all stages. */
static struct answer run_stages(const char *stages, int split, int sets, const char *const *set) {
    struct scene *scene = scene_of(box, stages, sets, set);
    struct run *r = run_new(scene);
    advance(r, split);
    for (int k = 1; k < scene->stages; k++) {
        r->stage = k;
        r->stage_step = 0;
        advance(r, (int)scene->stage[k].steps);
    }
    const struct answer a = answer_of(r);
    run_free(r);
    scene_free(scene);
    return a;
}

/* The largest difference of displacements, velocities and loads, each over its largest value. */
static double difference(const struct answer *a, const struct answer *b) {
    double most = 0;
    assert_int_equal(a->n, b->n);
    for (int k = 0; k < 3; k++) {
        double off = 0, largest = 0;
        for (int i = 3 * k * a->n; i < 3 * (k + 1) * a->n; i++) {
            off = check_worst(off, a->value[i] - b->value[i]);
            largest = check_worst(largest, a->value[i]);
        }
        most = fmax(most, par_max(off) / par_max(largest));
    }
    return most;
}

/* Two stages that say the same against one; the integrator uses the forces of the last sweep. */
static double split(const char *load, const char *step) {
    char whole[256], parts[512], set_load[64];
    snprintf(set_load, sizeof set_load, "coupling.load=%s", load);
    const char *const set[] = {set_load};
    const char *const what = "integrator: verlet, damping_relative: 1.0e9, breakage: false";
    snprintf(whole, sizeof whole, "stages:\n  - {name: all, steps: %d, %s, %s}\n", STEPS, step, what);
    snprintf(parts, sizeof parts, "stages:\n  - {name: one, steps: %d, %s, %s}\n  - {name: two, steps: %d, %s, %s}\n",
             SPLIT, step, what, STEPS - SPLIT, step, what);
    struct answer a = run_stages(whole, STEPS, 1, set), b = run_stages(parts, SPLIT, 1, set);
    const double off = difference(&a, &b);
    print_message("%s, %s: %.3g\n", load, step, off);
    free(a.value);
    free(b.value);
    return off;
}

static void test_split(void **state) {
    (void)state;
    static const char *const load[] = {"reaction", "probe"};
    for (int k = 0; k < 2; k++) {
        check_below(split(load[k], "time_step: 2.0e-3"), 1e-12);
        check_below(split(load[k], "cfl: 0.1"), 1e-12);
    }
}

/* In a rigid stage a body that has been set in motion stands still where it is, and its markers with it. They hold the
 * fluid inside it at rest, whichever the load. The support that stops the body takes its kinetic energy. */
static void stands_still(void **state) {
    (void)state;
    static const char *const load[] = {"coupling.load=reaction", "coupling.load=probe"};
    for (int k = 0; k < 2; k++) {
        struct scene *scene = scene_of(box,
                                       "stages:\n  - {name: drift, steps: 60, time_step: 2.0e-3, breakage: false}\n"
                                       "  - {name: rest, steps: 10, time_step: 2.0e-3, solid: rigid}\n",
                                       1, &load[k]);
        struct run *r = run_new(scene);
        advance(r, 60);
        const double *v = r->solid->v[0];
        double moving = 0, fastest = 0, drift = 0;
        for (int h = 0; h < r->solid->n; h++) moving = fmax(moving, v[h]);
        const double energy = solid_energy_measure(r->solid).kinetic, work = par_sum(r->solid->e_constraint);
        struct answer before = answer_of(r);
        r->stage = 1;
        r->stage_step = 0;
        advance(r, 10);
        struct answer after = answer_of(r);
        for (int i = 0; i < 3 * after.n; i++) {
            drift = check_worst(drift, after.value[i] - before.value[i]);
            fastest = check_worst(fastest, after.value[3 * after.n + i]);
        }
        for (int i = 0; i < r->markers.n; i++)
            for (int c = 0; c < 3; c++) fastest = check_worst(fastest, r->markers.v[c][i]);
        check_above(par_max(moving), 1e-3);
        check_close(par_max(drift), 0, 0);
        check_close(par_max(fastest), 0, 0);
        check_relative(work - par_sum(r->solid->e_constraint), energy, 1e-12);
        free(before.value);
        free(after.value);
        run_free(r);
        scene_free(scene);
    }
}

/* What is driven waits in a rigid first stage, and is driven from the next stage on. */
static void is_driven_after_a_rigid_stage(void **state) {
    (void)state;
    static const char *const driven =
        "  constraints: [{low: [0, 0, 0], high: [0.16, 0.16, 0.16], velocity: [0.01, 0, 0]}]\n"
        "stages:\n  - {name: rest, steps: 3, time_step: 2.0e-3, solid: rigid}\n"
        "  - {name: drive, steps: 10, time_step: 2.0e-3, breakage: false}\n";
    for (int k = 0; k < 2; k++) {
        const char *const set[] = {k ? "stages.drive.integrator=rk3" : "stages.drive.integrator=verlet"};
        struct scene *scene = scene_of(box, driven, 1, set);
        struct run *r = run_new(scene);
        double off = 0, early = 0;
        advance(r, 3);
        for (int h = 0; h < r->solid->n; h++) early = fmax(early, fabs(r->solid->d[0][h]) + fabs(r->solid->v[0][h]));
        r->stage = 1;
        r->stage_step = 0;
        advance(r, 10);
        for (int h = 0; h < r->solid->n; h++) off = check_worst(off, r->solid->d[0][h] - 0.01 * 10 * 2e-3);
        check_close(par_max(early), 0, 0);
        check_close(par_max(off), 0, 1e-15);
        run_free(r);
        scene_free(scene);
    }
}

/* A run that is resumed in the midst of a rigid stage: no checkpoint of it has velocities. */
static void stays_still_when_resumed(void **state) {
    (void)state;
    static const char *const set[] = {
        "solid.constraints=[{low: [0, 0, 0], high: [0.16, 0.16, 0.16], velocity: [0.1, 0, 0]}]"};
    struct scene *scene = scene_of(box, "stages: [{name: rest, steps: 9, solid: rigid}]\n", 1, set);
    struct run *r = run_new(scene);
    double fastest = 0, before = 0;
    for (int h = 0; h < r->solid->n; h++) before = fmax(before, fabs(r->solid->v[0][h]));
    r->step = r->stage_step = 4;
    step_begin_stage(r);
    for (int c = 0; c < 3; c++)
        for (int h = 0; h < r->solid->n; h++) fastest = fmax(fastest, fabs(r->solid->v[c][h]));
    check_relative(par_max(before), 0.1, 1e-14);
    check_equal(par_max(fastest), 0);
    run_free(r);
    scene_free(scene);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_split), cmocka_unit_test(stands_still),
                                       cmocka_unit_test(is_driven_after_a_rigid_stage),
                                       cmocka_unit_test(stays_still_when_resumed)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
