/* What is said of bodies whose imposed motion displaces fluid without a way out: a piston in a closed vessel, with gaps
 * and without, behind an outflow, in a ring, a rod that comes in, plugs that nothing drives, blocks that are held. */
#include "coupling/control/piston.h"
#include "coupling/interface/deposit.h"
#include "coupling/step.h"
#include "tests/check.h"
#include "tests/coupling/scene_of.h"

#include <stdio.h>

static const char *const walls = "    y_low: {type: wall}\n    y_high: {type: wall}\n"
                                 "    z_low: {type: wall}\n    z_high: {type: wall}\n";
static const char *const vessel = "    x_low: {type: wall}\n    x_high: {type: wall}\n";
static const char *const duct = "    x_low: {type: wall}\n    x_high: {type: pressure, pressure: 0}\n";
static const char *const open_duct = "    x_low: {type: pressure, pressure: 0}\n    x_high: {type: outflow}\n";
static const char *const ring = "    x_low: {type: periodic}\n    x_high: {type: periodic}\n";

/* A block from low to high, in cells of 1 cm, with more of the section solid. Whether a sentence is said. */
static int said_of(const char *ends, const int low[3], const int high[3], const char *more, char *sentence) {
    char fluid[512], text[1024];
    snprintf(fluid, sizeof fluid,
             "title: test\ndomain: {size: [0.16, 0.08, 0.08], cells: [16, 8, 8]}\n"
             "fluid:\n  density: 1000\n  viscosity: 1.0e-3\n  sides:\n%s%s",
             ends, walls);
    snprintf(text, sizeof text,
             "solid:\n"
             "  materials: [{name: soft, youngs_modulus: 1.0e6, density: 3000}]\n"
             "  bodies: [{name: block, shape: box, low: [%g, %g, %g], high: [%g, %g, %g]}%s\n"
             "coupling: {medium: {low: [0, 0, 0], high: [0.16, 0.08, 0.08]}}\n"
             "stages: [{name: move, steps: 1, time_step: 1.0e-3}]\n",
             0.01 * low[0], 0.01 * low[1], 0.01 * low[2], 0.01 * high[0], 0.01 * high[1], 0.01 * high[2], more);
    struct scene *scene = scene_of(fluid, text, 0, NULL);
    struct run *r = run_new(scene);
    step_begin_stage(r);
    deposit_update(r);
    const double porosity = medium_measure_porosity(r->medium);
    sentence[0] = '\0';
    const int is = piston_of(r, sentence);
    check_equal(medium_measure_porosity(r->medium), porosity); /* the bodies' own deposit is there again */
    run_free(r);
    scene_free(scene);
    return is;
}

#define ALL "low: [0, 0, 0], high: [0.16, 0.08, 0.08]"
#define DRIVEN "]\n  constraints: [{" ALL ", velocity: [0.1, 0, 0]}]"
static const int low[3] = {6, 0, 0}, high[3] = {10, 8, 8}, narrow[3] = {10, 8, 7}, in_y[3] = {10, 7, 8};

static void pistons(void **state) {
    (void)state;
    char said[PISTON_SENTENCE];
    check_equal(said_of(vessel, low, high, DRIVEN, said), 1);
    assert_string_equal(said,
                        "the imposed motion of block, 0.1 m/s at most, displaces 0.00064 m3/s of fluid into "
                        "0.000384 m3 that have no way out that the cells resolve: the fluid is pressed through the "
                        "solid");
    check_equal(said_of(vessel, low, narrow, DRIVEN, said), 0); /* one row of cells is a way */
    check_equal(said_of(vessel, low, in_y, DRIVEN, said), 0);
    check_equal(said_of(duct, low, high, DRIVEN, said), 1); /* what is before it leaves, nothing comes in behind it */
    assert_int_equal(
        strncmp(said, "the imposed motion of block, 0.1 m/s at most, draws 0.00064 m3/s of fluid from", 78), 0);
    check_equal(said_of(open_duct, low, high, DRIVEN, said), 0);
    check_equal(said_of(ring, low, high, DRIVEN, said), 0);
    /* of two bodies together; alone neither shuts the vessel */
    static const char *const halves = ", {name: other, shape: box, low: [0.06, 0.04, 0], high: [0.1, 0.08, 0.08]}]\n"
                                      "  constraints: [{" ALL ", velocity: [0.1, 0, 0]}]";
    check_equal(said_of(vessel, low, (int[]){10, 4, 8}, halves, said), 1);
    assert_int_equal(strncmp(said, "the imposed motion of the bodies, 0.1 m/s", 41), 0);
    /* its end alone is driven; across the duct; by a displacement over time, at most by 0.2 m/s */
    check_equal(said_of(vessel, low, high,
                        "]\n  constraints: [{low: [0.06, 0, 0], high: [0.07, 0.08, 0.08], velocity: [0.1, 0, 0]}]",
                        said),
                1);
    check_equal(said_of(vessel, low, high, "]\n  constraints: [{" ALL ", velocity: [0, 0.1, 0]}]", said), 0);
    check_equal(said_of(vessel, low, high,
                        "]\n  constraints: [{" ALL
                        ", displacement: [0.01, 0, 0], time: [[0, 0], [0.1, 0.5], [0.125, 1]]}]",
                        said),
                1);
    check_equal(strncmp(said, "the imposed motion of block, 0.2 m/s at most, displaces 0.00128 m3/s", 66), 0);
}

