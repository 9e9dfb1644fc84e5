/* Blocks of any Poisson's ratio: elastic constants, forces that are the energy's derivative, momentum, energy, and the
 * same forces in both stores of bonds, in mixed precision, and of several materials. */
#include "solid/force/dilatation.h"
#include "base/step_status.h"
#include "solid/bonds/ghosts.h"
#include "solid/force/force.h"
#include "solid/force/strain.h"
#include "solid/measure/energy.h"
#include "solid/measure/stress.h"
#include "solid/step/integrate.h"
#include "solid/step/rates.h"
#include "tests/check.h"
#include "tests/solid/derivative.h"
#include "tests/solid/make.h"
#include "tests/solid/totals.h"

#include <stdlib.h>

static const double ratios[] = {-0.5, 0, 0.1, 0.2, 0.3, 0.4, 0.45};
enum { RATIOS = sizeof ratios / sizeof *ratios };

/* A strain of each kind, added to a displacement. */
static void strain(struct solid *s, const double strains[3][3]) {
    for (int h = 0; h < s->n; h++)
        for (int c = 0; c < 3; c++) {
            s->d[c][h] = 0;
            for (int k = 0; k < 3; k++) s->d[c][h] += strains[c][k] * s->x0[k][h];
        }
    solid_ghosts_update(s);
}

/* A part of all bonds, the same on any number of ranks. */
static void damage(struct solid *s, double part) {
    static struct solid_family_view view;
    for (int h = 0; h < s->n; h++) {
        solid_family_view(s, h, &view);
        for (int b = 0; b < view.n; b++) {
            double middle[3], hash = 0;
            for (int c = 0; c < 3; c++) middle[c] = 2 * s->x0[c][h] + view.xi[b][c];
            for (int c = 0; c < 3; c++) hash += (2.7 + 1.3 * c) * rint(middle[c] / SPACING) + 0.37 * c;
            hash = 37.1 * sin(hash);
            if (hash - floor(hash) < part && view.intact[b]) solid_family_break(s, h, b);
        }
    }
}

/* A particle inside the block, with a full family of full families. */
static int inside(const struct solid *s, int sites) {
    for (int h = 0; h < s->n; h++) {
        int is = 1;
        for (int c = 0; c < 3; c++) is &= fabs(s->x0[c][h] / SPACING - 0.5 * sites) < 0.6;
        if (is) return h;
    }
    return -1;
}

/* C11, C12 and C44 of the lattice's bonds alone: 1/2 sum c0 xi_i xi_j xi_k xi_l/|xi|^3 Gamma V. */
static void bonds_of(const struct solid *s, double c[3]) {
    static struct solid_family_view view;
    memset(c, 0, 3 * sizeof *c);
    const int h = inside(s, 13);
    if (h < 0) return;
    solid_family_view(s, h, &view);
    for (int b = 0; b < view.n; b++) {
        const double *x = view.xi[b], length = sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]),
                     f = 0.5 * view.micro[b] * view.weight[b] / (length * length * length);
        c[0] += f * x[0] * x[0] * x[0] * x[0];
        c[1] += f * x[0] * x[0] * x[1] * x[1];
    }
    c[2] = c[1];
}

/* A uniform strain has the stress of the bonds and excess theta in any lattice, and half of stress times strain as its
 * energy; to the strain, because stretches are those of large deformations. */
