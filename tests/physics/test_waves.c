/* Wave speeds against closed forms and the materials of the documents. */
#include "physics/waves.h"

#include <stddef.h>
#include "tests/check.h"

/* c_R/c_s = 0.919402 for nu = 1/4, and for a plate in plane stress with nu = 1/3, which has the same c_l/c_s = sqrt 3;
 * 0.955313 for an incompressible solid (Rayleigh 1885), near which nu = 0.4999 is. Then the materials of the documents.
 */
static void rayleigh(void **state) {
    (void)state;
    const struct physics_waves solid = physics_waves_of(PHYSICS_3D, 2.5, 0.25, 1),
                               plate = physics_waves_of(PHYSICS_PLANE_STRESS, 8 / 3., 1 / 3., 1);
    check_close(solid.shear, 1, 1e-14);
    check_close(solid.longitudinal, sqrt(3), 1e-14);
    check_close(solid.rayleigh, sqrt(2 - 2 / sqrt(3)), 1e-12); /* the root in closed form */
    check_close(solid.rayleigh, 0.919402, 5e-7);
    check_close(plate.shear, 1, 1e-14);
    check_close(plate.longitudinal, sqrt(3), 1e-14);
    check_close(plate.rayleigh, solid.rayleigh, 1e-12);
    check_close(physics_waves_of(PHYSICS_3D, 2.9998, 0.4999, 1).rayleigh, 0.955313, 1e-4);
    check_close(physics_waves_of(PHYSICS_PLANE_STRAIN, 191e9, 0.25, 8000).rayleigh, 2841.2, 0.05);
    check_close(physics_waves_of(PHYSICS_PLANE_STRAIN, 190e9, 0.25, 8000).rayleigh, 2833.8, 0.05);
    check_close(physics_waves_of(PHYSICS_PLANE_STRESS, 65e9, 1 / 3., 2235).rayleigh, 3036, 0.5);
    check_close(physics_waves_of(PHYSICS_PLANE_STRESS, 65e9, 1 / 3., 2235).longitudinal, 5720, 1);
    check_close(physics_waves_of(PHYSICS_PLANE_STRESS, 72e9, 1 / 3., 2440).rayleigh, 3058, 0.5);
}

/* Of the solid that the bonds stand for, in sqrt(E/rho): c_l^2 = 6/5 in space and 9/8 in plane stress. */
static void by_model(void **state) {
    (void)state;
    const double c2[] = {[PHYSICS_3D] = 6. / 5, [PHYSICS_PLANE_STRESS] = 9. / 8, [PHYSICS_PLANE_STRAIN] = 6. / 5};
    for (enum physics_model model = PHYSICS_3D; model <= PHYSICS_PLANE_STRAIN; model++) {
        const struct physics_waves w = physics_waves_of(model, 5, physics_model_poisson_ratio(model), 20);
        check_close(w.longitudinal, 0.5 * sqrt(c2[model]), 1e-15);
        check_close(w.longitudinal / w.shear, sqrt(3), 1e-15);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rayleigh),
        cmocka_unit_test(by_model),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
