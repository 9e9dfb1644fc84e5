/* Damage beside a cut, and its equality with the sum over the view. */
#include "solid/measure/damage.h"
#include "tests/solid/measure/cubes.h"
#include "tests/check.h"

/* Beside a crack, layer by layer: the broken part of the families at a flat face. Of a complete family's .98989 V0
 * these remain: .6142, .8341, .9704. */
static void damage_beside_a_cut(void **state) {
    (void)state;
    for (int general = 0; general < 2; general++) {
        const struct solid_body body = bodies_box(0, 0, 0, 10, 10, 12);
        struct solid_input in = bodies_input(1, &body);
        in.general_bonds = general;
        for (int c = 0; c < 2; c++) {
            in.periodic[c] = 1;
            in.length[c] = 10 * SPACING;
        }
        in.length[2] = 1;
        struct solid *s = solid_new(&in);
        double *phi = malloc(((size_t)s->n + 1) * sizeof *phi);
        solid_damage_measure(s, phi);
        for (int h = 0; h < s->n; h++) check_equal(phi[h], 0);
        bodies_cut(s, 2, 6);
        solid_damage_measure(s, phi);
        const double left[3] = {.6142 / .98989, .8341 / .98989, .9704 / .98989};
        for (int h = 0; h < s->n; h++) {
            int p[3];
            bodies_site(s, h, p);
            const int depth = p[2] < 6 ? 5 - p[2] : p[2] - 6;
            if (depth < 3) check_close(1 - phi[h] - left[depth], 0, 1e-3);
            if (depth >= 3) check_equal(phi[h], 0);
        }
        free(phi);
        solid_free(s);
    }
}

/* One minus the intact part of the family's volume, by the view, where bonds are broken at random. */
static void sum_over_the_view(void **state) {
    (void)state;
    struct solid_family_view view;
    for (int general = 0; general < 2; general++) {
        struct solid *s = cube_new(7, general, 1);
        double *phi = malloc(((size_t)s->n + 1) * sizeof *phi), most = 0;
        for (int h = 0; h < s->n; h++) {
            solid_family_view(s, h, &view);
            for (int b = 0; b < view.n; b++)
                if (bodies_random(bodies_id(s, h), b) < 0.3) solid_family_break(s, h, b);
        }
        solid_damage_measure(s, phi);
        for (int h = 0; h < s->n; h++) {
            double all = 0, intact = 0;
            solid_family_view(s, h, &view);
            for (int b = 0; b < view.n; b++) {
                all += view.weight[b];
                intact += view.intact[b] * view.weight[b];
            }
            check_close(phi[h], 1 - intact / all, 1e-13);
            most = fmax(most, phi[h]);
        }
        check_between(par_max(most), 0.4, 0.9);
        free(phi);
        solid_free(s);
    }
}

/* A particle that has lost all its bonds has the damage 1, to the last digits. */
static void isolated(void **state) {
    (void)state;
    struct solid_family_view view;
    for (int general = 0; general < 2; general++) {
        struct solid *s = cube_new(4, general, 1);
        double *phi = malloc(((size_t)s->n + 1) * sizeof *phi);
        for (int h = 0; h < s->n; h++) {
            solid_family_view(s, h, &view);
            for (int b = 0; b < view.n; b++) solid_family_break(s, h, b);
        }
        solid_damage_measure(s, phi);
        for (int h = 0; h < s->n; h++) check_close(phi[h], 1, 1e-14);
        free(phi);
        solid_free(s);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(damage_beside_a_cut), cmocka_unit_test(sum_over_the_view),
                                       cmocka_unit_test(isolated)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
