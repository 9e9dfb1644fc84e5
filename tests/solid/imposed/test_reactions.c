/* Reactions of constraints and forces of loads: balance of momentum, equilibrium, drag, overlapping regions. */
#include "solid/imposed/reactions.h"
#include "tests/solid/make.h"
#include "solid/force/attachment.h"
#include "solid/force/drag.h"
#include "solid/imposed/external_loads.h"
#include "solid/solid.h"
#include "solid/step/integrate.h"
#include "solid/step/relax.h"

#include "tests/check.h"

#include <stdlib.h>

static const double moment[2] = {0, 1e-4}, factor[2] = {0.5, 3};

enum { LENGTH = 12, WIDTH = 4, CONSTRAINTS = 3 };

/* A bar along x: its first two layers held, its last two driven along x, and of these the very last held along z. */
static const struct solid_constraint *ends(double speed, double displacement) {
    static struct solid_constraint k[CONSTRAINTS];
    for (int q = 0; q < CONSTRAINTS; q++) k[q] = (struct solid_constraint){.low = {-1, -1, -1}, .high = {1, 1, 1}};
    k[0].high[0] = 2 * SPACING;
    k[0].direction[0] = k[0].direction[1] = k[0].direction[2] = 1;
    k[1].low[0] = (LENGTH - 2) * SPACING;
    k[1].direction[0] = 1;
    k[1].velocity[0] = speed;
    k[1].has_displacement = displacement != 0;
    k[1].displacement[0] = displacement;
    k[2].low[0] = (LENGTH - 1) * SPACING;
    k[2].direction[2] = 1;
    return k;
}

static struct solid *bar(int general, const struct solid_constraint *k, int constraints,
                         const struct solid_load *load) {
    const struct solid_body body = {
        .name = "bar", .shape = SOLID_BOX, .high = {LENGTH * SPACING, WIDTH * SPACING, WIDTH * SPACING}};
    const struct solid_material material = {YOUNG, DENSITY, INFINITY, 3, PHYSICS_CONSTANT, 0, 0};
    struct solid *s = solid_new(&(struct solid_input){.spacing = SPACING,
                                                      .bodies = 1,
                                                      .body = &body,
                                                      .materials = 1,
                                                      .material = &material,
                                                      .constraints = constraints,
                                                      .constraint = k,
                                                      .loads = load != NULL,
                                                      .load = load,
                                                      .surface_correction = 1,
                                                      .general_bonds = general});
    solid_reactions_new(s);
    return s;
}

static void momentum_of(const struct solid *s, double p[3]) {
    for (int c = 0; c < 3; c++) p[c] = 0;
    for (int h = 0; h < s->n; h++)
        for (int c = 0; c < 3; c++) p[c] += DENSITY * s->volume[h] * s->v[c][h];
    par_sum_array(p, 3);
}

/* Over each step of three substeps the whole bar's momentum changes by the impulses of supports and load, with damping
 * along the bonds. */
static void balance_of_momentum(void **state) {
    (void)state;
    const struct solid_load load = {.kind = SOLID_LOAD_REGION,
                                    .low = {4 * SPACING, -1, -1},
                                    .high = {6 * SPACING, 1, 1},
                                    .force = {2e5, -1e5, 4e5},
                                    .time = {2, moment, factor, 0}};
    for (int way = 0; way < 4; way++) {
        struct solid *s = bar(way / 2, ends(2, 0), CONSTRAINTS, &load);
        struct solid_reaction r[CONSTRAINTS + 1];
        const double dt = step_of(0.2);
        double before[3], after[3], pushed = 0;
        s->stage.integrator = way % 2 ? SOLID_VERLET : SOLID_RK3;
        s->stage.damping_relative = 1e12;
        for (int i = 0; i < 12; i++) {
            momentum_of(s, before);
            solid_reactions_begin(s);
            solid_integrate(s, dt, 3);
            solid_reactions_measure(s, r);
            momentum_of(s, after);
            for (int c = 0; c < 3; c++) {
                double force = 0, size = 0;
                for (int q = 0; q <= CONSTRAINTS; q++) {
                    force += r[q].force[c];
                    size += fabs(r[q].force[c]);
                }
                check_close(after[c] - before[c], 3 * dt * force, 1e-12 * (3 * dt * size + fabs(after[c])));
                pushed = check_worst(pushed, r[0].force[c]);
            }
            const double t = s->t - 1.5 * dt, mean = 0.5 + 2.5 * t / moment[1]; /* the load's factor over the step */
            const double volume = 2 * WIDTH * WIDTH * pow(SPACING, 3);
            for (int c = 0; c < 3; c++) check_relative(r[CONSTRAINTS].force[c], mean * load.force[c] * volume, 1e-12);
            check_equal((double)r[CONSTRAINTS].particles, 2 * WIDTH * WIDTH);
        }
        check_above(pushed, 1e-6);     /* the wave has come to the other end */
        check_above(r[1].force[0], 0); /* the end that is pulled to the right is held back */
        check_equal(r[1].force[2], 0); /* free there, but for the very last layer, which is the third's */
        check_equal((double)r[0].particles, 2 * WIDTH * WIDTH);
        check_equal((double)r[2].particles, WIDTH * WIDTH);
        check_relative(r[1].displacement[0], 2 * s->t, 1e-12);
        check_equal(r[0].displacement[0], 0);
        solid_free(s);
    }
}