static void test_constants(void **state) {
    (void)state;
    const double e = 1e-8, strains[2][3][3] = {{{e, 0, 0}, {0, 0, 0}, {0, 0, 0}}, {{0, e, 0}, {e, 0, 0}, {0, 0, 0}}};
    for (int k = 0; k < RATIOS; k++)
        for (int list = 0; list < 2; list++) {
            if (check_skips(2 * k + list, 3)) continue;
            struct solid *s =
                make((struct make){.sites = {13, 13, 13}, .list = list, .ratio_excess = ratios[k] - 0.25});
            const double nu = ratios[k], mu = YOUNG / (2 * (1 + nu)), bulk = YOUNG / (3 * (1 - 2 * nu));
            double bonds[3], (*stress)[6] = calloc((size_t)s->n + 1, sizeof *stress);
            double *energy = calloc(2 * (size_t)s->n + 1, sizeof *energy);
            bonds_of(s, bonds);
            const double excess = bulk - (bonds[0] + 2 * bonds[1]) / 3;
            const int h = inside(s, 13);
            for (int kind = 0; kind < 2; kind++) {
                strain(s, strains[kind]);
                solid_stress_measure(s, stress);
                solid_energy_bonds(s, energy, energy + s->n);
                if (h < 0) continue;
                if (kind == 0) {
                    check_relative(stress[h][0] / e, bonds[0] + excess, 1e-6);
                    check_relative(stress[h][1] / e, bonds[1] + excess, 1e-6);
                    check_relative(energy[h] / (e * e), 0.5 * (bonds[0] + excess), 1e-6);
                    /* the lattice's constants are those of the material but for its anisotropy and partial volumes */
                    check_relative(bonds[0] + 2 * bonds[1], 5 * mu, 0.02);
                } else {
                    check_relative(stress[h][3] / (2 * e), bonds[2], 1e-6);
                    check_relative(energy[h] / (e * e), 2 * bonds[2], 1e-6);
                    check_relative(bonds[2], mu, 0.05);
                }
            }
            free(stress);
            free(energy);
            solid_free(s);
        }
}

/* sum F u and the derivative of the energy along u by central differences, of a body in any state. */
static void test_derivative(void **state) {
    (void)state;
    for (int k = 0; k < RATIOS; k++)
        for (int kind = 0; kind < 8; kind++) {
            const int list = kind & 1, periodic = kind >> 1 & 1, large = kind >> 2;
            if (check_skips(8 * k + kind, 5)) continue;
            struct solid *s = make((struct make){.sites = {9, 8, 10},
                                                 .periodic = {periodic, 0, periodic},
                                                 .list = list,
                                                 .ratio_excess = ratios[k] - 0.25});
            if (!periodic) damage(s, 0.6);
            shake(s, large ? 0.05 : 1e-3, 0);
            check_derivative(s, large ? 1e-4 : 1e-5, noise);
            solid_free(s);
        }
}

static void test_pair_forces(void **state) {
    (void)state;
    for (int kind = 0; kind < 4; kind++) {
        struct solid *s = make((struct make){.sites = {9, 10, 11}, .list = kind & 1, .ratio_excess = 0.15});
        s->stage.damping_relative = 1e14;
        damage(s, 0.3);
        shake(s, kind >> 1 ? 0.05 : 1e-4, 1e-3);
        solid_force(s, 0);
        double total[6], size;
        totals(s, 1, total, &size);
        for (int c = 0; c < 6; c++) check_close(total[c] / size, 0, 1e-14);
        solid_free(s);
    }
}

/* The forces of the other kinds of sweep: relative to the largest. */
static void compare(struct solid *s, struct solid *t, double tolerance) {
    double most = 0, off = 0;
    for (int h = 0; h < s->n; h++)
        for (int c = 0; c < 3; c++) {
            most = fmax(most, fabs(s->a[c][h]));
            off = check_worst(off, s->a[c][h] - t->a[c][h]);
        }
    check_at_most(par_max(off) / par_max(most), tolerance);
}

static void test_stores(void **state) {
    (void)state;
    for (int kind = 0; kind < 4; kind++) {
        const double size = kind & 1 ? 0.05 : 1e-4, damping = kind & 2 ? 1e14 : 0;
        struct solid *solids[3];
        for (int k = 0; k < 3; k++) {
            solids[k] = make((struct make){
                .sites = {19, 10, 11}, .periodic = {0, 0, 1}, .list = k == 1, .mixed = k == 2, .ratio_excess = -0.1});
            solids[k]->stage.damping_relative = damping;
            damage(solids[k], 0.2);
            shake(solids[k], size, 1e-3);
            solid_force(solids[k], 0);
        }
        /* particles are numbered the same in both stores on one rank only */
        if (par_size() == 1) compare(solids[0], solids[1], 1e-12);
        compare(solids[0], solids[2], 2e-6);
        for (int k = 0; k < 3; k++) solid_free(solids[k]);
    }
}

