/* A stage that goes on until all is at rest: it ends at rest and not before, damped critically by itself. */
#include "coupling/control/settle.h"
#include "coupling/control/braked.h"
#include "coupling/run.h"
#include "coupling/step.h"
#include "solid/measure/energy.h"
#include "solid/step/relax.h"
#include "tests/check.h"
#include "tests/coupling/scene_of.h"

#include <math.h>
#include <stdio.h>

/* A bar of E = 1 GPa and rho = 1000, 96 mm of it free: waves of 1000 m/s, the slowest motion at c/(4 L). */
static const char *const bar = "title: test\n"
                               "domain: {size: [0.02, 0.1]}\n"
                               "solid:\n"
                               "  spacing: 0.002\n"
                               "  model: plane_stress\n"
                               "  materials: [{name: m, youngs_modulus: 1.0e9, density: 1000, horizon_ratio: 2}]\n"
                               "  bodies: [{shape: rectangle, low: [0, 0], high: [0.02, 0.1]}]\n";
#define HELD "  constraints: [{low: [0, 0], high: [0.02, 0.004]}]\n"
#define PULLED "  loads: [{edge: {from: [0, 0.1], to: [0.02, 0.1]}, traction: [0, 1.0e5]%s}]\n"
#define FREE                                                                                                           \
    "  loads: [{edge: {from: [0, 0.1], to: [0.02, 0.1]}, traction: [0, 1.0e5]},\n"                                     \
    "          {edge: {from: [0, 0], to: [0.02, 0]}, traction: [0, -1.0e5]}]\n"

struct end {
    long step;
    int ended;
    double strain, most, kinetic, at_rest, frequency, damping, t; /* J; at_rest: by relaxation */
    struct steady_found found;
};

static struct end settled(const char *scene_text, const char *rest, const char *stage) {
    char text[1024];
    snprintf(text, sizeof text, "%sstages: [{name: settle, steps: 3000, %s}]\n", rest, stage);
    struct scene *scene = scene_of(scene_text, text, 0, NULL);
    struct run *r = run_new(scene);
    struct end e = {0};
    step_begin_stage(r);
    while (!e.ended && r->stage_step < 3000) {
        step_advance(r);
        if (steady_is_due(r, r->stage_step)) e.ended = steady_sample(r, &e.found);
        if (r->stage_step % 10 == 0) e.most = fmax(e.most, solid_energy_measure(r->solid).strain);
    }
    const struct solid_energy energy = solid_energy_measure(r->solid);
    e = (struct end){r->stage_step,  e.ended, energy.strain,       e.most,
                     energy.kinetic, 0,       r->settle.frequency, r->solid->stage.damping_absolute,
                     r->t,           e.found};
    solid_relax(r->solid, 1e-6, 100000);
    e.at_rest = solid_energy_measure(r->solid).strain;
    run_free(r);
    scene_free(scene);
    return e;
}

#define UNTIL "until: {quantity: rest}"

/* The frequency is the Rayleigh quotient of the linear displacement, sqrt(3) c/L in place of pi/2 c/L: 1.10 of it. */
static void a_pulled_bar(void **state) {
    (void)state;
    static const char *const integrator[] = {UNTIL ", integrator: verlet", UNTIL ", integrator: rk3"};
    char rest[512];
    snprintf(rest, sizeof rest, HELD PULLED, "");
    for (int k = 0; k < 2; k++) {
        const struct end e = settled(bar, rest, integrator[k]);
        check_equal(e.ended, 1);
        check_below(e.step, 600);
        check_relative(e.strain, e.at_rest, 0.01); /* until.change */
        check_below(e.kinetic, 1e-3 * e.strain);
        check_below(e.most, 1.01 * e.at_rest); /* it does not swing beyond */
        check_relative(e.frequency, sqrt(3) * 1000 / 0.096, 0.05);
        check_relative(e.damping, 2 * e.frequency, 1e-12);
    }
}