/* At rest, the support gives the opposite of the load; and the two ends of a bar that is held stretched pull against
 * each other. tolerance: of the relaxation, on the squared sum of the particles' residuals. */
static void equilibrium(void **state) {
    (void)state;
    const double tolerance = 1e-7, wide = 30 * tolerance;
    const struct solid_load load = {
        .kind = SOLID_LOAD_REGION, .low = {(LENGTH - 2) * SPACING, -1, -1}, .high = {1, 1, 1}, .force = {3e7, 1e7, 0}};
    for (int general = 0; general < 2; general++) {
        struct solid_reaction r[CONSTRAINTS + 1];
        struct solid *s = bar(general, ends(0, 0), 1, &load);
        check_above(solid_relax(s, tolerance, 200000), 10);
        solid_reactions_measure(s, r);
        const double volume = 2 * WIDTH * WIDTH * pow(SPACING, 3);
        for (int c = 0; c < 2; c++) {
            check_relative(r[1].force[c], load.force[c] * volume, 1e-13);
            check_relative(r[0].force[c], -load.force[c] * volume, wide);
        }
        check_above(r[1].displacement[0], 0);
        solid_free(s);

        s = bar(general, ends(0, 0.03 * SPACING), CONSTRAINTS, NULL);
        check_above(solid_relax(s, tolerance, 200000), 10);
        solid_reactions_measure(s, r);
        check_relative(r[0].force[0], -r[1].force[0], wide);
        check_relative(r[1].displacement[0], 0.03 * SPACING, 1e-13);
        /* of a bar between the grips' last layers; four particles across, clamped and corrected at the surface, are
         * stiffer than the material */
        check_between(r[1].force[0] / (YOUNG * pow(WIDTH * SPACING, 2) * 0.03 / (LENGTH - 3)), 1, 1.5);
        solid_free(s);
    }
}

/* A held particle takes up the drag; the free ones do not count. */
static void drag(void **state) {
    (void)state;
    for (int i = 0; i < 2; i++) {
        struct solid *s = bar(0, ends(0, 0), 1, NULL);
        struct solid_reaction r[1];
        enum { MOST = 4 };
        int h[MOST], n = 0;
        double strength[MOST], inverse_mass[MOST], u[MOST][3], impulse[MOST][3] = {{0}}, fraction[MOST][3], held = 0;
        const struct solid_attachment_weights alone = {.own = 1}, *weights[MOST];
        for (int k = 0; k < s->n && n < MOST; k += 3) { /* in no order */
            h[n] = s->n - 1 - k;
            const double mass = DENSITY * s->volume[h[n]];
            const int is_held = (s->flag[h[n]] & SOLID_HELD_X) != 0;
            strength[n] = (100 + n) * mass;
            inverse_mass[n] = is_held ? 0 : 1 / mass;
            weights[n] = &alone;
            for (int c = 0; c < 3; c++) u[n][c] = 1e-3 * (c + 1), fraction[n][c] = 1;
            held += is_held ? strength[n] : 0;
            n++;
        }
        struct solid_attachment markers = {.n = n, .h = h, .weights = weights, .inverse_mass = inverse_mass};
        for (int c = 0; c < 3; c++) markers.given[c] = calloc((size_t)(s->n + s->n_ghost) + 1, sizeof(double));
        const struct solid_drag pull = {&markers, strength, (const double(*)[3])u, impulse,
                                        (const double(*)[3])fraction};
        s->stage.integrator = i ? SOLID_VERLET : SOLID_RK3;
        s->drag = &pull;
        solid_reactions_begin(s);
        double before[3], after[3];
        momentum_of(s, before);
        const double dt = step_of(0.2);
        solid_integrate(s, dt, 2);
        momentum_of(s, after);
        solid_reactions_measure(s, r);
        double given[3] = {0};
        for (int k = 0; k < n; k++)
            for (int c = 0; c < 3; c++) given[c] += impulse[k][c];
        par_sum_array(given, 3);
        held = par_sum(held);
        for (int c = 0; c < 3; c++) {
            check_close(after[c] - before[c], given[c] + 2 * dt * r[0].force[c], 1e-12 * given[c]);
            /* bonds give the held particles little in two short steps */
            if (held > 0) check_relative(r[0].force[c], -held * 1e-3 * (c + 1), 0.05);
        }
        for (int c = 0; c < 3; c++) free(markers.given[c]);
        s->drag = NULL;
        solid_free(s);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(balance_of_momentum), cmocka_unit_test(equilibrium),
                                       cmocka_unit_test(drag)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