/* A piston that stands at a wall leaves room behind it as it moves: with a gap the fluid comes there. A rod that comes
 * in through a wall displaces fluid for which there is no room. */
static void at_a_wall(void **state) {
    (void)state;
    char said[PISTON_SENTENCE];
    check_equal(said_of(vessel, (int[]){0, 0, 0}, (int[]){4, 8, 7}, DRIVEN, said), 0);
    check_equal(said_of(vessel, (int[]){0, 0, 0}, (int[]){4, 8, 8}, DRIVEN, said), 1);
    check_equal(said_of(vessel, (int[]){-8, 2, 2}, (int[]){4, 6, 6},
                        "]\n  constraints: [{low: [-0.08, 0, 0], high: [0.16, 0.08, 0.08], velocity: [0.1, 0, 0]}]",
                        said),
                1);
    assert_int_equal(strncmp(said, "the imposed motion of block, 0.1 m/s at most, displaces 0.00016 m3/s", 68), 0);
    check_equal(said_of(vessel, (int[]){11, 2, 2}, (int[]){15, 6, 6}, DRIVEN, said), 0); /* a cell before a wall */
}

static void what_gives_way(void **state) {
    (void)state;
    char said[PISTON_SENTENCE];
    check_equal(said_of(vessel, low, high, "]", said), 0);
    check_equal(said_of(vessel, low, high, "]\n  constraints: [{" ALL "}]", said), 0);
    /* stretched: its two ends are driven apart */
    check_equal(said_of(vessel, low, high,
                        "]\n  constraints: [{low: [0.06, 0, 0], high: [0.07, 0.08, 0.08]},"
                        " {low: [0.09, 0, 0], high: [0.1, 0.08, 0.08], velocity: [0.1, 0, 0]}]",
                        said),
                0);
    /* a free plug between the piston and the outflow moves on; one that is held does not */
    static const char *const plug = ", {name: plug, shape: box, low: [0.12, 0, 0], high: [0.14, 0.08, 0.08]}]\n"
                                    "  constraints: [{low: [0, 0, 0], high: [0.1, 0.08, 0.08], velocity: [0.1, 0, 0]}";
    char more[512];
    snprintf(more, sizeof more, "%s]", plug);
    check_equal(said_of(open_duct, low, high, more, said), 0);
    snprintf(more, sizeof more, "%s, {low: [0.12, 0, 0], high: [0.14, 0.08, 0.08]}]", plug);
    check_equal(said_of(open_duct, low, high, more, said), 1);
    assert_non_null(strstr(said, "into 0.000128 m3 that have"));
}

