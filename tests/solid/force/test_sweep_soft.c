/* Bonds that soften: the force of one bond over its stretch, energies and momentum of many, and both stores alike. */
#include "tests/solid/make.h"
#include "solid/bonds/ghosts.h"
#include "solid/bonds/soft.h"
#include "solid/force/force.h"
#include "solid/force/sweep_soft.h"
#include "solid/measure/energy.h"
#include "solid/measure/stress.h"
#include "solid/step/integrate.h"
#include "tests/check.h"
#include "tests/solid/derivative.h"

#include <stdlib.h>

static const double ENERGY = 0.05; /* J/m2 */

/* A strength that is this part of the one at which no bond softens. */
static double strength_of(double part) {
    const struct solid_material m = {YOUNG, DENSITY, ENERGY, 3, PHYSICS_CONSTANT, 0, 0};
    return part * YOUNG * solid_material_critical_stretch(&m, SPACING);
}

struct pull {
    struct solid *s;
    double s_e, s_c, stiffness; /* force on particle 0 over its mass and the stretch, m/s2 */
};

static double force_at(struct pull *p, double stretch, int may_break) {
    p->s->d[0][1] = stretch * SPACING;
    p->s->d[0][0] = 0;
    solid_force(p->s, may_break);
    check_close(p->s->a[0][0], -p->s->a[0][1], 1e-13 * p->stiffness * p->s_e); /* equal and opposite */
    return p->s->a[0][0] / p->stiffness;
}

/* force/stiffness of the law. */
static double law(const struct pull *p, double stretch, double most) {
    if (most < stretch) most = stretch;
    if (most <= p->s_e) return stretch;
    if (most >= p->s_c) return 0;
    return stretch * p->s_e * (p->s_c - most) / ((p->s_c - p->s_e) * most);
}

/* Two particles and their bond: pulled, released, pushed, pulled again, broken. */
static void test_curve(void **state) {
    (void)state;
    if (par_size() > 1) skip();
    for (int list = 0; list < 2; list++) {
        struct pull p = {
            .s = make((struct make){
                .sites = {2, 1, 1}, .list = list, .fracture_energy = ENERGY, .tensile_strength = strength_of(0.5)})};
        const double s0 = solid_material_critical_stretch(p.s->in.material, SPACING);
        p.s->stage.breakage = 1;
        assert_int_equal(p.s->n_global, 2);
        solid_soft_limits(p.s, 0, &p.s_e, &p.s_c);
        check_relative(p.s_e * p.s_c, s0 * s0, 1e-12);
        check_between(p.s_e / s0, 0.3, 0.5);
        p.stiffness = 1;
        p.stiffness = force_at(&p, 1e-3 * p.s_e, 1) / (1e-3 * p.s_e);
        const double way[] = {0.5, 0.999, 1.5, 1.2, 0.3, -0.7, 0.1, 1.4999, 1.6, 2, -3, 2.5, 0.9};
        double most = 0;
        for (size_t k = 0; k < sizeof way / sizeof way[0]; k++) {
            const double stretch = way[k] * p.s_e;
            check_close(force_at(&p, stretch, 1), law(&p, stretch, most), 1e-12 * p.s_e);
            most = fmax(most, stretch);
            assert_int_equal(p.s->soft->n, most > p.s_e ? 2 : 0);
            check_relative(solid_energy_measure(p.s).strain,
                           0.5 * p.stiffness * DENSITY * p.s->volume[0] * SPACING * stretch * law(&p, stretch, most),
                           1e-11);
        }
        /* an inner stage goes along the secant of the history that the step began with */
        check_close(force_at(&p, 3 * p.s_e, 0), 3 * p.s_e * law(&p, most, most) / most, 1e-12 * p.s_e);
        solid_family_count(p.s);
        assert_int_equal(p.s->bonds_broken, 0);
        assert_int_equal(p.s->flag[0] & SOLID_BROKEN, 0);
        check_equal(force_at(&p, 1.0001 * p.s_c, 1), 0);
        solid_family_count(p.s);
        assert_int_equal(p.s->bonds_broken, 1);
        assert_int_equal(p.s->soft->n, 0);
        assert_true(p.s->flag[0] & SOLID_BROKEN);
        check_equal(force_at(&p, -p.s_e, 1), 0);
        check_equal(solid_energy_measure(p.s).strain, 0);
        solid_free(p.s);
    }
}

