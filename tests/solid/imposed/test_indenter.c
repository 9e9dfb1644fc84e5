/* Indenters: the force is minus the gradient of the energy, momentum and energy balance, periodic images, reactions. */
#include "base/par.h"
#include "solid/force/force.h"
#include "solid/imposed/indenter.h"
#include "solid/imposed/reactions.h"
#include "solid/measure/energy.h"
#include "solid/solid.h"
#include "solid/step/integrate.h"
#include "solid/step/rates.h"
#include "tests/check.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>

static const double SPACING = 1e-3, YOUNG = 1e9, DENSITY = 2000, STIFFNESS = 1e16, RADIUS = 2.6e-3;
enum { SITES = 8 };

/* A block of 8 sites along each side, or a plate of as many, under an indenter that is 1.5 spacings in. */
static struct solid *make(enum physics_model model, int periodic, double speed) {
    const double size = SITES * SPACING;
    const double corner[4][2] = {{0, 0}, {size, 0}, {size, size}, {0, size}};
    const signed char turn[4] = {0};
    const struct solid_outline outline = {0, 4, corner, corner, turn};
    const struct solid_material material = {YOUNG, DENSITY, INFINITY, 2, PHYSICS_CONSTANT, 0, 0};
    struct solid_body body = {.name = "block", .shape = SOLID_BOX, .high = {size, size, size}};
    if (model != PHYSICS_3D)
        body = (struct solid_body){.name = "plate", .shape = SOLID_POLYGON, .outlines = 1, .outline = &outline};
    struct solid_indenter at = {.centre = {periodic ? 0.1 * SPACING : 4.13 * SPACING, size + RADIUS - 1.5 * SPACING},
                                .radius = RADIUS,
                                .velocity = {0.3 * speed, -speed},
                                .stiffness = STIFFNESS};
    if (model == PHYSICS_3D) at.centre[2] = 3.71 * SPACING;
    const struct solid_input in = {.model = model,
                                   .thickness = 2e-3,
                                   .spacing = SPACING,
                                   .periodic = {periodic},
                                   .length = {size, size, size},
                                   .bodies = 1,
                                   .body = &body,
                                   .materials = 1,
                                   .material = &material,
                                   .indenters = 1,
                                   .indenter = &at};
    return solid_new(&in);
}

static double energy_of(struct solid *s) {
    solid_force(s, 0);
    return par_sum(s->indent->energy[0]);
}

/* a without the indenter's part is 0 at rest and undeformed, so a is the indenter's alone. Central differences of an
 * energy that is cubic in the depth: their error is (K/3) e^2 V of a force of K depth^2 V. */
static void test_gradient(void **state) {
    (void)state;
    for (int kind = 0; kind < 4; kind++) {
        struct solid *s = make(kind & 1 ? PHYSICS_PLANE_STRESS : PHYSICS_3D, kind >> 1, 0);
        const double e = 1e-4 * SPACING;
        assert_true(energy_of(s) > 0);
        check_at_least((double)par_sum_long(s->indent->inside[0]), 4);
        for (int k = 0; k < s->n_global; k += 3) {
            const int h = (int)(k - s->first[par_rank()]), own = h >= 0 && h < s->n;
            for (int c = 0; c < s->dim; c++) {
                double side[2], force = 0;
                s->indent->t = 0;
                solid_force(s, 0);
                if (own) force = DENSITY * s->volume[h] * s->a[c][h];
                const double largest = par_max(own ? STIFFNESS * RADIUS * RADIUS * s->volume[h] : 0);
                for (int i = 0; i < 2; i++) {
                    if (own) s->d[c][h] = i ? e : -e;
                    side[i] = energy_of(s);
                    if (own) s->d[c][h] = 0;
                }
                check_close(-(side[1] - side[0]) / (2 * e), par_sum(force), 1e-6 * largest);
            }
        }
        solid_free(s);
    }
}

static double momentum_of(const struct solid *s, int c) {
    double sum = 0;
    for (int h = 0; h < s->n; h++) sum += DENSITY * s->volume[h] * s->v[c][h];
    return par_sum(sum);
}

/* The momentum of the solid is the impulse of the indenter, by both integrators; the row of the reactions is its mean
 * force, and its own displacement. */
static void test_momentum(void **state) {
    (void)state;
    for (int kind = 0; kind < 4; kind++) {
        struct solid *s = make(kind & 1 ? PHYSICS_PLANE_STRAIN : PHYSICS_3D, 0, 20);
        s->stage = (struct solid_stage){.integrator = kind >> 1 ? SOLID_VERLET : SOLID_RK3};
        solid_reactions_new(s);
        const double dt = 0.3 * solid_rates_stable_step(s, s->stage.integrator);
        double impulse[3] = {0};
        for (int k = 0; k < 20; k++) {
            struct solid_reaction row;
            solid_reactions_begin(s);
            solid_integrate(s, dt, 2);
            solid_reactions_measure(s, &row);
            for (int c = 0; c < s->dim; c++) impulse[c] += 2 * dt * row.force[c];
            check_above((double)row.particles, 0);
            check_relative(row.displacement[1], -20 * s->t, 1e-12);
        }
        assert_true(impulse[1] < 0);
        for (int c = 0; c < s->dim; c++) check_close(momentum_of(s, c), impulse[c], 1e-12 * fabs(impulse[1]));
        solid_free(s);
    }
}

/* Energy that the balance lacks after a given time, as a part of the work. */
static double lack_of(enum solid_integrator integrator, enum physics_model model, int steps) {
    struct solid *s = make(model, 0, 20);
    s->stage = (struct solid_stage){.integrator = integrator};
    solid_integrate(s, 1e-5 / steps, steps);
    const struct solid_energy e = solid_energy_measure(s);
    const double work = par_sum(s->work_load), lack = fabs(e.strain + e.kinetic - work) / work;
    assert_true(work > 0);
    solid_free(s);
    return lack;
}

/* The work is in work_load: kinetic and strain energy are equal to it up to the error of the integrator, of second
 * order by Verlet and of third by RK3. */
static void test_work(void **state) {
    (void)state;
    for (int plate = 0; plate < 2; plate++) {
        const enum physics_model model = plate ? PHYSICS_PLANE_STRESS : PHYSICS_3D;
        const double v[2] = {lack_of(SOLID_VERLET, model, 40), lack_of(SOLID_VERLET, model, 80)},
                     r[2] = {lack_of(SOLID_RK3, model, 40), lack_of(SOLID_RK3, model, 80)};
        check_between(v[1], 0, 2e-3);
        check_between(r[1], 0, 2e-4);
        check_between(v[0] / v[1], 3, 5.5);
        check_above(r[0] / r[1], 5.5);
    }
}

/* Nothing is allocated without indenters. */
static void test_none(void **state) {
    (void)state;
    const struct solid_material material = {YOUNG, DENSITY, INFINITY, 2, PHYSICS_CONSTANT, 0, 0};
    const struct solid_body body = {.shape = SOLID_BOX, .high = {4e-3, 4e-3, 4e-3}};
    const struct solid_input in = {
        .spacing = SPACING, .bodies = 1, .body = &body, .materials = 1, .material = &material};
    struct solid *s = solid_new(&in);
    assert_null(s->indent);
    assert_null(s->stretch_limit);
    solid_free(s);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_gradient), cmocka_unit_test(test_momentum),
                                       cmocka_unit_test(test_work), cmocka_unit_test(test_none)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
