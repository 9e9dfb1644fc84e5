/* The watch of the load by probes, beside a slab between two slits of 16 cells in all, along which a body force drives
 * the fluid: the force on the slab by the balance of the whole domain, and the part of it that the probes miss. */
#include "coupling/control/probe_watch.h"
#include "coupling/run.h"
#include "coupling/step.h"
#include "fluid/fluid.h"
#include "tests/check.h"
#include "tests/coupling/slab.h"

#include <math.h>

/* N: body force times the volumes of fluid and slab, with a density of 1. */
static const double ON_FLUID = 2 * 0.25;

static struct run *begin(const char *stage, struct scene **scene) {
    *scene = scene_of(slab, stage, 0, NULL);
    struct run *r = run_new(*scene);
    step_begin_stage(r);
    return r;
}

static void advance(struct run *r, int steps) {
    for (int n = 0; n < steps; n++) {
        step_advance(r);
        probe_watch_note(r);
    }
}

/* The flow is steady: the slab bears all of the force on the fluid beside it. The shear at the tips, two cells off the
 * wall, is 1 - 2/8 of that at the wall, or a little more, as the roots stand within the wall. */
static void what_the_probes_miss(void **state) {
    (void)state;
    struct scene *scene;
    struct run *r = begin("stages: [{name: hold, steps: 3000, solid: rigid}]\n", &scene);
    advance(r, 2500);
    probe_watch_check(r, 0);
    check_equal(r->watch.probes.missing, 0);
    probe_watch_check(r, 1);
    check_relative(r->watch.probes.missing, 1 - r->load[0] / ON_FLUID, 2e-3);
    check_between(r->watch.probes.missing, 0.2, 0.25);
    check_equal(r->watch.probes.logged, r->watch.probes.missing);
    run_free(r);
    scene_free(scene);
}

/* Momentum along x of the fluid beside the slab when the watch's window began, N s. */
static double outside(struct run *r) {
    double momentum[3];
    fluid_measures_momentum(r->fluid, momentum, NULL);
    return momentum[0] - par_sum(r->watch.probes.first[0]);
}

/* The fluid beside the slab gets the body force, and loses to the slab what its momentum does not gain. */
static void what_a_free_slab_gets(void **state) {
    (void)state;
    struct scene *scene;
    struct run *r = begin("stages: [{name: free, steps: 100, time_step: 2.0e-4, damping_relative: 3.0e+4}]\n", &scene);
    const struct probe_watch *w = &r->watch.probes;
    advance(r, 1);
    const double since = r->t, before = outside(r);
    advance(r, 60);
    const double passed = r->t - since, load = w->loads[0] / passed;
    probe_watch_check(r, 1);
    const double gained = (outside(r) - before) / passed; /* a new window has begun */
    check_relative(load / (1 - w->missing), ON_FLUID - gained, 1e-9);
    check_above(gained, 0.1 * ON_FLUID);
    run_free(r);
    scene_free(scene);
}

/* Slab and fluid move together: nothing acts but round-off, and that is no load. */
static void what_moves_with_the_fluid(void **state) {
    (void)state;
    struct scene *scene =
        scene_of(slab, "stages: [{name: go, steps: 100, time_step: 2.0e-4}]\n", 3,
                 (const char *const[]){"fluid.body_force=[0, 0, 0]", "solid.bodies.slab.velocity=[2, 0, 0]",
                                       "fluid.initial.velocity=[2, 0, 0]"});
    struct run *r = run_new(scene);
    step_begin_stage(r);
    advance(r, 40);
    probe_watch_check(r, 1);
    check_equal(r->watch.probes.logged, 0);
    run_free(r);
    scene_free(scene);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(what_the_probes_miss), cmocka_unit_test(what_a_free_slab_gets),
                                       cmocka_unit_test(what_moves_with_the_fluid)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
