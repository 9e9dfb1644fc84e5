/* Coupled step: no force on a body that moves with the flow, momentum balance, parts of a stage. */
/* A body that moves with the flow has no force; the box's momentum balance closes; a step consists of the parts that
 * the stage needs. */
#include "tests/coupling/ball.h"
#include "coupling/run.h"
#include "coupling/step.h"
#include "tests/coupling/scene_of.h"
#include "solid/bonds/family.h"
#include "tests/check.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *const box = BALL_IN_A_BOX("3000");
static const char *const drift = "stages:\n"
                                 "  - {name: drift, steps: 40, time_step: 2.0e-3}\n";
static const char *const rigid = "stages:\n"
                                 "  - {name: flow, steps: 5, time_step: 2.0e-3, solid: rigid}\n";

/* 40 steps at a tenth of a cell each: four cells. Velocities must stay the flow's, bonds unstretched. */
static void test_moves_with_flow(void **state) {
    (void)state;
    const double velocity[3] = {0.1, 0.05, -0.02};
    struct scene *scene = scene_of(box, drift, 0, NULL);
    struct run *r = run_new(scene);
    for (int h = 0; h < r->solid->n; h++)
        for (int c = 0; c < 3; c++) r->solid->v[c][h] = velocity[c];
    step_begin_stage(r);
    for (int c = 0; c < 3 && r->v_last[0]; c++)
        for (int h = 0; h < r->solid->n; h++) r->v_last[c][h] = velocity[c];
    while (r->stage_step < scene->stage[0].steps) step_advance(r);
    double error = 0, load = 0;
    for (int h = 0; h < r->solid->n; h++)
        for (int c = 0; c < 3; c++) {
            error = check_worst(error, r->solid->v[c][h] - velocity[c]);
            error = check_worst(error, fabs(r->solid->d[c][h] - velocity[c] * r->t) / r->t);
            load = check_worst(load, r->solid->load[c][h]);
        }
    check_below(par_max(error), 1e-8 * 0.1);
    /* against rho U2/dx */
    check_below(par_max(load), 1e-8 * 1000 * 0.01 / 0.01);
    double force[3];
    ibm_forcing_total(r->ibm, force);
    for (int c = 0; c < 3; c++) check_close(force[c], 0, 1e-8 * 1000 * 0.01 * 0.08 * 0.08);
    solid_family_count(r->solid);
    check_above(r->solid->bonds_total, 1000);
    assert_int_equal(r->solid->bonds_broken, 0);
    run_free(r);
    scene_free(scene);
}

static void test_parts(void **state) {
    (void)state;
    struct scene *scene = scene_of(box, rigid, 0, NULL);
    struct run *r = run_new(scene);
    step_begin_stage(r);
    assert_int_equal(r->parts, 1);
    assert_string_equal(r->part_name[0], "fluid with forcing");
    assert_int_equal(r->substeps, 0);
    assert_null(r->v_last[0]);
    run_free(r);
    scene_free(scene);
    scene = scene_of(box, drift, 0, NULL);
    r = run_new(scene);
    step_begin_stage(r);
    assert_int_equal(r->parts, 5);
    /* the least number of substeps within the safety */
    const double safety = scene->stage[0].safety;
    check_at_most(r->dt / r->substeps, safety * r->solid_stable * (1 + 1e-9));
    check_above(r->dt / (r->substeps - 1), safety * r->solid_stable);
    run_free(r);
    scene_free(scene);
}

/* Two stages in turn, three steps each. before: what is done to the rates that the first stage found. */
static struct run *two_stages(struct scene *scene, void before(struct solid_rates_found *)) {
    struct run *r = run_new(scene);
    for (int h = 0; h < r->solid->n; h++) r->solid->v[0][h] = 0.1 + r->solid->x0[1][h];
    for (r->stage = 0; r->stage < 2; r->stage++) {
        if (r->stage > 0) before(&r->rates_found);
        r->stage_step = 0;
        step_begin_stage(r);
        while (r->stage_step < 3) step_advance(r);
    }
    return r;
}

static void keep_rates(struct solid_rates_found *found) { (void)found; }
static void forget_rates(struct solid_rates_found *found) { found->known = 0; }
static void spoil_rates(struct solid_rates_found *found) { found->rates.stiffness *= 4; }

/* A stage takes the rates of an earlier stage with the same pairwise damping. It goes on as it would with rates of its
 * own, to the bit, though an iteration rounds otherwise the second time. With another pairwise damping it finds its
 * own. */
