/* Drag towards given velocities: both integrators against their own amplification, momentum, work, a held particle. */
#include "base/par.h"
#include "solid/force/attachment.h"
#include "solid/force/drag.h"
#include "solid/solid.h"
#include "solid/step/integrate.h"
#include "tests/check.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>

enum { DENSITY = 3000 };

/* One particle, of 1 mm, without bonds; held along x if asked for. */
static struct solid *particle_new(enum solid_integrator integrator, int is_held) {
    const struct solid_material material = {1e8, DENSITY, INFINITY, 3, PHYSICS_CONSTANT, 0, 0};
    const struct solid_body body = {.name = "one", .shape = SOLID_BOX, .high = {1e-3, 1e-3, 1e-3}};
    const struct solid_input in = {.spacing = 1e-3, .bodies = 1, .body = &body, .materials = 1, .material = &material};
    struct solid *one = solid_new(&in);
    one->stage.integrator = integrator;
    if (is_held) one->flag[0] |= SOLID_HELD_X;
    return one;
}

struct pull {
    int h;
    double strength, u[1][3], impulse[1][3], fraction[1][3], inverse_mass, given[3][1];
    struct solid_attachment_weights weights;
    const struct solid_attachment_weights *weights_of[1];
    struct solid_attachment markers;
    struct solid_drag drag;
};

/* A marker at the particle's centre, with half of its kernel beyond a side in y. rate: z, 1/s */
static void pull(struct solid *one, struct pull *p, double rate, double u, int is_held) {
    const double mass = DENSITY * one->volume[0];
    *p = (struct pull){.strength = rate * mass,
                       .u = {{u, 0, 0}},
                       .fraction = {{1, 0.5, 1}},
                       .inverse_mass = is_held ? 0 : 1 / mass,
                       .weights = {.own = 1}};
    p->weights_of[0] = &p->weights;
    p->markers =
        (struct solid_attachment){.n = 1, .h = &p->h, .weights = p->weights_of, .inverse_mass = &p->inverse_mass};
    for (int c = 0; c < 3; c++) p->markers.given[c] = p->given[c];
    p->drag = (struct solid_drag){&p->markers, &p->strength, (const double(*)[3])p->u, p->impulse,
                                  (const double(*)[3])p->fraction};
    one->drag = &p->drag;
}

/* Factor of v - U in a substep with z dt = x: an implicit step at its end, with either integrator. */
static double factor(double x) { return 1 / (1 + x); }

static void test_decay(void **state) {
    (void)state;
    const double dt = 1e-4, u = 0.3, stiffness[] = {1e-3, 0.5, 2, 100};
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 4; k++) {
            const enum solid_integrator integrator = i ? SOLID_VERLET : SOLID_RK3;
            struct solid *one = particle_new(integrator, 0);
            struct pull p;
            one->v[0][0] = 1;
            one->v[1][0] = -2;
            pull(one, &p, stiffness[k] / dt, u, 0);
            solid_integrate(one, dt, 3);
            const double v[3] = {u + 0.7 * pow(factor(stiffness[k]), 3), -2 * pow(factor(stiffness[k] / 4), 3), 0};
            double lost = 0;
            for (int c = 0; c < 3; c++) {
                const double start = c == 0 ? 1 : c == 1 ? -2 : 0;
                check_close(one->v[c][0], v[c], 1e-13);
                check_close(p.impulse[0][c] / (DENSITY * one->volume[0]), one->v[c][0] - start, 1e-13);
                lost += 0.5 * DENSITY * one->volume[0] * (pow(one->v[c][0], 2) - start * start);
            }
            check_relative(one->work_load, lost, 1e-12);
            solid_free(one);
        }
}

/* A constant load against the drag: the particle ends at U/p + load/(density z p^2). */
static void test_balance(void **state) {
    (void)state;
    for (int i = 0; i < 2; i++) {
        struct solid *one = particle_new(i ? SOLID_VERLET : SOLID_RK3, 0);
        struct pull p;
        one->load[0][0] = one->load[1][0] = 6e4;
        pull(one, &p, 100, 0.5, 0);
        p.u[0][1] = 0.5;
        solid_integrate(one, 5e-3, 400);
        check_relative(one->v[0][0], 0.5 + 6e4 / DENSITY / 100, 1e-12);
        check_relative(one->v[1][0], 1 + 6e4 / DENSITY / 25, 1e-12);
        solid_free(one);
    }
}

/* A held particle does not move; the fluid feels it as a wall. */
static void test_held(void **state) {
    (void)state;
    for (int i = 0; i < 2; i++) {
        struct solid *one = particle_new(i ? SOLID_VERLET : SOLID_RK3, 1);
        struct pull p;
        pull(one, &p, 1e4, 0.5, 1);
        solid_integrate(one, 1e-4, 10);
        check_equal(one->v[0][0], 0);
        check_equal(one->d[0][0], 0);
        check_relative(p.impulse[0][0], p.strength * 0.5 * 1e-3, 1e-13);
        check_equal(one->work_load, 0);
        solid_free(one);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_decay), cmocka_unit_test(test_balance),
                                       cmocka_unit_test(test_held)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
