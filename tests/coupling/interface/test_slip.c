/* With implicit diffusion the slip at a wall is the slip time of the scene times the force on it. */
#include "coupling/run.h"
#include "coupling/step.h"
#include "tests/coupling/scene_of.h"

#include <math.h>

/* Two walls of the domain move along a thick plate at rest in the middle, which nothing else drives the fluid past. */
static const char *const couette =
    "title: a plate between moving walls\n"
    "domain: {size: [8, 20, 8], cells: [8, 20, 8]}\n"
    "fluid:\n"
    "  density: 1\n"
    "  viscosity: 1\n"
    "  sides:\n"
    "    x_low: {type: periodic}\n    x_high: {type: periodic}\n"
    "    y_low: {type: wall, velocity: [1, 0, 0]}\n    y_high: {type: wall, velocity: [1, 0, 0]}\n"
    "    z_low: {type: periodic}\n    z_high: {type: periodic}\n"
    "solid:\n"
    "  materials: [{name: s, youngs_modulus: 1.0e-6, density: 1}]\n"
    "  bodies: [{shape: box, low: [0, 7, 0], high: [8, 13, 8]}]\n"
    "  constraints: [{low: [0, 7, 0], high: [8, 13, 8]}]\n";

/* The slip that the last stage leaves, over the force on the markers per mass of their volumes, s. */
static double slip_over_force(const char *stages, int sets, const char *const *set) {
    struct scene *scene = scene_of(couette, stages, sets, set);
    struct run *r = run_new(scene);
    double force[3], volume = 0;
    step_begin_stage(r);
    while (r->stage_step < scene->stage[0].steps) step_advance(r);
    for (int i = 0; i < r->markers.n; i++) volume += r->markers.volume[i];
    ibm_forcing_total(r->ibm, force);
    const double slip = ibm_forcing_slip(r->ibm) / (fabs(force[0]) / par_sum(volume));
    run_free(r);
    scene_free(scene);
    return slip;
}

/* A solid at rest has the slip time 0.004 dx^2/nu; one that moves under implicit diffusion and loads by probes a third
 * of the longest explicit step, 1.65 dx^2/(12 nu). For a plane of markers J S is 1/2. With implicit diffusion the slip
 * is T (1 - c/2) f, where c is the sum of gamma_r^2/gamma_1, to the part at which the iteration ends, 2e-3 of the
 * longer slip time. With explicit diffusion the slip before a stage's own part is T f, and that of the last stage takes
 * half of its weight gamma_3/gamma_1. */
static void is_the_slip_time_times_the_force(void **state) {
    (void)state;
    static const char *const implicit[] = {"fluid.diffusion=implicit", "coupling.load=probe"};
    const double g[3] = {8. / 15, 2. / 15, 1. / 3}, given = (g[0] * g[0] + g[1] * g[1] + g[2] * g[2]) / g[0],
                 long_time = 1.65 / 12 / 3;
    const double at_rest =
        slip_over_force("stages: [{name: s, steps: 12, time_step: 100, solid: rigid}]\n", 1, implicit);
    const double moves = slip_over_force("stages: [{name: s, steps: 12, time_step: 100}]\n", 2, implicit);
    print_message("slip over force: %.5f s at rest, %.5f s if it moves\n", at_rest, moves);
    check_close(at_rest, 4e-3 * (1 - 0.5 * given), 2e-3 * long_time);
    check_close(moves, long_time * (1 - 0.5 * given), 2e-3 * long_time);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(is_the_slip_time_times_the_force)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
