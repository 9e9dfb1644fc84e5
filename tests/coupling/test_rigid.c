/* A solid that is rigid in every stage keeps its particles' places and its surface, and nothing else. */
#include "base/memory.h"
#include "coupling/run.h"
#include "coupling/step.h"
#include "tests/check.h"
#include "tests/coupling/scene_of.h"

#include <stdio.h>

static const char *const scene_text =
    "title: test\n"
    "domain: {size: [32, 32, 32], cells: [32, 32, 32]}\n"
    "fluid:\n"
    "  density: 1\n  viscosity: 1\n"
    "  driving: {type: pressure_gradient, direction: z, value: 1.0e-6}\n" SCENE_OF_PERIODIC_SIDES "solid:\n"
    "  materials:\n    - {name: rigid, youngs_modulus: 1, density: 1}\n"
    "  bodies:\n    - {name: block, shape: box, low: [4, 4, 4], high: [28, 28, 28]}\n"
    "coupling: {}\n";

/* Bytes a particle of the solid and of the coupling after a step; no body has ghosts on one rank. */
static void bytes_of(const char *solid, double bytes[2]) {
    char stages[128];
    snprintf(stages, sizeof stages, "stages: [{name: flow, steps: 1, time_step: 0.01, solid: %s}]\n", solid);
    struct scene *scene = scene_of(scene_text, stages, 0, NULL);
    struct run *r = run_new(scene);
    step_begin_stage(r);
    step_advance(r);
    const double n = par_sum((double)(r->solid->n + r->solid->n_ghost));
    bytes[0] = par_sum((double)memory_bytes(MEMORY_SOLID)) / n;
    bytes[1] = par_sum((double)memory_bytes(MEMORY_COUPLING)) / n;
    run_free(r);
    scene_free(scene);
    check_equal(memory_bytes(MEMORY_SOLID), 0);
    check_equal(memory_bytes(MEMORY_COUPLING), 0);
}

/* Places, displacements, velocities and loads (96 bytes), volume, flag and body (10), and of the 3,174 particles of the
 * surface, which are 23 % of this block, 61 bytes each. */
static void keeps_places_and_surface(void **state) {
    (void)state;
    double rigid[2], elastic[2];
    bytes_of("rigid", rigid);
    bytes_of("elastic", elastic);
    print_message("bytes a particle, solid and coupling: rigid %.1f and %.1f, elastic %.1f and %.1f\n", rigid[0],
                  rigid[1], elastic[0], elastic[1]);
    check_below(rigid[0], 106 + 0.23 * 61 + 5);
    check_above(elastic[0], 3 * rigid[0]);
    check_below(rigid[1], elastic[1] - 24);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(keeps_places_and_surface)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