/* A stage begins with a bond beyond its limit, as after an initial displacement: what it releases is what it loses. */
static void test_beyond(void **state) {
    (void)state;
    if (par_size() > 1) skip();
    for (int kind = 0; kind < 6; kind++) {
        const double stretch = kind < 4 ? 2 : 100; /* of s_e: softens; breaks at once */
        struct pull p = {.s = make((struct make){.sites = {2, 1, 1},
                                                 .list = kind & 1,
                                                 .fracture_energy = ENERGY,
                                                 .tensile_strength = strength_of(0.5)})};
        p.s->stage = (struct solid_stage){.breakage = 1, .integrator = kind & 2 ? SOLID_RK3 : SOLID_VERLET};
        solid_soft_limits(p.s, 0, &p.s_e, &p.s_c);
        p.s->d[0][1] = stretch * p.s_e * SPACING;
        const double before = solid_energy_measure(p.s).strain;
        solid_integrate(p.s, 1e-9 * step_of(1), 1);
        const struct solid_energy after = solid_energy_measure(p.s);
        check_above(after.fracture, 0.1 * before);
        check_relative(after.strain + after.fracture, before, 1e-6);
        solid_free(p.s);
    }
}

/* Goes to a stretch in a substep so short that forces change no velocity. Returns the work over it by the mean of the
 * law's forces at both ends, over the stiffness. */
static double substep_to(struct pull *p, double stretch, double *now, double *most) {
    const double dt = 1e-9 * step_of(1), before = law(p, *now, *most);
    p->s->v[0][0] = 0;
    p->s->v[0][1] = (stretch - *now) * SPACING / dt;
    p->s->a_holds = 0;
    solid_integrate(p->s, dt, 1);
    if (stretch > *most) *most = stretch;
    const double work = 0.5 * (before + law(p, stretch, *most)) * (stretch - *now);
    *now = stretch;
    return work;
}

/* A bond that is pulled until it breaks takes the energy of a brittle one, 1/2 stiffness s0^2: exactly, by Verlet's
 * sums; RK3's steps hold the secant until the next one, and take what this adds, which vanishes with the step. A bond
 * that is relieved and pushed on the way, and stretched again from there in one substep, takes Verlet's work. */
static void test_energy(void **state) {
    (void)state;
    if (par_size() > 1) skip();
    for (int kind = 0; kind < 6; kind++) {
        const int list = kind & 1, verlet = kind > 1, relieved = kind > 3;
        struct pull p = {
            .s = make((struct make){
                .sites = {2, 1, 1}, .list = list, .fracture_energy = ENERGY, .tensile_strength = strength_of(0.4)}),
            .stiffness = 1};
        const double s0 = solid_material_critical_stretch(p.s->in.material, SPACING);
        p.s->stage = (struct solid_stage){.integrator = verlet ? SOLID_VERLET : SOLID_RK3, .breakage = 1};
        solid_soft_limits(p.s, 0, &p.s_e, &p.s_c);
        p.stiffness = force_at(&p, 1e-3 * p.s_e, 1) / (1e-3 * p.s_e);
        const double scale = p.stiffness * DENSITY * p.s->volume[0] * SPACING;
        const double way[] = {1, 1.3, 0.2, 1.5, 1.4, -0.5, 0.1, 1.8, 1.7, 1.9, -1};
        const int steps = relieved ? (int)(sizeof way / sizeof *way) : verlet ? 100 : 2000;
        double now = 1e-3 * p.s_e, most = now, work = 0.5 * now * now;
        for (int k = 1; k <= steps; k++) {
            if (relieved)
                work += substep_to(&p, way[k - 1] * p.s_e, &now, &most);
            else if (verlet)
                work += substep_to(&p, p.s_c * k / steps, &now, &most);
            else
                force_at(&p, p.s_c * k / steps, 1);
        }
        if (verlet)
            work += substep_to(&p, (1 + 1e-7) * p.s_c, &now, &most);
        else
            force_at(&p, (1 + 1e-10) * p.s_c, 1);
        assert_int_equal(p.s->soft->n, 0);
        if (verlet) check_relative(p.s->e_fracture, scale * work, 1e-6);
        if (!relieved) check_relative(p.s->e_fracture, 0.5 * scale * s0 * s0, 2e-3);
        if (!verlet) check_above(p.s->e_fracture, 0.5 * scale * s0 * s0 * (1 - 1e-8));
        solid_free(p.s);
    }
}

enum { X = 7, Y = 6, Z = 8, SITES = X * Y * Z };

/* A block with noise for velocities, in which bonds soften and some break. excess: Poisson's ratio less 1/4. */
static struct solid *block(double excess, int list, int verlet, double dt, int steps, double damping) {
    struct solid *s = make((struct make){.sites = {X, Y, Z},
                                         .periodic = {0, 0, 1},
                                         .list = list,
                                         .fracture_energy = ENERGY,
                                         .tensile_strength = strength_of(0.5),
                                         .ratio_excess = excess});
    s->stage = (struct solid_stage){
        .integrator = verlet ? SOLID_VERLET : SOLID_RK3, .breakage = 1, .damping_relative = damping};
    for (int h = 0; h < s->n; h++)
        for (int c = 0; c < 3; c++) s->v[c][h] = 0.3 * noise(s, h, c);
    solid_ghosts_update(s);
    solid_integrate(s, step_of(dt), steps);
    solid_ghosts_update(s);
    solid_family_count(s);
    return s;
}

