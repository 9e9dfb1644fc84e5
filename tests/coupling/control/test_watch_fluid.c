/* The watch of the balances of a solid in a fluid: faults that are seeded into a run are found, and nothing is said of
 * one without them. */
#include "coupling/control/watch.h"
#include "tests/coupling/control/watched.h"

#include <math.h>

/* A light block that is released in a stream: drag, waves, and the inner fluid's inertia. */
static const char *const flooded = "title: test\n"
                                   "domain: {size: [20, 10, 10], cells: [20, 10, 10]}\n"
                                   "fluid:\n"
                                   "  density: 1\n"
                                   "  viscosity: 0.05\n"
                                   "  initial: {velocity: [0.1, 0, 0]}\n" SCENE_OF_PERIODIC_SIDES "solid:\n"
                                   "  materials: [{name: soft, youngs_modulus: 20, density: 0.2}]\n"
                                   "  bodies: [{shape: box, low: [4, 3, 3], high: [10, 7, 7]}]\n";
static const char *const flooded_verlet = "stages:\n  - {name: meet, steps: 100, time_step: 0.2, integrator: verlet}\n";
static const char *const flooded_rk3 =
    "stages:\n  - {name: meet, steps: 100, time_step: 0.2, integrator: rk3, safety: 0.3}\n";

/* The drag is an impulse between substeps, whose work is that of the speeds before and after it. */
static void closes_in_a_fluid(void **state) {
    (void)state;
    const char *const stage[] = {flooded_verlet, flooded_rk3};
    for (int k = 0; k < 2; k++) {
        const struct outcome o = watch_of(flooded, stage[k], NULL, 0), bad = watch_of(flooded, stage[k], grows, 0.1);
        print_message("exchanged %.3g J, off by %.2g of it, with a fault by %.2g\n", o.seen.exchanged,
                      o.seen.off / o.seen.exchanged, bad.seen.off / bad.seen.exchanged);
        check_above(o.seen.exchanged, 1e-3);
        check_below(fabs(o.seen.off), (k == 1 ? 1e-3 : 1e-6) * o.seen.exchanged);
        check_equal(o.ended, 0);
        check_equal(bad.ended, 1);
        check_above(o.seen.momentum.exchanged, 1e-3);
        check_below(o.seen.momentum.off, 1e-12 * o.seen.momentum.exchanged);
        check_equal(o.seen.momentum.logged, 0);
        check_equal(o.seen.logged_adjoint, 0);
        check_equal(o.seen.logged_reaction, 0);
        check_equal(o.seen.inner.begun, 1);
        check_below(o.seen.inner.off, 1e-10);
        check_above(bad.seen.momentum.logged, 0.01);
    }
}

/* A block with fluid deep inside, which is pushed. */
static const char *const thick = "title: test\n"
                                 "domain: {size: [20, 14, 14], cells: [20, 14, 14]}\n"
                                 "fluid:\n"
                                 "  density: 1\n"
                                 "  viscosity: 0.05\n"
                                 "  body_force: [0.01, 0, 0]\n"
                                 "  initial: {velocity: [0.1, 0.03, 0]}\n" SCENE_OF_PERIODIC_SIDES "solid:\n"
                                 "  materials: [{name: soft, youngs_modulus: 20, density: 2}]\n"
                                 "  bodies: [{shape: box, low: [4, 2, 3], high: [12, 10, 11]}]\n";

/* What the inner fluid has given too much, and takes off a step later, is forgotten in part; and a velocity that is
 * not that of the last step. */
static void forgets(struct run *r, double size) {
    for (int c = 0; c < 3; c++)
        for (int h = 0; h < r->solid->n; h++) r->inner[1].excess[c][h] *= 1 - size;
}
static void misreads(struct run *r, double size) {
    for (int h = 0; h < r->solid->n; h++) r->inner[2].velocity[0][h] += 0.1 * size;
}

