/* Energy released by a cleaved block per area against the bonds' sum.  (001: eq. 3.26) */
#include "tests/solid/make.h"
#include "solid/bonds/ghosts.h"
#include "solid/force/force.h"
#include "solid/law/material.h"
#include "solid/solid.h"
#include "tests/check.h"

static const double FRACTURE_ENERGY = 0.05;
enum { SITES = 8, UP = 2 };

static double length_of(const double xi[3]) { return sqrt(xi[0] * xi[0] + xi[1] * xi[1] + xi[2] * xi[2]); }

/* G/G0 of a plane between two layers: the sum over one family of xi_z times the energy of a bond of stretch s0,
 * J/m2. */
static double cleaved(const struct solid *s, struct solid_family_view *view, int h, double stretch) {
    const double c0 = solid_material_micromodulus(s->in.material, SPACING);
    double sum = 0;
    solid_family_view(s, h, view);
    for (int b = 0; b < view->n; b++)
        if (view->xi[b][UP] > 0)
            sum += 0.5 * c0 * stretch * stretch * length_of(view->xi[b]) * view->weight[b] * view->xi[b][UP];
    return sum;
}

/* A plane cut through the block cuts the bonds across it and no others: the sum over pairs equals the sum over one
 * family. */
static void test_bonds_across_a_plane(void **state) {
    (void)state;
    static struct solid_family_view view;
    const double a = SITES * SPACING, x[2] = {-a, 2 * a};
    const double point[4][3] = {{x[0], x[0], a}, {x[1], x[0], a}, {x[1], x[1], a}, {x[0], x[1], a}};
    const struct solid_cut cut = {4, point};
    for (int list = 0; list < 2; list++) {
        struct solid *s = make((struct make){.sites = {SITES, SITES, 2 * SITES},
                                             .periodic = {1, 1, 0},
                                             .list = list,
                                             .uncorrected = 1,
                                             .fracture_energy = FRACTURE_ENERGY,
                                             .cuts = 1,
                                             .cut = &cut});
        const double c0 = solid_material_micromodulus(s->in.material, SPACING);
        const double s0 = solid_material_critical_stretch(s->in.material, SPACING);
        double sum = 0, one = 0;
        for (int h = 0; h < s->n; h++) {
            solid_family_view(s, h, &view);
            for (int b = 0; b < view.n; b++)
                if (!view.intact[b]) /* half of it: seen from both ends */
                    sum += 0.25 * c0 * s0 * s0 * length_of(view.xi[b]) * view.weight[b] * s->volume[h];
            if (fabs(s->x0[UP][h] - 3.5 * SPACING) < 0.1 * SPACING) one = cleaved(s, &view, h, s0);
        }
        sum = par_sum(sum) / (a * a * FRACTURE_ENERGY);
        one = par_max(one) / FRACTURE_ENERGY;
        check_close(one, 1.0131175, 2e-6); /* cases/verification/lattice.awk */
        check_close(sum / one, 1, 1e-12);
        solid_free(s);
    }
}

/* Two halves moved apart at once: e_fracture is the energy that their bonds stored when they broke. */
static void test_released(void **state) {
    (void)state;
    static struct solid_family_view view;
    const double a = SITES * SPACING;
    for (int list = 0; list < 2; list++) {
        struct solid *s = make((struct make){.sites = {SITES, SITES, 2 * SITES},
                                             .periodic = {1, 1, 0},
                                             .list = list,
                                             .uncorrected = 1,
                                             .fracture_energy = FRACTURE_ENERGY});
        double across = 0; /* bonds across the plane, for each particle of a layer */
        const double c0 = solid_material_micromodulus(s->in.material, SPACING), gap = 0.05 * SPACING;
        double held = 0;
        for (int h = 0; h < s->n; h++) s->d[UP][h] = s->x0[UP][h] > a ? gap : 0;
        solid_ghosts_update(s);
        for (int h = 0; h < s->n; h++) {
            solid_family_view(s, h, &view);
            for (int b = 0; b < view.n; b++) {
                const double *xi = view.xi[b], open = s->d[UP][view.l[b]] - s->d[UP][h];
                const double now[3] = {xi[0], xi[1], xi[2] + open};
                const double stretch = length_of(now) / length_of(xi) - 1;
                held += 0.25 * c0 * stretch * stretch * length_of(xi) * view.weight[b] * s->volume[h];
                if (xi[UP] > 0 && fabs(s->x0[UP][h] - 3.5 * SPACING) < 0.1 * SPACING) across += xi[UP] / SPACING;
            }
        }
        solid_force(s, 1);
        solid_family_count(s);
        check_close(par_sum(s->e_fracture) / par_sum(held), 1, 1e-12);
        assert_int_equal(s->bonds_broken, lrint(par_sum(across)));
        solid_free(s);
    }
}