static double total(struct solid *s) {
    const struct solid_energy e = solid_energy_measure(s);
    return e.kinetic + e.strain + e.fracture + e.damped;
}

static const double excesses[] = {0, -0.55, 0.15};

/* Momentum is kept, and the energies add up to the order of the integrator: RK3's error goes with the third power of
 * the step, Verlet's with the second. With any Poisson's ratio: what the families' dilatations lose is in the sum. */
static void test_balance(void **state) {
    (void)state;
    double p0[4] = {0};
    struct solid *unmoved = block(0, 0, 0, 0, 0, 0);
    const double start = total(unmoved);
    for (int h = 0; h < unmoved->n; h++)
        for (int c = 0; c < 3; c++) p0[c] += unmoved->v[c][h];
    par_sum_array(p0, 4);
    solid_free(unmoved);
    for (int kind = 0; kind < 24; kind++) {
        const int list = kind & 1, verlet = kind >> 1 & 1, damped = kind >> 2 & 1;
        const double excess = excesses[kind >> 3];
        double drift[2];
        if ((damped && list) || check_skips(kind + 1, 5)) continue;
        for (int fine = 0; fine < 2; fine++) {
            struct solid *s = block(excess, list, verlet, fine ? 0.01 : 0.02, fine ? 80 : 40, damped ? 1e14 : 0);
            double p[4] = {0};
            check_above(par_sum_long(s->soft->n), 1500);
            check_above(s->bonds_broken, 100);
            /* in this noise what is stretched softens, and what is left of a family is compressed: above 1/4 the
             * dilatations gain nearly what the bonds lose */
            if (excess <= 0) check_above(par_sum(s->e_fracture), 0.02 * start);
            if (damped) check_above(solid_energy_measure(s).damped, 0.02 * start);
            drift[fine] = fabs(total(s) / start - 1);
            for (int h = 0; h < s->n; h++)
                for (int c = 0; c < 3; c++) {
                    p[c] += s->v[c][h];
                    p[3] += fabs(s->v[c][h]);
                }
            par_sum_array(p, 4);
            for (int c = 0; c < 3; c++) check_close(p[c], p0[c], 1e-12 * p[3]);
            solid_free(s);
        }
        print_message("ratio %g %s %s%s: energy drifts %.2g, %.2g at half the step\n", 0.25 + excess,
                      list ? "list" : "lattice", verlet ? "Verlet" : "RK3", damped ? ", damped" : "", drift[0],
                      drift[1]);
        check_below(drift[1], 2e-4);
        check_below(drift[1], 0.7 * drift[0]);
    }
}

/* Stress and energy of both stores, and the view's, agree. */
static void measures(double excess) {
    static double stress[2][SITES][6];
    double strain[2];
    for (int list = 0; list < 2; list++) {
        struct solid *s = block(excess, list, 1, 0.02, 40, 0);
        double(*own)[6] = calloc((size_t)s->n + 1, sizeof *own);
        memset(stress[list], 0, sizeof stress[list]);
        solid_stress_measure(s, own);
        for (int h = 0; h < s->n; h++) {
            int at[3];
            for (int c = 0; c < 3; c++) at[c] = (int)floor(s->x0[c][h] / SPACING);
            memcpy(stress[list][(at[2] * Y + at[1]) * X + at[0]], own[h], sizeof own[h]);
        }
        par_sum_array(&stress[list][0][0], 6 * SITES);
        strain[list] = solid_energy_measure(s).strain;
        double sum = 0, energy, most;
        for (int h = 0; h < s->n; h++) {
            solid_energy_bonds_of(s, h, &energy, &most);
            sum += energy * s->volume[h];
        }
        check_relative(par_sum(sum), strain[list], 1e-11);
        free(own);
        solid_free(s);
    }
    check_relative(strain[0], strain[1], 1e-10);
    for (int i = 0; i < SITES; i++)
        for (int k = 0; k < 6; k++) check_close(stress[0][i][k], stress[1][i][k], 1e-9 * strength_of(1));
}

static void test_measures(void **state) {
    (void)state;
    for (int k = 0; k < 3; k++)
        if (!check_skips(k, 2)) measures(excesses[k]);
}

/* Bonds that have softened keep their share: the forces are the derivative of the energy, along any displacement. */
static void test_derivative(void **state) {
    (void)state;
    for (int kind = 0; kind < 6; kind++) {
        if (check_skips(kind, 3)) continue;
        struct solid *s = block(excesses[kind >> 1], kind & 1, 1, 0.02, 40, 0);
        check_derivative(s, 1e-5, noise);
        solid_free(s);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_curve),      cmocka_unit_test(test_energy),
                                       cmocka_unit_test(test_balance),    cmocka_unit_test(test_measures),
                                       cmocka_unit_test(test_derivative), cmocka_unit_test(test_beyond)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