static void test_rates_again(void **state) {
    (void)state;
    static const char *const two =
        "stages:\n"
        "  - {name: one, steps: 3, time_step: 2.0e-3, integrator: verlet, damping_relative: 6.0e10}\n"
        "  - {name: two, steps: 3, time_step: 1.0e-3, integrator: verlet, damping_relative: 6.0e10, "
        "damping_absolute: 5}\n";
    struct scene *scene = scene_of(box, two, 0, NULL);
    struct run *again = two_stages(scene, keep_rates), *own = two_stages(scene, forget_rates),
               *spoilt = two_stages(scene, spoil_rates);
    check_relative(again->solid_rates.stiffness, own->solid_rates.stiffness, 1e-12);
    check_relative(again->solid_rates.damping, own->solid_rates.damping, 1e-12);
    check_relative(again->solid_rates.sum, own->solid_rates.sum, 1e-12);
    check_relative(again->solid_rates.difference, own->solid_rates.difference, 1e-12);
    check_equal(again->solid_rates.absolute, 5);
    assert_int_equal(again->substeps, own->substeps);
    for (int c = 0; c < 3; c++) {
        assert_memory_equal(again->solid->d[c], own->solid->d[c], (size_t)own->solid->n * sizeof(double));
        assert_memory_equal(again->solid->v[c], own->solid->v[c], (size_t)own->solid->n * sizeof(double));
    }
    check_below(spoilt->solid_stable, 0.9 * own->solid_stable); /* the earlier rates are indeed taken */
    run_free(again);
    run_free(own);
    run_free(spoilt);
    scene_free(scene);
    const char *set[] = {"stages.two.damping_relative=3.0e10"};
    scene = scene_of(box, two, 1, set);
    own = two_stages(scene, forget_rates);
    spoilt = two_stages(scene, spoil_rates);
    assert_memory_equal(&spoilt->solid_rates, &own->solid_rates, sizeof own->solid_rates);
    run_free(own);
    run_free(spoilt);
    scene_free(scene);
}

/* How far the ball's particles have moved apart along x after four steps: the root mean square about their mean, m. No
 * bond breaks, as one that does at another substep moves the others by a jump. */
static double spread_after(const char *integrator, const char *damping, int substeps) {
    char text[3][64];
    snprintf(text[0], sizeof text[0], "stages.drift.integrator=%s", integrator);
    snprintf(text[1], sizeof text[1], "stages.drift.damping_relative=%s", damping);
    snprintf(text[2], sizeof text[2], "stages.drift.substeps=%d", substeps);
    const char *set[] = {
        text[0], text[1], text[2], "stages.drift.steps=4", "stages.drift.breakage=false", "coupling.load=probe"};
    struct scene *scene = scene_of(box, drift, 6, set);
    struct run *r = run_new(scene);
    step_begin_stage(r);
    while (r->stage_step < 4) step_advance(r);
    double mean = 0, square = 0;
    for (int h = 0; h < r->solid->n; h++) mean += r->solid->d[0][h];
    mean = par_sum(mean) / (double)r->solid->n_global;
    for (int h = 0; h < r->solid->n; h++) square += (r->solid->d[0][h] - mean) * (r->solid->d[0][h] - mean);
    square = par_sum(square) / (double)r->solid->n_global;
    run_free(r);
    scene_free(scene);
    return sqrt(square);
}

/* The outcome of a step converges with the number of substeps, at the integrator's order: 3 of RK3, 2 of Verlet, and 1
 * of Verlet with pairwise damping, which sees the velocity before the step's end. */
static void test_substeps_converge(void **state) {
    (void)state;
    static const struct {
        const char *integrator, *damping;
        double order, within;
        int least; /* substeps: the part of second order must have become small beside that of first order */
    } form[] = {{"rk3", "6.0e10", 3, 0.1, 16}, {"verlet", "0", 2, 0.05, 16}, {"verlet", "6.0e10", 1, 0.2, 64}};
    for (int i = 0; i < 3; i++) {
        double spread[3];
        for (int k = 0; k < 3; k++) spread[k] = spread_after(form[i].integrator, form[i].damping, form[i].least << k);
        const double order = log2((spread[1] - spread[0]) / (spread[2] - spread[1]));
        print_message("%s, damping %s: order %.3f\n", form[i].integrator, form[i].damping, order);
        check_close(order, form[i].order, form[i].within);
    }
}

/* A particle without bonds, alone in a fluid at rest: it is slowed by Stokes' drag, and the fluid gets its momentum. */
static void test_set_free(void **state) {
    (void)state;
    const char *set[] = {"solid.bodies.ball.radius=0.006", "solid.bodies.ball.centre=[0.085, 0.085, 0.085]",
                         "fluid.initial.velocity=[0, 0, 0]"};
    struct scene *scene = scene_of(box, drift, 3, set);
    struct run *r = run_new(scene);
    const double start = 0.01, mass = 3000 * 1e-6, diameter = cbrt(6e-6 / M_PI);
    double velocity = start, momentum[3];
    assert_int_equal(r->solid->n_global, 1);
    assert_int_equal(r->surface->isolated, 1);
    for (int h = 0; h < r->solid->n; h++) r->solid->v[0][h] = start;
    step_begin_stage(r);
    for (int n = 0; n < 10; n++) {
        const double before = velocity;
        step_advance(r);
        velocity = par_sum(r->solid->n ? r->solid->v[0][0] : 0);
        fluid_measures_momentum(r->fluid, momentum, NULL);
        check_close(momentum[0] + mass * (velocity - start), 0, 1e-12 * mass * start);
        if (n == 0) { /* the later forcing iterations see a smaller difference: at most a tenth less here */
            const double rate = (before - velocity) / r->dt / start, stokes = 3 * M_PI * 1.0 * diameter / mass;
            check_between(rate, 0.85 * stokes, stokes);
        }
    }
    check_between(velocity, 0, 0.7 * start);
    run_free(r);
    scene_free(scene);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_moves_with_flow), cmocka_unit_test(test_parts),
                                       cmocka_unit_test(test_rates_again), cmocka_unit_test(test_substeps_converge),
                                       cmocka_unit_test(test_set_free)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
