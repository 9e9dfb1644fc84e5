/* Symmetric tensors that are made of known eigenvalues and a rotation. */
#include "base/par.h"
#include "base/vec.h"
#include "solid/measure/tensors.h"
#include "tests/check.h"

#include <stdlib.h>

/* Turned by three angles. */
static void axes_of(double a, double b, double c, double e[3][3]) {
    const double turn[3] = {a, b, c};
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) e[i][j] = i == j;
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 3; i++) {
            const int p = k, q = (k + 1) % 3;
            const double x = e[i][p], y = e[i][q];
            e[i][p] = cos(turn[k]) * x - sin(turn[k]) * y;
            e[i][q] = sin(turn[k]) * x + cos(turn[k]) * y;
        }
}

/* sum value_k e_k e_k, as xx yy zz xy yz zx */
static void compose(const double value[3], double e[3][3], double t[6]) {
    for (int c = 0; c < 3; c++) {
        t[c] = t[3 + c] = 0;
        for (int k = 0; k < 3; k++) {
            t[c] += value[k] * e[k][c] * e[k][c];
            t[3 + c] += value[k] * e[k][c] * e[k][(c + 1) % 3];
        }
    }
}

static const double eigenvalues[][3] = {{3, 2, 1}, {5, 0.25, -7},       {1, 1, -2},
                                        {4, 4, 4}, {0, 0, 0},           {1, 1e-9, -1e-9},
                                        {2, 0, 0}, {1e12, 5e11, -1e12}, {1e-15, 3e-16, 0}};
enum { KINDS = sizeof eigenvalues / sizeof eigenvalues[0] };

static void eigenvalues_and_vectors(void **state) {
    (void)state;
    for (int n = 0; n < 40 * KINDS; n++) {
        const double *value = eigenvalues[n % KINDS], size = fmax(fabs(value[0]), fabs(value[2]));
        double e[3][3], t[6], found[3], v[3][3], again[6];
        axes_of(0.37 * n, 0.11 * n * n, -1.3 * n, e);
        compose(value, e, t);
        solid_tensors_eigen(t, found, v);
        for (int k = 0; k < 3; k++) check_close(found[k], value[k], 4e-15 * size);
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++) {
                double dot = 0;
                for (int c = 0; c < 3; c++) dot += v[i][c] * v[j][c];
                check_close(dot, i == j, 4e-15);
            }
        compose(found, v, again);
        for (int k = 0; k < 6; k++) check_close(again[k], t[k], 8e-15 * size);
        solid_tensors_eigen(t, found, (double[3][3]){{0}});
        for (int k = 0; k < 3; k++) check_close(found[k], value[k], 4e-15 * size);
    }
}

/* A tensor in a lane has what it has alone. */
static void lanes_do_not_mix(void **state) {
    (void)state;
    vec t[6], value[3], vector[3][3];
    double one[VEC_LANES][6], largest[2 * VEC_LANES - 1], all[2 * VEC_LANES - 1][6];
    for (int i = 0; i < VEC_LANES; i++) {
        double e[3][3];
        axes_of(i, 2 * i, 0.5 - i, e);
        compose(eigenvalues[i % KINDS], e, one[i]);
        for (int k = 0; k < 6; k++) t[k][i] = one[i][k];
    }
    solid_tensors_turn(t, value, vector);
    for (int i = 0; i < VEC_LANES; i++) {
        double sum = 0;
        for (int k = 0; k < 3; k++) sum += value[k][i];
        check_close(sum, one[i][0] + one[i][1] + one[i][2], 1e-14 * fabs(eigenvalues[i % KINDS][0]));
    }
    for (int i = 0; i < 2 * VEC_LANES - 1; i++)
        for (int k = 0; k < 6; k++) all[i][k] = one[i % VEC_LANES][k];
    solid_tensors_largest(2 * VEC_LANES - 1, all, largest);
    for (int i = 0; i < 2 * VEC_LANES - 1; i++)
        check_close(largest[i], eigenvalues[i % VEC_LANES % KINDS][0],
                    4e-15 * fabs(eigenvalues[i % VEC_LANES % KINDS][0]));
}

/* The inverse has the same axes and the inverse eigenvalues; those below the limit are left out. */
static void inverse_of_what_counts(void **state) {
    (void)state;
    static const double value[][3] = {{3, 2, 1}, {1, 1, 1}, {5, 2, 0}, {1, 1e-3, 1e-9}, {7, 0, 0}, {0, 0, 0}};
    for (int n = 0; n < 6; n++) {
        double e[3][3], t[6], expected[6], inverse[3];
        vec lanes[6], found[6];
        axes_of(1 + n, 0.4 * n, 2, e);
        compose(value[n], e, t);
        for (int k = 0; k < 3; k++) inverse[k] = value[n][k] > 1e-6 * value[n][0] ? 1 / value[n][k] : 0;
        compose(inverse, e, expected);
        for (int k = 0; k < 6; k++) lanes[k] = vec_set(t[k]);
        solid_tensors_inverse(lanes, 1e-6, found);
        for (int k = 0; k < 6; k++)
            for (int i = 0; i < VEC_LANES; i++) check_close(found[k][i], expected[k], n == 3 ? 1e-8 : 1e-14);
    }
}

