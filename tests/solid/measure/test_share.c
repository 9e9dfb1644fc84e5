/* The share of a full family's stress that a family bears. */
#include "solid/measure/share.h"
#include "tests/solid/measure/cubes.h"
#include "tests/check.h"

/* The share of the particle nearest to a place, in spacings, of a block that is periodic along x and y. */
static double share_at(int general, int periodic, const double place[3], const double stress[6]) {
    const struct solid_body body = bodies_box(0, 0, 0, 9, 9, 9);
    struct solid_input in = bodies_input(1, &body);
    struct solid_family_view view;
    in.general_bonds = general;
    in.surface_correction = SOLID_CORRECTION_NONE;
    for (int c = 0; c < 3; c++) {
        in.length[c] = 9 * SPACING;
        in.periodic[c] = c < 2 || periodic;
    }
    struct solid *s = solid_new(&in);
    double share = 0;
    for (int h = 0; h < s->n; h++) {
        double far = 0;
        for (int c = 0; c < 3; c++) far = fmax(far, fabs(s->x0[c][h] / SPACING - place[c]));
        if (far > 0.1) continue;
        const struct solid_lattice *lattice = s->family->lattice[0];
        const struct solid_share_full none = {0};
        const struct solid_share_full full =
            lattice ? solid_share_of_lattice(lattice)
                    : solid_share_of_list(s->family->list[0], h - s->family->first[0], &none);
        solid_family_view(s, h, &view);
        share = solid_share_view(&full, &view, stress);
    }
    solid_free(s);
    return par_max(share);
}

/* A full family bears all of any stress: the sums over it are those of a cubic lattice. */
static void full_families(void **state) {
    (void)state;
    const double place[3] = {4.5, 4.5, 4.5};
    for (int general = 0; general < 2; general++)
        for (int k = 0; k < 8; k++) {
            double stress[6];
            for (int c = 0; c < 6; c++) stress[c] = bodies_random(8 * c + k, 3) - 0.5;
            check_close(share_at(general, 1, place, stress), 1, 1e-12);
        }
}

/* At a face a family bears more of a stress along the face than of one across it, and never less than a quarter. */
static void at_a_face(void **state) {
    (void)state;
    const double place[3] = {4.5, 4.5, 0.5}, along[6] = {1}, across[6] = {0, 0, 1}, none[6] = {0};
    for (int general = 0; general < 2; general++) {
        check_between(share_at(general, 0, place, along), 0.7, 0.75);
        check_between(share_at(general, 0, place, across), 0.25, 0.6);
        check_equal(share_at(general, 0, place, none), 1);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(full_families), cmocka_unit_test(at_a_face)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
