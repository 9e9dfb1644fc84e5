/* Cracks of a plate: initial cuts, released energy, contact of the faces, stress and strain. */
/* Cracks of a plate: initial ones, the energy released by a straight one, contact of its faces, stress and strain
 * before. */
#include "tests/solid/make_plate.h"
#include "solid/bonds/ghosts.h"
#include "solid/contact/contact.h"
#include "solid/force/force.h"
#include "solid/measure/damage.h"
#include "solid/measure/energy.h"
#include "solid/measure/stress.h"
#include "solid/solid.h"
#include "solid/step/integrate.h"
#include "tests/check.h"

/* Sum of (1/2) c s0^2 |xi| Gamma V V of the bonds that a cut across a periodic plate has broken, over its area and G0:
 * the lattice's G(10)/G0 (m = 3: exact areas 1.02801, ramp 1.03424). A bond is broken from both ends, is damage, and
 * has released nothing. */
static void test_straight_cut(void **state) {
    (void)state;
    static struct solid_family_view view;
    for (int kind = 0; kind < 4; kind++) {
        const double line[2][3] = {{-SPACING, 9 * SPACING, 0}, {15 * SPACING, 9 * SPACING, 0}};
        const struct solid_cut cut = {2, line};
        struct solid *s = make((struct make){.sites = {14, 18},
                                             .periodic = {1, 0},
                                             .model = kind & 1 ? PHYSICS_PLANE_STRAIN : PHYSICS_PLANE_STRESS,
                                             .partial = kind & 2 ? SOLID_PARTIAL_RAMP : SOLID_PARTIAL_EXACT,
                                             .brittle = 1,
                                             .cuts = 1,
                                             .cut = &cut});
        const double strain2 =
            (s->in.model == PHYSICS_PLANE_STRESS ? 4 * M_PI / 9 : 5 * M_PI / 12) * G0 / (YOUNG * 3 * SPACING);
        double sum = 0, *phi = malloc(((size_t)s->n + 1) * sizeof *phi);
        solid_damage_measure(s, phi);
        for (int h = 0; h < s->n; h++) {
            int lost = 0;
            solid_family_view(s, h, &view);
            for (int b = 0; b < view.n; b++) {
                const double from = s->x0[1][h] - 9 * SPACING, to = from + view.xi[b][1];
                assert_int_equal(view.intact[b], from * to > 0);
                lost += !view.intact[b];
                if (!view.intact[b])
                    sum += 0.25 * view.micro[b] * view.alpha[b] * strain2 * hypot(view.xi[b][0], view.xi[b][1]) *
                           view.weight[b] * s->volume[h];
            }
            check_equal(lost > 0, phi[h] > 0.01);
            assert_true((phi[h] > 0 || !(s->flag[h] & SOLID_BROKEN)));
        }
        free(phi);
        check_close(par_sum(sum) / (14 * SPACING * THICKNESS * G0), kind & 2 ? 1.03424 : 1.02801, 1e-4);
        check_close(s->e_fracture, 0, 0);
        solid_free(s);
    }
}

/* The same number when the halves are drawn apart little by little, and each bond breaks just beyond s0. */
static void test_drawn_apart(void **state) {
    (void)state;
    struct solid *s = make((struct make){.sites = {14, 18}, .periodic = {1, 0}, .brittle = 1});
    for (int step = 1; step <= 600; step++) {
        for (int h = 0; h < s->n; h++) s->d[1][h] = s->x0[1][h] > 9 * SPACING ? step * 2e-8 : 0;
        solid_ghosts_update(s);
        solid_force(s, 1);
    }
    solid_family_count(s);
    const double ratio = par_sum(s->e_fracture) / (14 * SPACING * THICKNESS * G0);
    check_above(s->bonds_broken, 100);
    check_close(ratio, 1.028, 0.01);
    solid_free(s);
}

/* Lips of a cut that run into each other are thrown back: momentum stays, and energy with the repulsion's. */
static void test_lips(void **state) {
    (void)state;
    const double line[2][3] = {{-SPACING, 8 * SPACING, 0}, {13 * SPACING, 8 * SPACING, 0}};
    const struct solid_cut cut = {2, line};
    struct solid *s = make((struct make){.sites = {12, 16}, .cuts = 1, .cut = &cut, .contact = 1});
    double momentum[2] = {0}, closed = 0, worst = 0;
    s->stage.breakage = 0;
    for (int h = 0; h < s->n; h++) s->v[1][h] = s->x0[1][h] > 8 * SPACING ? -3 : 3;
    solid_ghosts_update(s);
    const double start = balance_of(s, NULL);
    for (int i = 0; i < 60; i++) {
        solid_contact_update(s);
        solid_integrate(s, step_of(0.05), 16);
        solid_ghosts_update(s);
        const double held = solid_contact_force_energy(s);
        closed = fmax(closed, held);
        worst = check_worst(worst, balance_of(s, NULL) + held - start);
    }
    for (int h = 0; h < s->n; h++)
        for (int c = 0; c < 2; c++) momentum[c] += s->volume[h] * s->v[c][h];
    par_sum_array(momentum, 2);
    const double volume = 12 * 16 * SPACING * SPACING * THICKNESS;
    for (int c = 0; c < 2; c++) check_close(momentum[c] / (3 * volume), 0, 1e-12);
    check_above(closed, 0.01 * start);
    check_close(worst / start, 0, 2e-3);
    solid_free(s);
}