/* A bar that swings without damping has moments of no kinetic energy and of a strain energy that stands still. */
static void an_undamped_bar(void **state) {
    (void)state;
    char rest[512];
    snprintf(rest, sizeof rest, HELD PULLED, "");
    const struct end e = settled(bar, rest,
                                 "until: {quantity: rest, change: 0.5, window: 2}, damping_absolute: 0, "
                                 "integrator: verlet");
    check_equal(e.ended, 0);
    check_above(e.most, 3 * e.at_rest);
    /* weakly damped it ends much later, and right */
    const struct end weak = settled(bar, rest, UNTIL ", damping_absolute: 6000, integrator: verlet");
    check_equal(weak.ended, 1);
    check_above(weak.step, 400);
    check_relative(weak.strain, weak.at_rest, 0.02);
}

static void a_free_bar(void **state) {
    (void)state;
    const struct end e = settled(bar, FREE, UNTIL ", integrator: verlet");
    check_equal(e.ended, 1);
    check_below(e.step, 300);
    check_relative(e.strain, e.at_rest, 0.01);
    check_relative(e.frequency, sqrt(12) * 1000 / 0.1, 0.05);
}

static void without_a_load(void **state) {
    (void)state;
    const struct end e = settled(bar, HELD, UNTIL);
    check_equal(e.ended, 1);
    check_equal(e.step, 40); /* two windows */
    check_equal(e.strain, 0);
    check_equal(e.damping, 0);
}

/* A load that rises from 1 ms on: the bar is at rest until then. */
static void a_late_load(void **state) {
    (void)state;
    char rest[512];
    snprintf(rest, sizeof rest, HELD PULLED, ", time: [[1.0e-3, 0], [1.5e-3, 1]]");
    const struct end e = settled(bar, rest, UNTIL ", integrator: verlet");
    check_equal(e.ended, 1);
    check_above(e.t, 1.5e-3);
    check_below(e.t, 2.5e-3);
    check_relative(e.strain, e.at_rest, 0.01);
}

/* In a flow: a block that is held at one end bends; load, flow and block come to rest. */
static const char *const block =
    "title: test\n"
    "domain: {size: [0.032, 0.016, 0.016], cells: [32, 16, 16]}\n"
    "fluid:\n"
    "  density: 1000\n"
    "  viscosity: 1.0e-3\n"
    "  initial: {velocity: [0.1, 0, 0]}\n"
    "  driving: {type: bulk_velocity, direction: x, value: 0.1}\n" SCENE_OF_PERIODIC_SIDES "solid:\n"
    "  materials: [{name: m, youngs_modulus: 1.0e7, density: 3000}]\n"
    "  bodies: [{name: a, shape: box, low: [0.012, 0, 0.004], high: [0.016, 0.012, 0.012]}]\n"
    "  constraints: [{low: [0, 0, 0], high: [0.032, 0.002, 0.016]}]\n";

static void in_a_flow(void **state) {
    (void)state;
    const struct end e = settled(block, "", UNTIL);
    check_equal(e.ended, 1);
    check_below(e.found.moving, 1e-3);
    check_below(e.found.left[STEADY_LOAD], 0.01);
    check_below(e.found.left[STEADY_FLOW], 0.01);
    check_above(e.found.value[STEADY_LOAD], 0);
    check_above(e.damping, 0);
    const struct end tight = settled(block, "", "until: {quantity: rest, change: 1.0e-3, kinetic: 1.0e-5}");
    check_equal(tight.ended, 1);
    check_above(tight.step, e.step);
    check_relative(e.strain, tight.strain, 0.03); /* energy goes with the square of the load */
    check_relative(e.found.value[STEADY_LOAD], tight.found.value[STEADY_LOAD], 0.02);
}

