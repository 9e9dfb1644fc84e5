/* The watch of the energy that the coupling by probes makes. */
#include "coupling/control/probe_energy.h"
#include "base/step_status.h"
#include "coupling/interface/displaced.h"
#include "fluid/fluid.h"
#include "tests/check.h"
#include "tests/coupling/ball.h"
#include "tests/coupling/marching.h"
#include "tests/coupling/slab.h"

#include <math.h>

/* Marches through a stage's steps. Returns 1 if it ended before them; e is the watch then. */
static int marched(const char *scene_text, const char *stage, int n, const char *const *set, struct probe_energy *e,
                   struct step_status *status) {
    const char *all[8] = {"solid.materials.soft.fracture_energy=1.0e+3"};
    for (int k = 0; k < n; k++) all[k + 1] = set[k];
    struct marching q = marching_new(scene_text, stage, n + 1, all);
    int ended = 0;
    marching_begin(&q);
    for (long step = 0; step < run_stage(q.r)->steps && !ended; step++) ended = !marching_step(&q);
    *e = q.r->watch.made;
    *status = q.status;
    marching_free(&q);
    return ended;
}

static const char *const light = BALL_IN_A_BOX("1500");
static const char *const free_stage = "coupling: {load: probe}\n"
                                      "stages: [{name: go, steps: 200}]\n";

/* A ball that is released in a stream. Undamped, its surface vibrates ever more: the run ends. */
static void vibrations_end_the_run(void **state) {
    (void)state;
    static const char *const integrator[] = {"stages.go.integrator=rk3", "stages.go.integrator=verlet"};
    struct probe_energy e;
    struct step_status status;
    for (int k = 0; k < 2; k++) {
        if (check_skips(k, 1)) continue;
        assert_int_equal(marched(light, free_stage, 1, &integrator[k], &e, &status), 1);
        assert_int_equal(status.seen_in, STEP_STATUS_PROBES);
        print_message("%.3g times what was exchanged\n", status.value / e.exchanged);
        check_relative(status.value, e.fluid + e.solid, 1e-12);
        check_above(e.fluid, 0);
        check_above(status.value, 3 * e.exchanged);
    }
}

/* Damped, the ball takes energy from the stream, and the fluid loses more than the probes find. */
static void a_damped_body_goes_on(void **state) {
    (void)state;
    struct probe_energy e;
    struct step_status status;
    const char *const damped[] = {"stages.go.damping_relative=5.0e+10"};
    assert_int_equal(marched(light, free_stage, 1, damped, &e, &status), 0);
    check_above(e.solid, 1e-3);
    check_below(e.fluid, -e.solid);
    check_above(e.fluid, -3 * e.solid);
}

/* Probes miss most of the drag of a ball of six cells that falls: said elsewhere, and no vibration. */
static void a_coarse_ball_falls(void **state) {
    (void)state;
    struct probe_energy e;
    struct step_status status;
    const char *const falls[] = {"solid.body_force=[0, 0, -1]", "fluid.initial.velocity=[0, 0, 0]",
                                 "fluid.viscosity=1.0e-4", "solid.bodies.ball.radius=0.03",
                                 "stages.go.damping_relative=1.0e+11"};
    assert_int_equal(marched(light, free_stage, 5, falls, &e, &status), 0);
    check_above(e.fluid, -e.solid);
    check_below(e.solid, 0);
}

/* Whose motion is given may miss all of its load. */
static void a_driven_body_is_left_alone(void **state) {
    (void)state;
    struct probe_energy e;
    struct step_status status;
    const char *const driven[] = {
        "solid.constraints=[{low: [0, 0, 0], high: [0.16, 0.16, 0.16], velocity: [0.1, 0, 0]}]"};
    assert_int_equal(marched(light, free_stage, 1, driven, &e, &status), 0);
    check_equal(e.begun, 0);
}

/* A pressure at one side starts at once, and pushes a wall that fills the channel. Within the first steps the fluid
 * gets three times what the loads exchange, and less and less later: the run goes on. */
static void a_sudden_start_goes_on(void **state) {
    (void)state;
    static const char *const wall =
        "title: a wall between two pressures\n"
        "domain: {size: [0.04, 0.008, 0.008], cells: [40, 8, 8]}\n"
        "fluid:\n"
        "  density: 1000\n"
        "  viscosity: 1.0e-8\n"
        "  sides: {x_low: {type: pressure, pressure: 100}, x_high: {type: pressure}, y_low: {type: periodic}, "
        "y_high: {type: periodic}, z_low: {type: periodic}, z_high: {type: periodic}}\n"
        "solid:\n"
        "  materials: [{name: soft, youngs_modulus: 1.0e5, density: 3000}]\n"
        "  bodies: [{shape: box, low: [0.012, 0, 0], high: [0.03, 0.008, 0.008]}]\n"
        "  constraints: [{low: [0.027, 0, 0], high: [0.03, 0.008, 0.008]}]\n";
    static const char *const pushed =
        "coupling: {load: probe}\n"
        "stages: [{name: push, steps: 500, time_step: 1.0e-4, integrator: verlet, damping_absolute: 200}]\n";
    struct probe_energy e;
    struct step_status status;
    assert_int_equal(marched(wall, pushed, 0, NULL, &e, &status), 0);
    print_message("%.3g times what was exchanged\n", (e.fluid + e.solid) / e.exchanged);
    check_above(e.fluid + e.solid, 2.5 * e.exchanged);
}

/* What the body force gives the fluid beside the slab, and viscosity takes, W; its kinetic energy, J. */
static void outside(struct run *r, double *power, double *kinetic) {
    const struct displaced d = displaced_by_solid(r);
    const struct fluid_measures now = fluid_measures_of(r->fluid);
    double sum[] = {d.momentum[0], d.kinetic}, momentum[3];
    par_sum_array(sum, 2);
    fluid_measures_momentum(r->fluid, momentum, NULL);
    *power = 2 * (momentum[0] - sum[0]) - now.dissipation;
    *kinetic = now.kinetic_energy - sum[1];
}

/* A slab that is carried along between two slits: what the fluid beside it has got from the slab is the change of its
 * kinetic energy, less what the body force gives and viscosity takes. */
static void energy_of_the_fluid_outside(void **state) {
    (void)state;
    struct scene *scene =
        scene_of(slab, "stages: [{name: free, steps: 2000, time_step: 5.0e-5, damping_relative: 3.0e+4}]\n", 0, NULL);
    struct run *r = run_new(scene);
    struct step_status status;
    double power[2] = {0, 0}, kinetic[2] = {0, 0}, given = 0;
    step_begin_stage(r);
    watch_begin(r);
    for (int n = 0; n <= 400; n++) {
        step_advance(r);
        probe_energy_note(r);
        outside(r, &power[1], &kinetic[1]);
        if (n == 0) kinetic[0] = kinetic[1];
        if (n > 0) given += r->dt * 0.5 * (power[0] + power[1]);
        power[0] = power[1];
    }
    assert_int_equal(probe_energy_check(r, &status), 0);
    const double got = kinetic[1] - kinetic[0] - given, seen = r->watch.made.fluid;
    print_message("the fluid has got %.4g J, by its balance %.4g J\n", seen, got);
    check_below(got, 0);
    check_relative(seen, got, 0.02);
    run_free(r);
    scene_free(scene);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(vibrations_end_the_run), cmocka_unit_test(a_damped_body_goes_on),
        cmocka_unit_test(a_coarse_ball_falls),    cmocka_unit_test(a_driven_body_is_left_alone),
        cmocka_unit_test(a_sudden_start_goes_on), cmocka_unit_test(energy_of_the_fluid_outside)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