/* Two plates that meet: strangers, on one rank or several. */
static void test_meeting(void **state) {
    (void)state;
    const double low[4][2] = {{0, 0}, {8 * SPACING, 0}, {8 * SPACING, 10 * SPACING}, {0, 10 * SPACING}};
    const double high[4][2] = {
        {10 * SPACING, 0}, {18 * SPACING, 0}, {18 * SPACING, 10 * SPACING}, {10 * SPACING, 10 * SPACING}};
    const signed char turn[4] = {0};
    const struct solid_outline outline[2] = {{0, 4, low, low, turn}, {0, 4, high, high, turn}};
    const struct solid_body body[2] = {{.name = "a", .shape = SOLID_POLYGON, .outlines = 1, .outline = &outline[0]},
                                       {.name = "b", .shape = SOLID_POLYGON, .outlines = 1, .outline = &outline[1]}};
    const struct solid_material material = {YOUNG, DENSITY, INFINITY, 3, PHYSICS_CONSTANT, 0, 0};
    const struct solid_input in = {.model = PHYSICS_PLANE_STRAIN,
                                   .thickness = THICKNESS,
                                   .spacing = SPACING,
                                   .bodies = 2,
                                   .body = body,
                                   .materials = 1,
                                   .material = &material,
                                   .contact = 1,
                                   .contact_stiffness = 15,
                                   .contact_exponent = 1,
                                   .contact_radius = 1,
                                   .surface_correction = 1};
    struct solid *s = solid_new(&in);
    s->stage = (struct solid_stage){.integrator = SOLID_VERLET};
    for (int h = 0; h < s->n; h++) s->v[0][h] = s->body[h] ? -20 : 20;
    solid_ghosts_update(s);
    double touched = 0;
    for (int i = 0; i < 1000; i++) {
        solid_contact_update(s);
        solid_integrate(s, step_of(0.25), 2);
        solid_ghosts_update(s);
        touched = fmax(touched, solid_contact_force_energy(s));
    }
    double speed[2] = {0};
    for (int h = 0; h < s->n; h++) speed[s->body[h]] += s->v[0][h] / 80;
    par_sum_array(speed, 2);
    check_above(touched, 0);
    check_close(speed[0] + speed[1], 0, 1e-9);
    check_below(speed[0], -10);
    check_above(speed[1], 10); /* back with most of it, the rest rings */
    solid_free(s);
}

/* Stress of a uniform strain in the bulk (m = 3, exact areas: C11 = 1.02200, C12 = 0.98967 of the continuum's), and the
 * component across the plate that keeps it plane; strain exact everywhere. */
static void test_tensors(void **state) {
    (void)state;
    for (int strain = 0; strain < 2; strain++) {
        struct solid *s =
            make((struct make){.sites = {16, 16}, .model = strain ? PHYSICS_PLANE_STRAIN : PHYSICS_PLANE_STRESS});
        const double c11 = 1.02200 * (strain ? 1.2 : 9. / 8) * YOUNG, c12 = 0.98967 * (strain ? 0.4 : 3. / 8) * YOUNG;
        const double g[3] = {3e-7, -1e-7, 2e-7}; /* xx, yy, xy */
        double(*t)[6] = malloc(((size_t)s->n + 1) * sizeof *t);
        for (int h = 0; h < s->n; h++) {
            s->d[0][h] = g[0] * s->x0[0][h] + g[2] * s->x0[1][h];
            s->d[1][h] = g[2] * s->x0[0][h] + g[1] * s->x0[1][h];
        }
        solid_ghosts_update(s);
        solid_stress_measure(s, t);
        for (int h = 0; h < s->n; h++) {
            int in = 1;
            for (int c = 0; c < 2; c++) in &= fabs(s->x0[c][h] - 8 * SPACING) < SPACING;
            if (!in) continue;
            const double xx = c11 * g[0] + c12 * g[1], yy = c12 * g[0] + c11 * g[1];
            check_close(t[h][0] / xx, 1, 1e-3);
            check_close(t[h][1], yy, 1e-3 * xx);
            check_close(t[h][2], strain ? 0.25 * (xx + yy) : 0, 1e-3 * xx);
            check_close(t[h][3], 2 * c12 * g[2], 1e-3 * xx);
            check_equal(t[h][4], 0);
            check_equal(t[h][5], 0);
        }
        solid_stress_strain(s, t);
        for (int h = 0; h < s->n; h++) {
            const double expected[6] = {g[0], g[1], strain ? 0 : -0.5 * (g[0] + g[1]), g[2], 0, 0};
            for (int k = 0; k < 6; k++) check_close(t[h][k], expected[k], 1e-12);
        }
        free(t);
        solid_free(s);
    }
}

/* Energy density and largest stretch: of a homothety s, everywhere s, and W sums to the strain energy. */
static void test_bonds(void **state) {
    (void)state;
    struct solid *s = make((struct make){.sites = {16, 9}, .irregular = 0.2, .micromodulus = PHYSICS_CONICAL});
    double *w = malloc(((size_t)s->n + 1) * sizeof *w), *most = malloc(((size_t)s->n + 1) * sizeof *most), sum;
    for (double stretch = 1e-3; stretch < 0.05; stretch *= 10) { /* by the series, and beyond it */
        for (int h = 0; h < s->n; h++)
            for (int c = 0; c < 2; c++) s->d[c][h] = stretch * s->x0[c][h];
        solid_ghosts_update(s);
        solid_energy_bonds(s, w, most);
        sum = 0;
        for (int h = 0; h < s->n; h++) {
            check_close(most[h], stretch, 1e-12);
            sum += w[h] * s->volume[h];
        }
        sum = par_sum(sum);
        check_close(sum / solid_energy_measure(s).strain, 1, 1e-12);
    }
    free(w);
    free(most);
    solid_free(s);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_straight_cut), cmocka_unit_test(test_drawn_apart), cmocka_unit_test(test_lips),
        cmocka_unit_test(test_meeting),      cmocka_unit_test(test_tensors),     cmocka_unit_test(test_bonds),
    };
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
