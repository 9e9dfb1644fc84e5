/* Increments of quasi-static loading: equilibrium, works, breakage up to the limit and no further. */
#include "solid/force/force.h"
#include "solid/imposed/constraint.h"
#include "solid/law/material.h"
#include "solid/measure/energy.h"
#include "solid/step/quasi_static.h"
#include "tests/solid/make_plate.h"
#include "tests/check.h"

#define MM 1e-3

/* A plate with a notch, whose lips are driven apart by 1 mm each at t = 1; held at the other end. */
static struct solid *notched(int brittle) {
    static const double line[2][3] = {{-1 * MM, 10 * MM}, {8 * MM, 10 * MM}}, t[2] = {0, 1}, factor[2] = {0, 1};
    static const struct solid_cut cut = {2, line};
    static const struct solid_constraint constraint[3] = {
        {.low = {0, 17 * MM},
         .high = {3 * MM, 20 * MM},
         .direction = {0, 1},
         .has_displacement = 1,
         .displacement = {0, MM},
         .time = {2, t, factor, 0}},
        {.low = {0, 0},
         .high = {3 * MM, 3 * MM},
         .direction = {0, 1},
         .has_displacement = 1,
         .displacement = {0, -MM},
         .time = {2, t, factor, 0}},
        {.low = {21 * MM, 8 * MM}, .high = {24 * MM, 12 * MM}, .direction = {1, 1}}};
    struct solid *s = make((struct make){.sites = {24, 20},
                                         .brittle = brittle,
                                         .contact = 1,
                                         .cuts = 1,
                                         .cut = &cut,
                                         .constraints = 3,
                                         .constraint = constraint});
    s->stage.breakage = brittle;
    return s;
}

/* Strain energy less the works, over the strain energy. */
static double missing(struct solid *s, double *work, double *strain) {
    *work = par_sum(s->e_constraint + s->work_load);
    *strain = solid_energy_measure(s).strain;
    return *strain / *work - 1;
}

/* Without breakage: an increment is one relaxation, each point is at rest, and the works are the strain energy. */
static void elastic(void **state) {
    (void)state;
    struct solid *s = notched(0);
    for (int k = 1; k <= 3; k++) {
        struct solid_quasi_static found;
        double work, strain, residual = 0, reaction = 0;
        assert_true(solid_quasi_static_step(s, k * 1e-2, 1e-6, 50000, &found));
        check_equal(found.rounds, 0);
        check_equal(found.broken, 0);
        check_above(found.relaxations, 10);
        check_close(s->t, k * 1e-2, 1e-15);
        check_close(missing(s, &work, &strain), 0, 1e-3);
        check_equal(par_sum(s->e_damped), 0);
        solid_force(s, 0);
        for (int h = 0; h < s->n; h++)
            for (int c = 0; c < 2; c++) residual += pow(s->a[c][h] * DENSITY * s->volume[h], 2);
        solid_ghosts_update(s);
        solid_force_bonds(s, 0, 0);
        reaction = solid_constraint_apply(s);
        check_below(sqrt(par_sum(residual)), 1e-5 * sqrt(par_sum(reaction)));
    }
    solid_free(s);
}

/* With breakage: the notch runs, no bond beyond the limit is left, and the works are what strain, contact and broken
 * bonds hold and the relaxations took. The same on any number of ranks. */
static void breaking(void **state) {
    (void)state;
    struct solid *s = notched(1);
    const double s0 = solid_material_constants(s->in.model, THICKNESS, s->in.material, 3 * SPACING).s0;
    double *energy = malloc(((size_t)s->n + 1) * sizeof *energy),
           *stretch = malloc(((size_t)s->n + 1) * sizeof *stretch);
    long before, broken = 0;
    double taken = 0;
    int rounds = 0;
    solid_family_count(s);
    before = s->bonds_broken;
    for (int k = 1; k <= 8 && (broken <= 60 || rounds <= 6); k++) { /* until enough has broken */
        struct solid_quasi_static found;
        double work, strain, most = -1;
        assert_true(solid_quasi_static_step(s, k * 4e-3, 1e-5, 50000, &found));
        broken += found.broken;
        rounds += found.rounds;
        check_equal(s->bonds_broken - before, broken);
        missing(s, &work, &strain);
        const struct solid_energy e = solid_energy_measure(s);
        check_close(strain + e.contact + e.fracture + e.damped, work, 1e-3 * work);
        check_at_least(found.dissipated, 0);
        taken += found.dissipated;
        solid_ghosts_update(s);
        solid_energy_bonds(s, energy, stretch);
        for (int h = 0; h < s->n; h++) most = fmax(most, stretch[h]);
        check_at_most(par_max(most), s0 * (1 + 1e-9));
    }
    print_message("quasi-static: %ld bonds broken in %d rounds, which took %.3g J\n", broken, rounds, taken);
    check_relative(par_sum(s->e_damped), taken, 1e-12);
    check_above(taken, 0);
    check_above(broken, 50);
    check_above(rounds, 5);
    free(energy);
    free(stretch);
    solid_free(s);
}

/* A column between clamps that approach, with a light load across. At a tolerance that this load is lost in, it stays
 * straight beyond Euler's load, and then snaps: what it gives off is found though no bond breaks, the energies balance,
 * and the load P is then Euler's, with shear and shortening: P (1 + P (1.2/(G A) - 1/(E A))) = P_Euler. */
