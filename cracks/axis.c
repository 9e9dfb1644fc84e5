/* The area of a particle at which the faces of several cracks cancel. */
#include "cracks/axis.h"

#include <math.h>

/* The eigenvector of the largest eigenvalue of a symmetric matrix, by squaring it: (A/|A|)^(2^k) tends to n n. */
static cracks_vec main_axis(double a[3][3]) {
    for (int turn = 0; turn < 30; turn++) {
        double square[3][3] = {{0}}, size = 0;
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++) {
                for (int k = 0; k < 3; k++) square[i][j] += a[i][k] * a[k][j];
                size = fmax(size, fabs(square[i][j]));
            }
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++) a[i][j] = size > 0 ? square[i][j] / size : 0;
    }
    int column = 0;
    for (int i = 1; i < 3; i++)
        if (a[i][i] > a[column][column]) column = i;
    const double length = sqrt(a[0][column] * a[0][column] + a[1][column] * a[1][column] + a[2][column] * a[2][column]);
    cracks_vec n = {0};
    for (int i = 0; i < 3; i++) n[i] = length > 0 ? a[i][column] / length : 0;
    return n;
}

double cracks_axis_area(const struct cracks_table *t, int struts, const uint16_t *kind) {
    double tensor[3][3] = {{0}}, area = 0;
    for (int k = 0; k < struts; k++) {
        const cracks_vec half = t->half[kind[k]];
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++) tensor[i][j] += half[i] * half[j] / t->omega[kind[k]];
    }
    const cracks_vec n = main_axis(tensor);
    for (int k = 0; k < struts; k++) area += fabs(cracks_kernel_sum(t->half[kind[k]] * n));
    return area;
}
