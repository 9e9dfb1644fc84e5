/* Principal values of a tensor of permeability, against a tensor made from known ones. */
#include "physics/darcy.h"
#include "base/par.h"
#include "tests/check.h"

#include <math.h>

/* The rotation about the axis (1, 2, 2)/3 by the angle, Rodrigues' formula. */
static void rotation(double angle, double R[3][3]) {
    const double n[3] = {1.0 / 3, 2.0 / 3, 2.0 / 3}, c = cos(angle), s = sin(angle);
    const double cross[3][3] = {{0, -n[2], n[1]}, {n[2], 0, -n[0]}, {-n[1], n[0], 0}};
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) R[i][j] = c * (i == j) + s * cross[i][j] + (1 - c) * n[i] * n[j];
}

static void turned_back(void **state) {
    (void)state;
    const double value[3] = {5e-12, 2e-12, 3e-13};
    for (int q = 0; q < 7; q++) {
        double R[3][3], K[3][3] = {{0}};
        rotation(0.9 * q, R);
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++)
                for (int k = 0; k < 3; k++) K[i][j] += R[i][k] * value[k] * R[j][k];
        const double odd = 1e-14;
        K[0][1] += odd, K[1][0] -= odd; /* changes nothing but the asymmetry */
        const struct physics_darcy_principal p = physics_darcy_principal_of((const double(*)[3])K);
        for (int k = 0; k < 3; k++) {
            double dot = 0, length = 0, most = 0;
            check_relative(p.value[k], value[k], 1e-12);
            for (int i = 0; i < 3; i++) {
                dot += p.along[k][i] * R[i][k];
                length += p.along[k][i] * p.along[k][i];
                if (fabs(p.along[k][i]) > fabs(most)) most = p.along[k][i];
            }
            check_relative(fabs(dot), 1, 1e-12);
            check_relative(length, 1, 1e-12);
            check_above(most, 0);
        }
        const double even = 4 * (value[0] * value[0] + value[1] * value[1] + value[2] * value[2]);
        check_relative(p.asymmetry, sqrt(8 * odd * odd / even), 1e-9);
    }
}

static void the_unit(void **state) {
    (void)state;
    /* 1 cm3/s of 1 cP through 1 cm of 1 cm2 by 1 atm */
    check_relative(PHYSICS_DARCY, 1e-6 * 1e-3 * 1e-2 / (1e-4 * 101325), 1e-6);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(turned_back), cmocka_unit_test(the_unit)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