/* All values of many tensors, whatever the last row's length, are those of each, to round-off: a compiler may contract
 * products and sums of one of the two computations alone. */
static void sorted_values(void **state) {
    (void)state;
    enum { N = 2 * KINDS + 3 };
    double t[N][6], sorted[N][3], value[3], e[3][3];
    for (int n = 0; n < N; n++) {
        axes_of(0.7 * n, 0.2 * n * n, -0.3 * n, e);
        compose(eigenvalues[n % KINDS], e, t[n]);
    }
    solid_tensors_sorted(N, t, sorted);
    for (int n = 0; n < N; n++) {
        solid_tensors_eigen(t[n], value, (double[3][3]){{0}});
        for (int k = 0; k < 3; k++) check_close(sorted[n][k], value[k], 4e-16 * fmax(fabs(value[0]), fabs(value[2])));
    }
}

/* sigma in one direction; shear tau: sqrt(3) tau; a pressure on top changes nothing. */
static void von_mises(void **state) {
    (void)state;
    for (int pressure = 0; pressure < 2; pressure++) {
        const double p = 12.5 * pressure;
        for (int c = 0; c < 3; c++) {
            double t[6] = {p, p, p}, shear[6] = {p, p, p};
            t[c] += -2.5;
            shear[3 + c] = 1.5;
            check_close(solid_tensors_von_mises(t), 2.5, 1e-14);
            check_close(solid_tensors_von_mises(shear), sqrt(3) * 1.5, 1e-14);
        }
    }
}

static void invariants(void **state) {
    (void)state;
    double value[3], vector[3][3];
    srand(5);
    solid_tensors_eigen((double[]){1, 5, -2, 0, 0, 0}, value, (double[3][3]){{0}});
    check_equal(value[0], 5);
    check_equal(value[1], 1);
    check_equal(value[2], -2);
    check_close(solid_tensors_von_mises((double[]){7, 0, 0, 0, 0, 0}), 7, 1e-14);
    check_close(solid_tensors_von_mises((double[]){0, 0, 0, 3, 0, 0}), 3 * sqrt(3), 1e-14);
    check_close(solid_tensors_von_mises((double[]){4, 4, 4, 0, 0, 0}), 0, 1e-14);
    solid_tensors_eigen((double[]){0, 0, 0, 0, 0, 2}, value, (double[3][3]){{0}});
    check_close(value[0], 2, 1e-14);
    check_close(value[1], 0, 1e-14);
    check_close(value[2] + 2, 0, 1e-14);
    for (int k = 0; k < 200; k++) {
        double t[6], trace = 0, norm = 0;
        for (int i = 0; i < 6; i++) t[i] = (double)rand() / RAND_MAX - 0.5;
        if (k % 4 == 0) t[3] = t[4] = 0;           /* a block */
        if (k % 4 == 1) t[0] = t[1], t[3] *= 1e-9; /* nearly a double value */
        for (int c = 0; c < 3; c++) {
            trace += t[c];
            norm += t[c] * t[c] + 2 * t[3 + c] * t[3 + c];
        }
        solid_tensors_eigen(t, value, vector);
        check_at_least(value[0], value[1]);
        check_at_least(value[1], value[2]);
        check_close(value[0] + value[1] + value[2] - trace, 0, 1e-14);
        check_close(value[0] * value[0] + value[1] * value[1] + value[2] * value[2] - norm, 0, 1e-14);
        for (int i = 0; i < 3; i++) {
            const double *v = vector[i];
            const double tv[3] = {t[0] * v[0] + t[3] * v[1] + t[5] * v[2], t[3] * v[0] + t[1] * v[1] + t[4] * v[2],
                                  t[5] * v[0] + t[4] * v[1] + t[2] * v[2]};
            for (int c = 0; c < 3; c++) check_close(tv[c], value[i] * v[c], 1e-14);
            for (int j = 0; j < 3; j++) {
                const double dot = v[0] * vector[j][0] + v[1] * vector[j][1] + v[2] * vector[j][2];
                check_close(dot, i == j, 1e-14);
            }
        }
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(eigenvalues_and_vectors), cmocka_unit_test(lanes_do_not_mix),
                                       cmocka_unit_test(inverse_of_what_counts),  cmocka_unit_test(von_mises),
                                       cmocka_unit_test(sorted_values),           cmocka_unit_test(invariants)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
