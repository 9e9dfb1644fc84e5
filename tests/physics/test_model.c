/* Poisson's ratio from the elastic constants of forces along bonds of all directions. */
#include "physics/model.h"
#include "tests/check.h"

/* With bonds n of all directions alike, C_1122/C_1111 is the mean of n_x^2 n_y^2 over that of n_x^4. It is nu/(1 - nu)
 * in three dimensions and in plane strain, and nu in plane stress. The means by sums over directions: equal steps in
 * the angle of a circle, and in the height of a sphere and the angle about it. */
static void ratio_of_bonds_of_all_directions(void **state) {
    (void)state;
    enum { N = 24, HEIGHTS = 3 };
    /* Gauss's points: exact for polynomials of degree 5 in the height */
    const double height[HEIGHTS] = {-sqrt(0.6), 0, sqrt(0.6)}, weight[HEIGHTS] = {5. / 9, 8. / 9, 5. / 9};
    double plane[2] = {0, 0}, space[2] = {0, 0}; /* n_x^4, n_x^2 n_y^2 */
    for (int i = 0; i < N; i++) {
        const double x = cos(2 * M_PI * i / N), y = sin(2 * M_PI * i / N);
        plane[0] += x * x * x * x;
        plane[1] += x * x * y * y;
        for (int k = 0; k < HEIGHTS; k++) {
            const double r4 = pow(1 - height[k] * height[k], 2);
            space[0] += weight[k] * r4 * x * x * x * x;
            space[1] += weight[k] * r4 * x * x * y * y;
        }
    }
    const double nu = physics_model_poisson_ratio(PHYSICS_3D),
                 strain = physics_model_poisson_ratio(PHYSICS_PLANE_STRAIN);
    check_close(nu / (1 - nu), space[1] / space[0], 1e-14);
    check_close(strain / (1 - strain), plane[1] / plane[0], 1e-14);
    check_close(physics_model_poisson_ratio(PHYSICS_PLANE_STRESS), plane[1] / plane[0], 1e-14);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(ratio_of_bonds_of_all_directions)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
