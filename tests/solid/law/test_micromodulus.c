/* Every micromodulus of the table: its constants by quadrature, a strained body's energy, breakage at s0. */
#include "tests/solid/make.h"
#include "physics/micromodulus.h"
#include "solid/bonds/ghosts.h"
#include "solid/force/force.h"
#include "solid/measure/energy.h"
#include "tests/check.h"

#include <stdlib.h>

static const double ENERGY = 0.05, THICKNESS = 2e-3, HORIZON = 3 * 1.5625e-3;

static int dim_of(enum physics_model model) { return model == PHYSICS_3D ? 3 : 2; }

/* Energy density of a uniform stretch s = 1 in all directions of the model: of the bonds, by the midpoint rule, and of
 * the continuum. */
static void energies(enum physics_model model, const struct physics_micromodulus_law *law, double c, double pair[2]) {
    enum { N = 20000 };
    double sum = 0;
    for (int i = 0; i < N; i++) {
        const double q = (i + 0.5) / N, xi = q * HORIZON;
        const double shell = model == PHYSICS_3D ? 4 * M_PI * xi * xi : 2 * M_PI * xi * THICKNESS;
        sum += 0.25 * c * law->profile(q) * xi * shell * HORIZON / N;
    }
    pair[0] = sum;
    pair[1] = YOUNG * (model == PHYSICS_3D ? 3 : model == PHYSICS_PLANE_STRESS ? 1.5 : 1.6);
}

/* Energy of all bonds across a plane, per area of it: a point z below the plane has the bonds of a length xi > z within
 * the angle acos(z/xi) of the normal.  (001: eq. 3.26; 000: eq. 16) */
static double energy_across(enum physics_model model, const struct physics_micromodulus_law *law, double c, double s0) {
    enum { N = 400, M = 2000 };
    double sum = 0;
    for (int i = 0; i < N; i++) {
        const double q = (i + 0.5) / N, xi = q * HORIZON;
        double within = 0; /* int dz of the measure of directions */
        for (int j = 0; j < M; j++) {
            const double u = (j + 0.5) / M; /* z/xi */
            within += (model == PHYSICS_3D ? 2 * M_PI * (1 - u) : 2 * acos(u)) * xi / M;
        }
        const double ring = model == PHYSICS_3D ? xi * xi : xi * THICKNESS;
        sum += 0.5 * c * law->profile(q) * s0 * s0 * xi * ring * within * HORIZON / N;
    }
    return sum;
}

static void test_constants(void **state) {
    (void)state;
    for (int kind = 0; kind < PHYSICS_MICROMODULI; kind++)
        for (int model = 0; model < PHYSICS_MODELS; model++) {
            const struct physics_micromodulus_law *law = physics_micromodulus_of(kind);
            const struct solid_material m = {YOUNG, DENSITY, ENERGY, 3, kind, 0, 0};
            const struct physics_bond is = solid_material_constants(model, THICKNESS, &m, HORIZON);
            double energy[2];
            energies(model, law, is.c, energy);
            check_close(energy[0] / energy[1], 1, 1e-7);
            /* the angle's slope at u = 1 is infinite: order 3/2 */
            check_close(energy_across(model, law, is.c, is.s0) / ENERGY, 1, 2e-5);
            check_close(law->profile(0), 1, 0);
            assert_true(law->ends_at_horizon == (law->profile(1) == 0));
            assert_true(law->is_constant == (law->profile(0.5) == 1));
        }
}

static struct solid *body_of(enum physics_model model, int kind) {
    enum { SITES = 13 };
    const double side = SITES * SPACING, corner[4][2] = {{0, 0}, {side, 0}, {side, side}, {0, side}},
                 centre[4][2] = {{0}};
    const signed char turn[4] = {0};
    const struct solid_outline outline = {0, 4, corner, centre, turn};
    const struct solid_body body = {.name = "block",
                                    .shape = model == PHYSICS_3D ? SOLID_BOX : SOLID_POLYGON,
                                    .high = {side, side, side},
                                    .outlines = model != PHYSICS_3D,
                                    .outline = &outline};
    const struct solid_material material = {YOUNG, DENSITY, ENERGY, 3, kind, 0, 0};
    const struct solid_input in = {.model = model,
                                   .thickness = THICKNESS,
                                   .spacing = SPACING,
                                   .bodies = 1,
                                   .body = &body,
                                   .materials = 1,
                                   .material = &material,
                                   .general_bonds = 1};
    return solid_new(&in);
}

static void stretch(struct solid *s, double by) {
    for (int c = 0; c < s->dim; c++)
        for (int h = 0; h < s->n; h++) s->d[c][h] = by * s->x0[c][h];
    solid_ghosts_update(s);
}

/* In a strained lattice no force inside, and the continuum's energy there but for what a lattice of m = 3 makes of it.
 */
static void test_patch(void **state) {
    (void)state;
    const double by = 1e-6, scale = YOUNG / (DENSITY * SPACING) * by;
    for (int kind = 0; kind < PHYSICS_MICROMODULI; kind++)
        for (int model = 0; model < PHYSICS_MODELS; model++) {
            struct solid *s = body_of(model, kind);
            double energy[2], *energy_of = calloc((size_t)s->n + 1, sizeof *energy_of),
                              *most = calloc((size_t)s->n + 1, sizeof *most);
            energies(model, physics_micromodulus_of(kind), 1, energy);
            stretch(s, by);
            solid_force(s, 0);
            solid_energy_bonds(s, energy_of, most);
            int inside = 0;
            double part = 0;
            for (int h = 0; h < s->n; h++) {
                int deep = 1;
                for (int c = 0; c < s->dim; c++) deep &= s->x0[c][h] > 4 * SPACING && s->x0[c][h] < (13 - 4) * SPACING;
                if (!deep) continue;
                inside++;
                for (int c = 0; c < s->dim; c++) check_close(s->a[c][h] / scale, 0, 2e-5);
                check_close(energy_of[h] / (energy[1] * by * by), 1,
                            0.08); /* as tests/solid/law/test_pair.c finds at m = 3.5 */
                part = energy_of[h] / (energy[1] * by * by);
                check_close(most[h], by, 1e-9 * by);
            }
            print_message("%s, model %d: %.4f of the continuum's energy\n", physics_micromodulus_of(kind)->name, model,
                          part);
            assert_int_equal(inside, dim_of(model) == 3 ? 125 : 25);
            free(energy_of);
            free(most);
            solid_free(s);
        }
}

static void test_breakage(void **state) {
    (void)state;
    for (int kind = 0; kind < PHYSICS_MICROMODULI; kind++)
        for (int model = 0; model < PHYSICS_MODELS; model++) {
            struct solid *s = body_of(model, kind);
            const double s0 = solid_material_constants(model, THICKNESS, s->in.material, HORIZON).s0;
            stretch(s, 0.9999 * s0);
            solid_force(s, 1);
            solid_family_count(s);
            assert_int_equal(s->bonds_broken, 0);
            stretch(s, 1.0001 * s0);
            solid_force(s, 1);
            solid_family_count(s);
            assert_true(s->bonds_broken == s->bonds_total && s->bonds_total > 0);
            solid_free(s);
        }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_constants), cmocka_unit_test(test_patch),
                                       cmocka_unit_test(test_breakage)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
