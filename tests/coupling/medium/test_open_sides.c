/* Permeability of a body that sides of given pressure cut, against the same medium without ends. */
#include "coupling/interface/deposit.h"
#include "coupling/run.h"
#include "coupling/step.h"
#include "tests/check.h"
#include "tests/coupling/scene_of.h"

#include <stdio.h>

/* One period of a simple cubic array of spheres, radius 0.4, creeping flow; %s: cells, the sides in x, driving,
 * bodies. */
static const char *const array = "title: test\n"
                                 "domain: {size: [1, 1, 1], cells: [%d, %d, %d]}\n"
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
                                  "  - {name: flow, steps: %d, time_step: %g, solid: rigid}\n";

/* What the medium measures in the steady flow, at t = 0.15. */
static struct medium_values measure(int cells, const char *sides, const char *driving, const char *bodies) {
    char text[2048], flow[256];
    const double step = 5.37e-4 * 16 * 16 / (cells * cells);
    snprintf(text, sizeof text, array, cells, cells, cells, sides, driving, bodies);
    snprintf(flow, sizeof flow, stages, (int)(0.15036 / step + 0.5), step);
    struct scene *scene = scene_of(text, flow, 0, NULL);
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
 * cells are full of solid and of the force. The velocity along the sides is free, where the endless array has none, so
 * k is 1.25 % larger. Where the forcing does not act on the sides' own faces, it is 2.4 % smaller with 12 cells and 0.4
 * % with 16. */
static void test_array_between_pressures(void **state) {
    (void)state;
    for (int cells = 12; cells <= 16; cells += 4) {
        const struct medium_values endless =
            measure(cells, "    x_low: {type: periodic}\n    x_high: {type: periodic}\n",
                    "  driving: {type: pressure_gradient, value: 1.0e-3}\n",
                    "    - {name: a, material: rigid, shape: sphere, centre: [0.5, 0.5, 0.5], radius: 0.4}\n");
        const struct medium_values cut = measure(
            cells, "    x_low: {type: pressure, pressure: 1.0e-3}\n    x_high: {type: pressure, pressure: 0}\n", "",
            "    - {name: a, material: rigid, shape: sphere, centre: [0, 0.5, 0.5], radius: 0.4}\n"
            "    - {name: b, material: rigid, shape: sphere, centre: [1, 0.5, 0.5], radius: 0.4}\n");
        check_relative(endless.pressure_drop, 1e-3, 1e-12);
        check_relative(cut.pressure_drop, 1e-3, 1e-12);
        print_message("%d cells: %.4f of the endless array's permeability\n", cells,
                      cut.permeability / endless.permeability);
        check_relative(cut.permeability / endless.permeability, 1.0125, 0.003);
    }
}

/* The same with the body force along x instead of a difference of pressures, and no velocity along the sides. */
static void test_array_between_symmetric_ends(void **state) {
    (void)state;
    const struct medium_values endless =
        measure(16, "    x_low: {type: periodic}\n    x_high: {type: periodic}\n", "  body_force: [1.0e-3, 0, 0]\n",
                "    - {name: a, material: rigid, shape: sphere, centre: [0.5, 0.5, 0.5], radius: 0.4}\n");
    const struct medium_values cut =
        measure(16,
                "    x_low: {type: general, u: neumann, v: dirichlet, w: dirichlet, p: dirichlet}\n"
                "    x_high: {type: general, u: neumann, v: dirichlet, w: dirichlet, p: dirichlet}\n",
                "  body_force: [1.0e-3, 0, 0]\n",
                "    - {name: a, material: rigid, shape: sphere, centre: [0, 0.5, 0.5], radius: 0.4}\n"
                "    - {name: b, material: rigid, shape: sphere, centre: [1, 0.5, 0.5], radius: 0.4}\n");
    check_relative(cut.pressure_drop, 1e-3, 1e-12);
    print_message("general: %.4f of the endless array's permeability\n", cut.permeability / endless.permeability);
    check_relative(cut.permeability, endless.permeability, 0.005);
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