/* Free bodies that something pushes against a closed part of the fluid. */
static void pushed(void **state) {
    (void)state;
    char said[PISTON_SENTENCE];
    static const char *const load = "]\n  loads: [{" ALL ", force: [1, 0, 0], time: [[0, 0], [1, 1]]}]";
    check_equal(said_of(vessel, low, high, load, said), 1);
    assert_string_equal(said,
                        "body block is pushed along x, and the 0.000384 m3 of fluid before it have no way out that the "
                        "cells resolve: it would stand still, and moves because the fluid is pressed through the "
                        "solid");
    check_equal(said_of(vessel, low, high, "]\n  body_force: [-9.81, 0, 0]", said), 1);
    assert_non_null(strstr(said, "body block is pushed along x"));
    check_equal(said_of(vessel, low, high,
                        ", {name: plug, shape: box, low: [0.12, 0, 0], high: [0.14, 0.08, 0.08], "
                        "velocity: [0.1, 0, 0]}]",
                        said),
                1);
    assert_non_null(strstr(said, "body plug is pushed along x, and the 0.000128 m3 of fluid before it"));
    check_equal(said_of(duct, low, high, load, said), 1); /* nothing comes in behind it */
    assert_non_null(strstr(said, "of fluid behind it"));
    /* with a gap, or an opening; across the duct; nothing pushes; it stands at the wall that it is pushed to */
    check_equal(said_of(vessel, low, narrow, load, said), 0);
    check_equal(said_of(open_duct, low, high, load, said), 0);
    check_equal(said_of(ring, low, high, load, said), 0);
    check_equal(said_of(vessel, low, high, "]\n  body_force: [0, -9.81, 0]", said), 0);
    check_equal(said_of(vessel, low, high, "]", said), 0);
    check_equal(said_of(vessel, (int[]){12, 0, 0}, (int[]){16, 8, 8}, load, said), 0);
    /* against a held block, which bears it; and one that is held a cell before it */
    static const char *const held = ", {name: held, shape: box, low: [%g, 0, 0], high: [0.14, 0.08, 0.08]}]\n"
                                    "  constraints: [{low: [%g, 0, 0], high: [0.16, 0.08, 0.08]}]\n"
                                    "  loads: [{low: [0, 0, 0], high: [0.1, 0.08, 0.08], force: [1, 0, 0]}]";
    char more[512];
    snprintf(more, sizeof more, held, 0.1, 0.1);
    check_equal(said_of(vessel, low, high, more, said), 0);
    snprintf(more, sizeof more, held, 0.12, 0.12);
    check_equal(said_of(vessel, low, high, more, said), 1);
}

/* Behind more closed pores than a list of some hundred holds: a held block with 512 of them, numbered before the
 * duct. */
static void behind_many_pores(void **state) {
    (void)state;
    static const char *const fluid = "title: test\ndomain: {size: [0.16, 0.16, 0.32], cells: [16, 16, 32]}\n"
                                     "fluid:\n  density: 1000\n  viscosity: 1.0e-3\n  sides:\n"
                                     "    x_low: {type: wall}\n    x_high: {type: wall}\n"
                                     "    y_low: {type: wall}\n    y_high: {type: wall}\n"
                                     "    z_low: {type: wall}\n    z_high: {type: wall}\n";
    static const char *const solid = "solid:\n"
                                     "  materials: [{name: soft, youngs_modulus: 1.0e6, density: 3000}]\n"
                                     "  bodies:\n"
                                     "    - {name: block, shape: box, low: [0, 0, 0], high: [0.16, 0.16, 0.16],\n"
                                     "       cavities: {period: 0.02, radius: 0.006, centre: [0.005, 0.005, 0.005]}}\n"
                                     "    - {name: piston, shape: box, low: [0, 0, 0.2], high: [0.16, 0.16, 0.24]}\n"
                                     "  constraints:\n"
                                     "    - {low: [0, 0, 0], high: [0.16, 0.16, 0.16]}\n"
                                     "    - {low: [0, 0, 0.2], high: [0.16, 0.16, 0.24], velocity: [0, 0, 0.1]}\n"
                                     "coupling: {medium: {low: [0, 0, 0], high: [0.16, 0.16, 0.32]}}\n"
                                     "stages: [{name: move, steps: 1, time_step: 1.0e-3}]\n";
    char said[PISTON_SENTENCE] = "";
    struct scene *scene = scene_of(fluid, solid, 0, NULL);
    struct run *r = run_new(scene);
    step_begin_stage(r);
    deposit_update(r);
    check_equal(piston_of(r, said), 1);
    assert_non_null(strstr(said, "displaces 0.00256 m3/s of fluid into 0.00205 m3"));
    run_free(r);
    scene_free(scene);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(pistons), cmocka_unit_test(at_a_wall),
                                       cmocka_unit_test(what_gives_way), cmocka_unit_test(pushed),
                                       cmocka_unit_test(behind_many_pores)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
