/* What is said of a flow that has no way out: a channel with a block across all of it, across half of its inlet, or
 * away from everything. */
#include "coupling/control/blocked.h"
#include "tests/coupling/scene_of.h"

#include "tests/check.h"
#include "coupling/step.h"

#include <stdio.h>

static const char *const channel = "title: test\n"
                                   "domain: {size: [0.16, 0.08, 0.08], cells: [16, 8, 8]}\n"
                                   "fluid:\n"
                                   "  density: 1000\n"
                                   "  viscosity: 1.0e-3\n"
                                   "  sides:\n"
                                   "    x_low: {type: inflow, profile: uniform, bulk_velocity: 0.1}\n"
                                   "    x_high: {type: outflow}\n"
                                   "    y_low: {type: slip}\n    y_high: {type: slip}\n"
                                   "    z_low: {type: slip}\n    z_high: {type: slip}\n";
static const char *const driven = "title: test\n"
                                  "domain: {size: [0.16, 0.08, 0.08], cells: [16, 8, 8]}\n"
                                  "fluid:\n"
                                  "  density: 1000\n"
                                  "  viscosity: 1.0e-3\n"
                                  "  driving: {type: bulk_velocity, direction: x, value: 0.1}\n"
                                  "  sides:\n"
                                  "    x_low: {type: periodic}\n    x_high: {type: periodic}\n"
                                  "    y_low: {type: slip}\n    y_high: {type: slip}\n"
                                  "    z_low: {type: slip}\n    z_high: {type: slip}\n";

/* A block from low to high, in cells; how many sentences, and the first. */
static int said_of(const char *fluid, const int low[3], const int high[3], char first[BLOCKED_SENTENCE]) {
    char text[1024], sentence[BLOCKED_MAX][BLOCKED_SENTENCE] = {""};
    snprintf(text, sizeof text,
             "solid:\n"
             "  materials: [{name: soft, youngs_modulus: 1.0e6, density: 3000}]\n"
             "  bodies: [{name: block, shape: box, low: [%g, %g, %g], high: [%g, %g, %g]}]\n"
             "coupling: {medium: {low: [0, 0, 0], high: [0.16, 0.08, 0.08]}}\n"
             "stages: [{name: flow, steps: 1, time_step: 1.0e-3, solid: rigid}]\n",
             0.01 * low[0], 0.01 * low[1], 0.01 * low[2], 0.01 * high[0], 0.01 * high[1], 0.01 * high[2]);
    struct scene *scene = scene_of(fluid, text, 0, NULL);
    struct run *r = run_new(scene);
    step_begin_stage(r);
    const int n = blocked_of(r, sentence);
    snprintf(first, BLOCKED_SENTENCE, "%s", sentence[0]);
    run_free(r);
    scene_free(scene);
    return n;
}

static void a_channel(void **state) {
    (void)state;
    char first[BLOCKED_SENTENCE];
    assert_int_equal(said_of(channel, (int[]){6, 2, 2}, (int[]){10, 6, 6}, first), 0);
    assert_int_equal(said_of(channel, (int[]){0, 0, 0}, (int[]){4, 8, 4}, first), 1); /* stands in the inlet */
    assert_int_equal(strncmp(first, "50 % of x_low have no way out", 29), 0);
    assert_int_equal(said_of(channel, (int[]){6, 0, 0}, (int[]){10, 8, 8}, first), 1);
    assert_int_equal(strncmp(first, "100 % of x_low have no way out", 30), 0);
    assert_int_equal(said_of(channel, (int[]){6, 0, 0}, (int[]){10, 8, 7}, first), 0); /* one row of cells is a way */
}

static void a_driven_flow(void **state) {
    (void)state;
    char first[BLOCKED_SENTENCE];
    assert_int_equal(said_of(driven, (int[]){6, 0, 0}, (int[]){10, 8, 7}, first), 0);
    assert_int_equal(said_of(driven, (int[]){6, 0, 0}, (int[]){10, 8, 8}, first), 1);
    assert_int_equal(strncmp(first, "no way along x", 14), 0);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(a_channel), cmocka_unit_test(a_driven_flow)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