/* What broken bonds release, and the energy that is left, have the sum of the energies before, with either integrator
 * and however the bonds break: to the integrator's order. */
static double imbalance(int list, int verlet, double nu, double steps, double *broken) {
    struct solid *s =
        make((struct make){.sites = {12, 7, 6}, .list = list, .fracture_energy = 2e-3, .ratio_excess = nu - 0.25});
    s->stage.integrator = verlet ? SOLID_VERLET : SOLID_RK3;
    for (int h = 0; h < s->n; h++)
        for (int c = 0; c < 3; c++) {
            const double x = s->x0[0][h] / SPACING - 6;
            s->v[c][h] = c == 0 ? 2e-1 * x + 0.02 * noise(s, h, c) : 0.02 * noise(s, h, c);
        }
    solid_ghosts_update(s);
    const struct solid_energy before = solid_energy_measure(s);
    solid_integrate(s, step_of(40 / steps), (int)steps);
    const struct solid_energy after = solid_energy_measure(s);
    solid_family_count(s);
    *broken = (double)s->bonds_broken;
    const double all = before.kinetic + before.strain;
    const double off = (after.kinetic + after.strain + after.fracture - all) / all;
    solid_free(s);
    return off;
}

static void test_books(void **state) {
    (void)state;
    for (int list = 0; list < 2; list++)
        for (int verlet = 0; verlet < 2; verlet++)
            for (int k = 0; k < 2; k++) {
                if (check_skips(4 * list + 2 * verlet + k, 3)) continue;
                double broken[2];
                const double nu = k ? 0.4 : 0.1, coarse = imbalance(list, verlet, nu, 200, &broken[0]),
                             fine = imbalance(list, verlet, nu, 800, &broken[1]);
                check_above(broken[0], 500);
                /* third order of RK3, second order of Verlet */
                check_at_most(fabs(coarse), 1e-4);
                check_at_most(fabs(fine), fabs(coarse) / (verlet ? 12 : 50));
            }
}

/* At 0.99 of the stable step, which is that of the whole body, a damaged one keeps its energy: no damage makes it
 * stiffer than that, or gives a deformation a negative energy. */
static void test_damaged_is_stable(void **state) {
    (void)state;
    static const double parts[] = {0, 0.3, 0.6, 0.85, 0.97};
    for (int k = 0; k < RATIOS; k++)
        for (int part = 0; part < 5; part++) {
            if (check_skips(5 * k + part, 7)) continue;
            struct solid *s = make((struct make){.sites = {9, 8, 10}, .ratio_excess = ratios[k] - 0.25});
            s->stage.integrator = SOLID_VERLET;
            s->stage.breakage = 0;
            const double step = 0.99 * solid_rates_stable_step(s, SOLID_VERLET);
            damage(s, parts[part]);
            shake(s, 1e-6, 0);
            for (int h = 0; h < s->n; h++)
                for (int c = 0; c < 3; c++) s->v[c][h] = 1e-6 * SPACING / step * noise(s, h, c + 3);
            const double before = solid_energy_measure(s).kinetic;
            solid_integrate(s, step, 600);
            const struct solid_energy e = solid_energy_measure(s);
            check_at_most(e.kinetic / before, 2);
            check_at_least(e.strain, 0);
            solid_free(s);
        }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_constants),   cmocka_unit_test(test_derivative),
                                       cmocka_unit_test(test_pair_forces), cmocka_unit_test(test_stores),
                                       cmocka_unit_test(test_books),       cmocka_unit_test(test_damaged_is_stable)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
