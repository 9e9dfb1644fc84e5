/* What a fluid's step costs where bonds may break: read from the measured points; an automatic step keeps to it. */
#include "coupling/control/timescale.h"
#include "coupling/control/time_step.h"
#include "coupling/run.h"
#include "coupling/step.h"
#include "tests/check.h"
#include "tests/coupling/scene_of.h"

#include <math.h>
#include <stdio.h>

/* The rows of docs/choosing.md and of cases/verification/cost/README.md, to a per cent. */
static void measured_points(void **state) {
    (void)state;
    check_close(timescale_excess(0.8), 1.2, 1e-12);
    check_close(timescale_excess(1.2), 2.2, 1e-12);
    check_close(timescale_excess(2.4), 5.3, 1e-12);
    check_close(timescale_excess(19), 23.9, 1e-12);
    check_equal(timescale_excess(0.3), 0);
    check_close(timescale_early(0.8), 0.3, 1e-12);
    check_close(timescale_early(1.2), 1.7, 1e-12);
    check_close(timescale_early(2.4), 6.4, 1e-12);
    check_close(timescale_early(19), 23.3, 1e-12);
    check_equal(timescale_early(0.3), 0);
    for (double step = 0.3; step < 100; step *= 1.1) {
        check_at_least(timescale_excess(1.1 * step), timescale_excess(step));
        check_at_least(timescale_early(1.1 * step), timescale_early(step));
    }
}

static const char *const block =
    "title: test\n"
    "domain: {size: [0.016, 0.016, 0.016], cells: [16, 16, 16]}\n"
    "fluid:\n"
    "  density: 1000\n"
    "  viscosity: 1.0e-6\n"
    "  initial: {velocity: [0.1, 0, 0]}\n" SCENE_OF_PERIODIC_SIDES "solid:\n"
    "  materials: [{name: m, youngs_modulus: 1.0e6, density: 3000, fracture_energy: 0.1}]\n"
    "  bodies: [{name: a, shape: box, low: [0.004, 0.004, 0.004], high: [0.012, 0.012, 0.012]}]\n";

struct seen {
    double step, stable, excess, early, advised;
    int counts;
};

static struct seen stepped(const char *stage, const char *set) {
    char stages[128];
    const char *const change[] = {set};
    snprintf(stages, sizeof stages, "stages: [{name: break, steps: 3, %s}]\n", stage);
    struct scene *scene = scene_of(block, stages, set != NULL, change);
    struct run *r = run_new(scene);
    struct seen seen = {0};
    step_begin_stage(r);
    seen.stable = solid_stable_of(&r->solid_rates, SOLID_VERLET, 0, NULL);
    seen.counts = timescale_breaking(r, &seen.step, &seen.excess, &seen.early, &seen.advised);
    step_advance(r);
    if (seen.counts) check_at_least(seen.step * (1 + 1e-12), r->dt); /* what was foreseen is not exceeded */
    seen.step = r->dt;
    run_free(r);
    scene_free(scene);
    return seen;
}

/* The fluid alone would allow 0.36 of 3.5 ms or more, the solid's stable step is about 0.03 ms. */
static void an_automatic_step_keeps_to_it(void **state) {
    (void)state;
    struct seen s = stepped("solid: elastic", NULL);
    check_equal(s.counts, 1);
    check_relative(s.step, 1.2 * s.stable, 1e-9);
    check_close(s.excess, 2.2, 1e-6);
    check_close(s.early, 1.7, 1e-6);
    check_relative(timescale_excess(s.advised / s.stable), 2, 1e-6);
    s = stepped("breakage: false", NULL);
    check_equal(s.counts, 0);
    check_at_least(s.step, 2 * s.stable);
    s = stepped("damping_relative: 1.0e9", NULL);
    check_equal(s.counts, 0);
    s = stepped("solid: elastic", "solid.materials.0.density=30000");
    check_equal(s.counts, 0);
    s = stepped("time_step: 1.0e-4, substeps: 6", NULL);
    check_equal(s.counts, 1);
    check_relative(s.step, 1e-4, 1e-12);
    check_relative(s.excess, timescale_excess(1e-4 / s.stable), 1e-9);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(measured_points),
                                       cmocka_unit_test(an_automatic_step_keeps_to_it)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