static void buckling(void **state) {
    (void)state;
    enum { LENGTH = 64, CLAMP = 4, HEIGHT = 6 };
    static const double t[2] = {0, 1}, factor[2] = {0, 1}, end = (LENGTH + 2 * CLAMP) * MM;
    const struct solid_constraint constraint[2] = {
        {.low = {0, 0}, .high = {CLAMP * MM, HEIGHT * MM}, .direction = {1, 1}},
        {.low = {end - CLAMP * MM, 0},
         .high = {end, HEIGHT * MM},
         .direction = {1, 1},
         .has_displacement = 1,
         .displacement = {-4 * MM, 0},
         .time = {2, t, factor, 0}}};
    struct solid *s = make((struct make){.sites = {LENGTH + 2 * CLAMP, HEIGHT},
                                         .constraints = 2,
                                         .constraint = constraint,
                                         .correction = SOLID_CORRECTION_ENERGY});
    const double euler = 4 * M_PI * M_PI * YOUNG * THICKNESS * pow(HEIGHT * MM, 3) / 12 / pow(LENGTH * MM, 2);
    double most = 0, force = 0;
    int snaps = 0;
    s->in.body_force[1] = 30;
    for (int k = 1; k <= 20; k++) {
        struct solid_quasi_static found;
        double work, strain;
        assert_true(solid_quasi_static_step(s, k / 20., 1e-6, 200000, &found));
        check_equal(found.broken, 0);
        snaps += found.dissipated > 0;
        missing(s, &work, &strain);
        check_close((work - strain - par_sum(s->e_damped)) / strain, 0, 1e-3);
        solid_force_bonds(s, 0, 0);
        force = 0;
        for (int h = 0; h < s->n; h++)
            if (s->x0[0][h] > end - CLAMP * MM) force += DENSITY * s->volume[h] * s->a[0][h];
        force = par_sum(force);
        most = fmax(most, force);
    }
    print_message("column: at most %.4f of Euler's load, then %.4f; %.3g J given off\n", most / euler, force / euler,
                  par_sum(s->e_damped));
    check_equal(snaps, 1);
    check_above(most, 1.1 * euler);
    check_relative(force * (1 + force * (1.2 * 8 / 3 - 1) / (YOUNG * THICKNESS * HEIGHT * MM)), euler, 0.03);
    solid_free(s);
}

/* A load that the plate cannot bear: it breaks until it is in pieces, which find no equilibrium. */
static void too_much(void **state) {
    (void)state;
    const struct solid_load load[2] = {
        {SOLID_LOAD_EDGE, .edge = {{0, 0}, {0, 8 * MM}}, .traction = {-2e8, 0}, .over_horizon = 1},
        {SOLID_LOAD_EDGE, .edge = {{20 * MM, 0}, {20 * MM, 8 * MM}}, .traction = {2e8, 0}, .over_horizon = 1}};
    struct solid *s = make((struct make){.sites = {20, 8}, .brittle = 1, .loads = 2, .load = load});
    struct solid_quasi_static found;
    assert_false(solid_quasi_static_step(s, 1, 1e-6, 3000, &found));
    check_above(found.broken, 20);
    solid_free(s);
}

/* A bar of softening bonds under a dead load of `part` of its strength, raised in as many increments. */
struct pulled {
    int rests;
    double strain, fracture, damped, work, residual; /* J; of the load */
};

static struct pulled pulled(double part, int increments) {
    static const double strength = 3e7, t[2] = {0, 1}, factor[2] = {0, 1};
    const double traction = part * strength;
    const struct solid_load load[2] = {{SOLID_LOAD_EDGE, .edge = {{0, 0}, {0, 6 * MM}}, .traction = {-traction, 0},
                                        .over_horizon = 1, .time = {2, t, factor, 0}},
                                       {SOLID_LOAD_EDGE, .edge = {{18 * MM, 0}, {18 * MM, 6 * MM}},
                                        .traction = {traction, 0}, .over_horizon = 1, .time = {2, t, factor, 0}}};
    struct solid *s = make((struct make){.sites = {18, 6},
                                         .brittle = 1,
                                         .tensile_strength = strength,
                                         .correction = SOLID_CORRECTION_ENERGY,
                                         .loads = 2,
                                         .load = load});
    struct pulled p = {.rests = 1};
    s->stage.breakage = 1;
    for (int k = 1; k <= increments && p.rests; k++) {
        struct solid_quasi_static found;
        p.rests = solid_quasi_static_step(s, (double)k / increments, 1e-6, 5000, &found);
    }
    solid_force(s, 0);
    double sum = 0;
    for (int h = 0; h < s->n; h++)
        for (int c = 0; c < 2; c++) sum += pow(s->a[c][h] * DENSITY * s->volume[h], 2);
    p.residual = sqrt(par_sum(sum)) / (traction * 6 * MM * THICKNESS);
    p.strain = solid_energy_measure(s).strain;
    p.fracture = par_sum(s->e_fracture);
    p.damped = par_sum(s->e_damped);
    p.work = par_sum(s->work_load);
    solid_free(s);
    return p;
}

/* Bonds that soften weaken the solid at once: each increment ends at rest under what is left of them, however many
 * there are, and the energy that softening takes follows its law. A load above the strength finds no rest. */
static void softening(void **state) {
    (void)state;
    const struct pulled few = pulled(0.95, 2), many = pulled(0.95, 8);
    assert_true(few.rests && many.rests);
    check_above(many.fracture, 0.02 * many.strain);
    check_below(few.residual, 1e-5);
    check_below(many.residual, 1e-5);
    check_relative(few.strain, many.strain, 1e-3);
    check_relative(few.fracture, many.fracture, 1e-3);
    check_equal(many.damped, 0);
    check_relative(many.strain + many.fracture, many.work, 1e-2); /* the trapezoidal rule in eighths leaves 0.7 % */
    assert_false(pulled(1.1, 2).rests);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(elastic), cmocka_unit_test(breaking),
                                       cmocka_unit_test(buckling), cmocka_unit_test(too_much),
                                       cmocka_unit_test(softening)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