/* crack_area of planes along [100], [110] and [111], in both stores: the plane's area times what the bonds across it
 * hold over G0. Every second layer, half a period thick, is moved along itself, which breaks all bonds across its two
 * faces. A plane that is cut from the start has no part in it. */
static void test_area(void **state) {
    (void)state;
    enum { N = 14 };
    static struct solid_family_view view;
    static const int normal[3][3] = {{0, 0, 1}, {1, 1, 0}, {1, 1, 1}};
    static const double expected[3] = {1.0131175, 1.02871, 1.03336};
    for (int way = 0; way < 3; way++)
        for (int kind = 0; kind < 4; kind++) { /* both stores; Poisson's ratios of 1/4 and 0.4 */
            if (check_skips(way + kind, 2)) continue;
            struct solid *s = make((struct make){.sites = {N, N, N},
                                                 .periodic = {1, 1, 1},
                                                 .list = kind & 1,
                                                 .uncorrected = 1,
                                                 .fracture_energy = FRACTURE_ENERGY,
                                                 .ratio_excess = kind & 2 ? 0.15 : 0});
            const int *e = normal[way];
            const double c0 = solid_material_micromodulus(s->in.material, SPACING),
                         s0 = solid_material_critical_stretch(s->in.material, SPACING),
                         steep = sqrt(e[0] * e[0] + e[1] * e[1] + e[2] * e[2]);
            double held = 0;
            for (int h = 0; h < s->n; h++) {
                int layer = 0;
                for (int c = 0; c < 3; c++) layer += e[c] * (int)floor(s->x0[c][h] / SPACING);
                s->d[0][h] = layer % N < N / 2 ? 10 * SPACING : 0;
                s->d[1][h] = way == 0 || layer % N >= N / 2 ? 0 : -10 * SPACING;
            }
            solid_ghosts_update(s);
            if (s->n > 0) {
                solid_family_view(s, 0, &view);
                for (int b = 0; b < view.n; b++) {
                    const double *xi = view.xi[b];
                    const double along = (xi[0] * e[0] + xi[1] * e[1] + xi[2] * e[2]) / steep;
                    if (along > 0) held += 0.5 * c0 * s0 * s0 * length_of(xi) * view.weight[b] * along;
                }
            }
            held = par_max(held) / solid_material_bonds_energy(PHYSICS_3D, s->in.material);
            solid_force(s, 1);
            const double side = N * SPACING, area = par_sum(s->crack_area) / (2 * steep * side * side);
            print_message("[%d%d%d]: crack_area over the plane's area %.7f\n", e[0], e[1], e[2], area);
            check_close(area / held, 1, 1e-12);
            check_close(area, expected[way], way == 0 ? 2e-6 : 2e-5);
            if (!(kind & 2)) check_above(par_sum(s->e_fracture), FRACTURE_ENERGY * par_sum(s->crack_area));
            solid_free(s);
        }
    const double a = SITES * SPACING, x[2] = {-a, 2 * a};
    const double point[4][3] = {{x[0], x[0], a}, {x[1], x[0], a}, {x[1], x[1], a}, {x[0], x[1], a}};
    const struct solid_cut cut = {4, point};
    struct solid *s = make(
        (struct make){.sites = {SITES, SITES, 2 * SITES}, .fracture_energy = FRACTURE_ENERGY, .cuts = 1, .cut = &cut});
    solid_force(s, 1);
    solid_family_count(s);
    check_above(s->bonds_broken, 0);
    check_equal(par_sum(s->crack_area), 0);
    solid_free(s);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_bonds_across_a_plane),
        cmocka_unit_test(test_released),
        cmocka_unit_test(test_area),
    };
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
