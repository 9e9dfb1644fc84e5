/* The fluid inside a solid that is connected from one end of the sample to the other: straight ducts. */
#include "coupling/interface/deposit.h"
#include "coupling/load/reaction.h"
#include "coupling/run.h"
#include "coupling/step.h"
#include "tests/check.h"
#include "tests/coupling/scene_of.h"

#include <math.h>
#include <stdio.h>

enum { ACROSS = 16, DUCT = 6 }; /* m */

static const double GRADIENT = 1e-6;

static const char *const scene_text =
    "title: test\n"
    "domain: {size: [16, 16, %d], cells: [%d, %d, %d]}\n"
    "fluid:\n"
    "  density: 1\n  viscosity: 1\n  diffusion: %s\n"
    "  driving: {type: pressure_gradient, direction: z, value: %g}\n" SCENE_OF_PERIODIC_SIDES "solid:\n"
    "  materials:\n    - {name: rigid, youngs_modulus: 1, density: 1, horizon_ratio: 2}\n"
    "  bodies:\n"
    "    - name: block\n      shape: box\n      low: [0, 0, %d]\n      high: [16, 16, %d]\n"
    "      holes: [{shape: box, low: [5, 5, %d], high: [11, 11, %d]}]\n"
    "coupling:\n  load: %s\n  medium: {low: [0, 0, %d], high: [16, 16, %d], direction: z}\n";

struct found {
    double k, load; /* load: along z, over the driving on the whole domain */
};

/* A block of that length with a square duct through it, with layers of fluid before and behind it, n cells a metre. */
static struct found duct(int n, int length, int layer, const char *diffusion, const char *load, int steps,
                         double step) {
    char text[2048], stages[256];
    const int end = layer + length, all = end + layer;
    snprintf(text, sizeof text, scene_text, all, n * ACROSS, n * ACROSS, n * all, diffusion, GRADIENT, layer, end,
             layer, end, load, layer, end);
    snprintf(stages, sizeof stages, "stages: [{name: flow, steps: %d, time_step: %.10e, solid: rigid}]\n", steps, step);
    struct scene *scene = scene_of(text, stages, 0, NULL);
    struct run *r = run_new(scene);
    step_begin_stage(r);
    while (r->stage_step < scene->stage[0].steps) step_advance(r);
    struct found found = {.k = deposit_measure(r).permeability};
    r->load_kind->sample(r);
    found.load = r->load[2] / (GRADIENT * ACROSS * ACROSS * all);
    run_free(r);
    scene_free(scene);
    return found;
}

/* Of a square duct of side w in a section A: 0.0351442537 w^4/A. */
static const double EXACT = 0.0351442537 * DUCT * DUCT * DUCT * DUCT / (ACROSS * ACROSS);

/* Walls on faces of cells stand 0.28 - 0.27 cells too far out (docs/retraction.md), and the profile's curvature under
 * the kernel is made up for by the driving that is taken from the spread solid. With the driving taken from the solid
 * cells alone k was 9 and 2.9 % too large. */
static void not_driven_in_an_endless_block(void **state) {
    (void)state;
    const struct found coarse = duct(1, 4, 0, "explicit", "reaction", 400, 0.1375),
                       fine = duct(2, 4, 0, "explicit", "reaction", 1600, 0.1375 / 4),
                       implicit = duct(1, 4, 0, "implicit", "reaction", 60, 2);
    print_message("k over the exact one: %.4f, %.4f at twice the cells, implicit %.4f; load over the driving's %.6f\n",
                  coarse.k / EXACT, fine.k / EXACT, implicit.k / EXACT, coarse.load);
    check_close(coarse.k / EXACT, 1, 0.015);
    check_close(fine.k / EXACT, 1, 0.005);
    check_close(implicit.k / EXACT, coarse.k / EXACT, 0.01);
    check_close(coarse.load, 1, 1e-3);
    check_close(fine.load, 1, 1e-3);
    check_close(implicit.load, 1, 1e-3);
}

static const char *const slit_text =
    "title: test\n"
    "domain: {size: [8, %d, 8], cells: [8, %d, 8]}\n"
    "fluid:\n"
    "  density: 1\n  viscosity: 1\n  diffusion: implicit\n"
    "  driving: {type: pressure_gradient, direction: x, value: %g}\n" SCENE_OF_PERIODIC_SIDES "solid:\n"
    "  materials:\n    - {name: rigid, youngs_modulus: 1, density: 1, horizon_ratio: 2}\n"
    "  bodies:\n    - {shape: box, low: [0, %d, 0], high: [8, %d, 8]}\n"
    "coupling: {medium: {low: [0, 0, 0], high: [8, %d, 8]}}\n"
    "stages: [{name: flow, steps: 100, time_step: 5, solid: rigid}]\n";

/* k over that of h^3/12, of a slit of h cells between faces of cells, in a period with a wall of 8 cells. */
static double slit(int h) {
    char text[2048];
    snprintf(text, sizeof text, slit_text, 8 + h, 8 + h, GRADIENT, h / 2, h / 2 + 8, 8 + h);
    struct scene *scene = scene_of(text, "", 0, NULL);
    struct run *r = run_new(scene);
    step_begin_stage(r);
    while (r->stage_step < scene->stage[0].steps) step_advance(r);
    const double k = deposit_measure(r).permeability;
    run_free(r);
    scene_free(scene);
    return k * (8 + h) / (h * h * h / 12.0);
}

/* Of what is left 6 (0.28 - 0.27)/h is the retraction, which is one number for faces of any place and direction, and
 * 1/(2 h^2) is the sum over cells in place of the profile's integral. With the driving taken from the solid cells alone
 * k is 14, 6.6 and 3.9 % too large at four, six and eight cells. */
static void slits_of_a_few_cells(void **state) {
    (void)state;
    for (int h = 4; h <= 8; h += 2) {
        const double k = slit(h), known = 6 * 0.01 / h + 0.5 / (h * h);
        print_message("slit of %d cells: k over the exact one %.4f\n", h, k);
        check_close(k, 1 + known, 0.008);
    }
}

/* What the walls of a block between layers of fluid let through would grow with its length. The resistance L/k of 32
 * cells more is that of a duct, whatever the length is; the ends' drops out. */
static void no_leak_in_a_long_block(void **state) {
    (void)state;
    double resistance[3];
    for (int n = 0; n < 3; n++) {
        const int length = 16 << n;
        resistance[n] = length / duct(1, length, 4, "implicit", "reaction", 60, 2).k * EXACT;
    }
    const double k[2] = {16 / (resistance[1] - resistance[0]), 32 / (resistance[2] - resistance[1])};
    print_message("k over the exact one: %.4f from 16 to 32 cells, %.4f to 64\n", k[0], k[1]);
    check_close(k[1], k[0], 0.01);
    check_close(k[1], 0.97, 0.05);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(not_driven_in_an_endless_block),
        cmocka_unit_test(slits_of_a_few_cells),
        cmocka_unit_test(no_leak_in_a_long_block),
    };
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