/* The inner fluid gives back what its momentum changes by, in a fluid that a body force drives too. */
static void inner_fluid_gives_back(void **state) {
    (void)state;
    static fault *const spoil[] = {NULL, forgets, misreads};
    for (int k = 0; k < 3; k++) {
        if (check_skips(k, 2)) continue;
        const struct outcome o = watch_of(thick, flooded_verlet, spoil[k], k == 1 ? 0.2 : 0.02);
        print_message("the inner fluid is off by %.2g, before the fault by %.2g\n", o.seen.inner.off,
                      o.clean.inner.off);
        check_equal(o.clean.inner.begun, 1);
        check_equal(o.ended, 0);
        if (!spoil[k]) check_below(o.seen.inner.off, 1e-10);
        if (spoil[k]) check_above(o.seen.inner.logged, 0.01);
        check_equal(o.clean.inner.logged, 0);
        check_equal(o.seen.logged_reaction, 0);
    }
}

/* Particles that cracks have cut off carry no fluid, and are given round-off; a slip side takes a part of their drag.
 * Neither is said. */
static void particles_alone_give_nothing(void **state) {
    (void)state;
    static const char *const dust =
        "title: test\n"
        "domain: {size: [10, 10, 10], cells: [10, 10, 10]}\n"
        "fluid:\n"
        "  density: 1\n"
        "  viscosity: 0.1\n"
        "  sides:\n"
        "    x_low: {type: periodic}\n    x_high: {type: periodic}\n"
        "    y_low: {type: slip}\n    y_high: {type: slip}\n"
        "    z_low: {type: periodic}\n    z_high: {type: periodic}\n"
        "solid:\n"
        "  body_force: [0, 2.0e-3, 0]\n"
        "  materials: [{name: s, youngs_modulus: 10, density: 2, horizon_ratio: 1.2, fracture_energy: 1}]\n"
        "  bodies: [{shape: box, low: [4, 0, 4], high: [6, 2, 6]}]\n"
        "  cracks:\n"
        "    - points: [[5, 0, 0], [5, 10, 0], [5, 10, 10], [5, 0, 10]]\n"
        "    - points: [[0, 1, 0], [10, 1, 0], [10, 1, 10], [0, 1, 10]]\n"
        "    - points: [[0, 0, 5], [10, 0, 5], [10, 10, 5], [0, 10, 5]]\n";
    const struct outcome o = watch_of(dust, flooded_verlet, NULL, 0);
    check_equal(o.ended, 0);
    check_equal(o.seen.inner.begun, 1);
    check_above(o.seen.inner.load, 0);
    check_equal(o.seen.inner.logged, 0);
    check_equal(o.seen.logged_reaction, 0);
}

/* A block as heavy as the fluid, both under their weight: fast waves of the start, of less than a substep's energy, are
 * nothing to warn of, though the integrator takes almost all that is exchanged. */
static const char *const neutral = "title: test\n"
                                   "domain: {size: [0.014, 0.014, 0.014], cells: [14, 14, 14]}\n"
                                   "fluid:\n"
                                   "  density: 1000\n"
                                   "  viscosity: 1.0e-6\n"
                                   "  body_force: [0, -9.81, 0]\n"
                                   "  sides:\n"
                                   "    x_low: {type: wall}\n    x_high: {type: wall}\n"
                                   "    y_low: {type: wall}\n    y_high: {type: wall}\n"
                                   "    z_low: {type: wall}\n    z_high: {type: wall}\n"
                                   "solid:\n"
                                   "  body_force: [0, -9.81, 0]\n"
                                   "  materials: [{name: s, youngs_modulus: 1.0e6, density: 1000}]\n"
                                   "  bodies: [{shape: box, low: [0.004, 0.004, 0.004], high: [0.01, 0.01, 0.01]}]\n";
static void is_quiet_at_rest(void **state) {
    (void)state;
    const struct outcome o = watch_of(neutral, "stages: [{name: a, steps: 100, time_step: 2.0e-3}]\n", NULL, 0);
    print_message("off by %.3g of %.3g J\n", o.seen.off, o.seen.exchanged);
    check_equal(o.seen.logged, 0);
    check_below(o.seen.exchanged, 1e-9); /* J */
    const struct outcome spoilt =
        watch_of(neutral, "stages: [{name: a, steps: 100, time_step: 2.0e-3}]\n", pushes, 1e-2);
    print_message("with a push of 1e-5 m/s a step: off by %.3g of %.3g J\n", spoilt.seen.off, spoilt.seen.exchanged);
    check_above(spoilt.seen.logged, 0.01);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(closes_in_a_fluid), cmocka_unit_test(inner_fluid_gives_back),
                                       cmocka_unit_test(particles_alone_give_nothing),
                                       cmocka_unit_test(is_quiet_at_rest)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
