#include "solid/tensors.h"

#include "solid/measures.h"

#include <math.h>

/* Turns the plane (p, q) so that a[p][q] = 0; v holds the turns so far, by columns. */
static void rotate(double a[3][3], double v[3][3], int p, int q) {
    if (a[p][q] == 0) return;
    const double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
    const double t = copysign(1, theta) / (fabs(theta) + sqrt(theta * theta + 1));
    const double c = 1 / sqrt(t * t + 1), s = t * c;
    const int r = 3 - p - q;
    const double apq = a[p][q], apr = a[p][r], aqr = a[q][r];
    a[p][p] -= t * apq;
    a[q][q] += t * apq;
    a[p][q] = a[q][p] = 0;
    a[p][r] = a[r][p] = c * apr - s * aqr;
    a[q][r] = a[r][q] = s * apr + c * aqr;
    for (int k = 0; k < 3; k++) {
        const double vp = v[k][p], vq = v[k][q];
        v[k][p] = c * vp - s * vq;
        v[k][q] = s * vp + c * vq;
    }
}

void solid_tensors_eigen(const double t[6], double value[3], double vector[3][3]) {
    double a[3][3] = {{t[0], t[3], t[5]}, {t[3], t[1], t[4]}, {t[5], t[4], t[2]}};
    double v[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int sweep = 0; sweep < 12; sweep++) { /* converges quadratically: five or six do */
        rotate(a, v, 0, 1);
        rotate(a, v, 0, 2);
        rotate(a, v, 1, 2);
    }
    int order[3] = {0, 1, 2};
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2 - i; j++)
            if (a[order[j]][order[j]] < a[order[j + 1]][order[j + 1]]) {
                const int k = order[j];
                order[j] = order[j + 1];
                order[j + 1] = k;
            }
    for (int k = 0; k < 3; k++) {
        value[k] = a[order[k]][order[k]];
        for (int c = 0; c < 3; c++) vector[k][c] = v[c][order[k]];
    }
}

void solid_tensors_inverse(const double t[6], double small, double inverse[6]) {
    double value[3], v[3][3];
    solid_tensors_eigen(t, value, v);
    for (int i = 0; i < 6; i++) inverse[i] = 0;
    for (int k = 0; k < 3; k++) {
        if (!(value[k] > small * value[0])) continue;
        const double w = 1 / value[k];
        for (int c = 0; c < 3; c++) {
            inverse[c] += w * v[k][c] * v[k][c];
            inverse[3 + c] += w * v[k][c] * v[k][(c + 1) % 3];
        }
    }
}

void solid_measure_principal(const double t[6], double value[3]) {
    double vector[3][3];
    solid_tensors_eigen(t, value, vector);
}

double solid_measure_von_mises(const double t[6]) {
    const double xy = t[0] - t[1], yz = t[1] - t[2], zx = t[2] - t[0];
    return sqrt(0.5 * (xy * xy + yz * yz + zx * zx) + 3 * (t[3] * t[3] + t[4] * t[4] + t[5] * t[5]));
}
