/* The first automatic step of a stage: a solid that moves or falls in a fluid at rest crosses no cell in it. With
 * implicit diffusion the fluid alone would allow a step of an hour; the step grows from that of explicit diffusion. */
#include "coupling/control/time_step.h"
#include "tests/check.h"
#include "tests/coupling/marching.h"

#include <math.h>

static const char *const closed =
    "title: test\n"
    "domain: {size: [16, 8, 12], cells: [16, 8, 12]}\n"
    "fluid:\n"
    "  density: 1\n"
    "  viscosity: 1.0e-3\n"
    "  sides:\n"
    "    x_low: {type: slip}\n    x_high: {type: slip}\n"
    "    y_low: {type: slip}\n    y_high: {type: wall}\n"
    "    z_low: {type: slip}\n    z_high: {type: wall}\n"
    "solid:\n"
    "  materials: [{name: a, youngs_modulus: 10, density: 1}]\n"
    "  bodies:\n"
    "    - {name: fast, shape: box, low: [6, 2, 4], high: [9, 5, 8], velocity: [0.1, 0, -0.2]}\n"
    "    - {name: slow, shape: box, low: [1, 2, 4], high: [4, 5, 8], velocity: [0, 0.1, 0]}\n"
    "stages: [{name: go, steps: 20, cfl: 0.8}]\n";

/* The length of the first step that was accepted, s; 0 if `steps` is. *first: the limit. */
static double first_step(int steps, int n, const char *const *set, double *first) {
    struct marching q = marching_new(closed, "", n, set);
    marching_begin(&q);
    *first = time_step_first(q.r);
    if (steps > 0) marching_take(&q);
    const double dt = q.r->dt;
    check_equal(q.r->control.repeats, 0);
    marching_free(&q);
    return dt;
}

/* By the faster body: 0.1/1 + 0.2/1, beside 0.1/1. */
static void by_velocity(void **state) {
    (void)state;
    double first;
    const double dt = first_step(1, 0, NULL, &first);
    check_relative(first, 0.8 * sqrt(3) / 0.3, 1e-12);
    check_equal(dt, first);
}

static void by_weight(void **state) {
    (void)state;
    double first;
    const char *const falls[] = {"solid.body_force=[0, 0.04, 0]"};
    const double dt = first_step(1, 1, falls, &first);
    check_relative(first, 0.8 * sqrt(3) / (0.3 + 0.2), 1e-12);
    check_equal(dt, first);
}

static void by_diffusion(void **state) {
    (void)state;
    double first;
    const char *const creeps[] = {"fluid.diffusion=implicit", "fluid.viscosity=0.5", "solid.body_force=[0, 0.04, 0]"};
    const double dt = first_step(1, 3, creeps, &first);
    check_relative(first, 0.8 * 1.65 / (4 * 0.5 * 3), 1e-12);
    check_equal(dt, first);
}

/* What is held does not fall; a solid that stands still has no limit. */
static void of_a_solid_at_rest(void **state) {
    (void)state;
    double first;
    const char *const held[] = {"solid.body_force=[0, 0.04, 0]",
                                "solid.constraints=[{low: [0, 0, 0], high: [16, 8, 12], directions: xyz}]",
                                "solid.bodies.fast.velocity=[0, 0, 0]", "solid.bodies.slow.velocity=[0, 0, 0]"};
    first_step(0, 4, held, &first);
    check_equal(first, INFINITY);
    const char *const rigid[] = {"stages.go.solid=rigid", held[2], held[3]};
    first_step(0, 3, rigid, &first);
    check_equal(first, INFINITY);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(by_velocity), cmocka_unit_test(by_weight),
                                       cmocka_unit_test(by_diffusion), cmocka_unit_test(of_a_solid_at_rest)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
