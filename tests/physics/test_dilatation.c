/* Moduli and critical stretch of materials of any Poisson's ratio against their definitions. */
#include "physics/dilatation.h"
#include "physics/bond.h"
#include "tests/check.h"

/* k and mu give E and nu back, and at the ratio of bonds alone all is theirs. */
static void test_moduli(void **state) {
    (void)state;
    for (enum physics_model model = PHYSICS_3D; model <= PHYSICS_PLANE_STRAIN; model++)
        for (double nu = PHYSICS_DILATATION_MIN; nu <= PHYSICS_DILATATION_MAX; nu += 0.05) {
            const double own = physics_model_poisson_ratio(model), e = 3e9;
            const struct physics_dilatation d = physics_dilatation_of(model, e, nu - own);
            const double mu = d.bonds_modulus / (2 * (1 + own)), k = d.bulk_modulus;
            switch (model) {
            case PHYSICS_3D:
                check_relative(9 * k * mu / (3 * k + mu), e, 1e-13);
                check_close((3 * k - 2 * mu) / (2 * (3 * k + mu)), nu, 1e-13);
                break;
            case PHYSICS_PLANE_STRESS:
                check_relative(4 * k * mu / (k + mu), e, 1e-13);
                check_close((k - mu) / (k + mu), nu, 1e-13);
                break;
            case PHYSICS_PLANE_STRAIN: /* E/(1 - nu^2), nu/(1 - nu) in the plane */
                check_relative(4 * k * mu / (k + mu), e / (1 - nu * nu), 1e-13);
                check_close((k - mu) / (k + mu), nu / (1 - nu), 1e-13);
            }
            /* the stretch falls as the volume gets stiffer */
            if (fabs(nu - own) > 1e-6) check_above((own - nu) * (d.stretch2 - 1), 0);
        }
}

/* Madenci and Oterkus (2014): numbers by their formulas, written with kappa and mu. */
static void test_stretch(void **state) {
    (void)state;
    const double e = 2e9, g = 5, delta = 0.01;
    for (double nu = -0.4; nu < 0.45; nu += 0.1) {
        const double mu = e / (2 * (1 + nu)), k = e / (3 * (1 - 2 * nu)), plane = e / (2 * (1 - nu));
        const double space = sqrt(g / ((3 * mu + pow(0.75, 4) * (k - 5 * mu / 3)) * delta)),
                     plate = sqrt(g / ((6 * mu / M_PI + 16 * (plane - 2 * mu) / (9 * M_PI * M_PI)) * delta));
        check_relative(physics_bond_elastic(PHYSICS_3D, PHYSICS_CONSTANT, 1, e, nu - 0.25, g, delta).s0, space, 1e-12);
        check_relative(physics_bond_elastic(PHYSICS_PLANE_STRESS, PHYSICS_CONSTANT, 1, e, nu - 1. / 3, g, delta).s0,
                       plate, 1e-12);
    }
}

static void test_own(void **state) {
    (void)state;
    check_equal(physics_dilatation_ratio_excess(PHYSICS_3D, 0.25), 0);
    check_equal(physics_dilatation_ratio_excess(PHYSICS_PLANE_STRAIN, 0.25), 0);
    check_equal(physics_dilatation_ratio_excess(PHYSICS_PLANE_STRESS, 0.333), 0);
    check_equal(physics_dilatation_ratio_excess(PHYSICS_PLANE_STRESS, 0.3334), 0);
    check_above(physics_dilatation_ratio_excess(PHYSICS_PLANE_STRESS, 0.3335), 0);
    check_close(physics_dilatation_ratio_excess(PHYSICS_3D, 0.3), 0.05, 1e-15);
    check_equal(physics_dilatation_ratio(PHYSICS_PLANE_STRESS, 0.3333), 1. / 3);
    const struct physics_bond bonds = physics_bond_of(PHYSICS_3D, PHYSICS_CONSTANT, 1, 3, 2, 0.1),
                              same = physics_bond_elastic(PHYSICS_3D, PHYSICS_CONSTANT, 1, 3, 0, 2, 0.1);
    check_equal(same.c, bonds.c);
    check_equal(same.s0, bonds.s0);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_moduli), cmocka_unit_test(test_stretch),
                                       cmocka_unit_test(test_own)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