/* Past a sphere between an inflow and an outflow the wake decays within 20 steps, and the flow beside it within 200. */
static const char *const sphere =
    "title: test\n"
    "domain: {size: [0.04, 0.02, 0.02], cells: [32, 16, 16]}\n"
    "fluid:\n"
    "  density: 1000\n"
    "  viscosity: 1.0e-5\n"
    "  sides: {x_low: {type: inflow, bulk_velocity: 1.0e-3}, x_high: {type: outflow}, y_low: {type: wall},\n"
    "    y_high: {type: wall}, z_low: {type: periodic}, z_high: {type: periodic}}\n"
    "solid:\n"
    "  materials: [{name: m, youngs_modulus: 1.0e5, density: 1000}]\n"
    "  bodies: [{shape: sphere, centre: [0.02, 0.01, 0.01], radius: 0.003}]\n"
    "stages: [{name: settle, steps: 3000, cfl: 0.9, solid: rigid, until: {quantity: rest}}]\n";

static void a_flow_of_two_decays(void **state) {
    (void)state;
    struct scene *scene = scene_of(sphere, "", 0, NULL);
    struct run *r = run_new(scene);
    struct steady_found found = {0};
    int ended = 0;
    step_begin_stage(r);
    while (!ended && r->stage_step < 600) {
        step_advance(r);
        if (steady_is_due(r, r->stage_step)) ended = steady_sample(r, &found);
    }
    check_equal(ended, 1);
    while (r->stage_step < 600) step_advance(r);
    check_relative(found.value[STEADY_FLOW], fluid_measures_kinetic_energy(r->fluid), 0.01); /* until.change */
    r->load_kind->sample(r);
    check_relative(found.value[STEADY_LOAD], r->load[0], 0.01);
    run_free(r);
    scene_free(scene);
}

/* Whether a stage of a ball in a flow is said to be braked. */
static int braked_in(const char *more, const char *stage, char sentence[BRAKED_SENTENCE]) {
    char text[1024];
    snprintf(text, sizeof text,
             "solid:\n"
             "  materials: [{name: m, youngs_modulus: 1.0e5, density: 1000}]\n"
             "  bodies: [{name: one, shape: box, low: [0.002, 0.002, 0.002], high: [0.004, 0.006, 0.006]},\n"
             "           {name: two, shape: box, low: [0.004, 0.002, 0.002], high: [0.006, 0.006, 0.006]}]\n%s"
             "stages: [{name: settle, steps: 1, %s}]\n",
             more, stage);
    struct scene *scene = scene_of("title: test\n"
                                   "domain: {size: [0.008, 0.008, 0.008], cells: [8, 8, 8]}\n"
                                   "fluid:\n"
                                   "  density: 1000\n"
                                   "  viscosity: 1.0e-4\n" SCENE_OF_PERIODIC_SIDES,
                                   text, 0, NULL);
    struct run *r = run_new(scene);
    step_begin_stage(r);
    sentence[0] = '\0';
    const int is = braked_of(r, sentence);
    run_free(r);
    scene_free(scene);
    return is;
}

/* Damping to rest brakes a free body in a flow; not one that is held, by itself or by another that it is bonded to. */
static void free_in_a_flow(void **state) {
    (void)state;
    char said[BRAKED_SENTENCE];
#define HOLD "  constraints: [{low: [0.002, 0.002, 0.002], high: [0.003, 0.006, 0.006]}]\n"
    check_equal(braked_in("", UNTIL, said), 1);
    assert_non_null(strstr(said, "stage settle: the damping that brings the solid to rest brakes 2 of 2 bodies that "
                                 "nothing holds (one, ...)"));
    check_equal(braked_in(HOLD, UNTIL, said), 1);
    assert_non_null(strstr(said, "brakes 1 of 2 bodies that nothing holds (two)"));
    check_equal(braked_in(HOLD "  interfaces: [{between: [two, one], fracture_energy: 1}]\n", UNTIL, said), 0);
    check_equal(braked_in("", UNTIL ", damping_absolute: 0", said), 0);
    check_equal(braked_in("", "cfl: 0.5", said), 0);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(a_pulled_bar),         cmocka_unit_test(an_undamped_bar),
                                       cmocka_unit_test(a_free_bar),           cmocka_unit_test(without_a_load),
                                       cmocka_unit_test(a_late_load),          cmocka_unit_test(in_a_flow),
                                       cmocka_unit_test(a_flow_of_two_decays), cmocka_unit_test(free_in_a_flow)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
