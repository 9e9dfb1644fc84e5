/* Permeability of a body that sides of given pressure cut, against the same medium without ends. */
#include "coupling/interface/deposit.h"
#include "coupling/run.h"
#include "coupling/step.h"
#include "tests/check.h"
#include "tests/coupling/scene_of.h"

#include <stdio.h>

/* One period of a simple cubic array of spheres, radius 0.4, creeping flow; %s: the sides in x, driving, bodies. */
static const char *const array = "title: test\n"
                                 "domain: {size: [1, 1, 1], cells: [16, 16, 16]}\n"
                                 "fluid:\n"
                                 "  density: 1\n"
                                 "  viscosity: 1\n"
                                 "  sides:\n"
                                 "%s"
                                 "    y_low: {type: periodic}\n    y_high: {type: periodic}\n"
                                 "    z_low: {type: periodic}\n    z_high: {type: periodic}\n"
                                 "%s"
                                 "solid:\n"
                                 "  materials:\n    - {name: rigid, youngs_modulus: 1, density: 1, horizon_ratio: 2}\n"
                                 "  bodies:\n"
                                 "%s"
                                 "coupling:\n  surface: shape\n  medium: {low: [0, 0, 0], high: [1, 1, 1]}\n";
static const char *const stages = "stages:\n"
                                  "  - {name: flow, steps: 280, time_step: 5.37e-4, solid: rigid}\n"; /* to t = 0.15 */

/* What the medium measures in the steady flow. */
static struct medium_values measure(const char *sides, const char *driving, const char *bodies) {
    char text[2048];
    snprintf(text, sizeof text, array, sides, driving, bodies);
    struct scene *scene = scene_of(text, stages, 0, NULL);
    struct run *r = run_new(scene);
    step_begin_stage(r);
    while (r->stage_step < scene->stage[0].steps) step_advance(r);
    deposit_update(r);
    const struct medium_values value = medium_measure(r->medium, r->fluid, r->surface->immersed_area);
    run_free(r);
    scene_free(scene);
    return value;
}

/* Half a sphere stands against either side. The sides' pressures are those at the medium's faces, where the sections of
 * cells are full of solid and of the force. What is left to the periodic medium, 0.6 %, are the parts of the forcing
 * that would come from the spheres' other halves. */
static void test_array_between_pressures(void **state) {
    (void)state;
    const struct medium_values endless =
        measure("    x_low: {type: periodic}\n    x_high: {type: periodic}\n",
                "  driving: {type: pressure_gradient, value: 1.0e-3}\n",
                "    - {name: a, material: rigid, shape: sphere, centre: [0.5, 0.5, 0.5], radius: 0.4}\n");
    const struct medium_values cut =
        measure("    x_low: {type: pressure, pressure: 1.0e-3}\n    x_high: {type: pressure, pressure: 0}\n", "",
                "    - {name: a, material: rigid, shape: sphere, centre: [0, 0.5, 0.5], radius: 0.4}\n"
                "    - {name: b, material: rigid, shape: sphere, centre: [1, 0.5, 0.5], radius: 0.4}\n");
    check_relative(endless.pressure_drop, 1e-3, 1e-12);
    check_relative(cut.pressure_drop, 1e-3, 1e-12);
    check_relative(cut.permeability, endless.permeability, 0.02);
}

/* The same with the body force along x instead of a difference of pressures, and no velocity along the sides. */
static void test_array_between_symmetric_ends(void **state) {
    (void)state;
    const struct medium_values endless =
        measure("    x_low: {type: periodic}\n    x_high: {type: periodic}\n", "  body_force: [1.0e-3, 0, 0]\n",
                "    - {name: a, material: rigid, shape: sphere, centre: [0.5, 0.5, 0.5], radius: 0.4}\n");
    const struct medium_values cut =
        measure("    x_low: {type: general, u: neumann, v: dirichlet, w: dirichlet, p: dirichlet}\n"
                "    x_high: {type: general, u: neumann, v: dirichlet, w: dirichlet, p: dirichlet}\n",
                "  body_force: [1.0e-3, 0, 0]\n",
                "    - {name: a, material: rigid, shape: sphere, centre: [0, 0.5, 0.5], radius: 0.4}\n"
                "    - {name: b, material: rigid, shape: sphere, centre: [1, 0.5, 0.5], radius: 0.4}\n");
    check_relative(cut.pressure_drop, 1e-3, 1e-12);
    check_relative(cut.permeability, endless.permeability, 0.02);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_array_between_pressures),
        cmocka_unit_test(test_array_between_symmetric_ends),
    };
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
