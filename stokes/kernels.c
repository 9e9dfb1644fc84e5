/* The operators A, G and G^T on pore cells, and the loops of conjugate gradients. */
#include "stokes/kernels.h"

void stokes_kernels_viscous(int first, int end, const int (*next)[6], const uint8_t (*kind)[3],
                            const float diagonal[3][256], const double d[3], const float (*restrict u)[3],
                            float (*restrict v)[3]) {
    const float w[3] = {(float)(1 / (d[0] * d[0])), (float)(1 / (d[1] * d[1])), (float)(1 / (d[2] * d[2]))};
    for (int i = first; i < end; i++) {
        const int *q = next[i];
        for (int c = 0; c < 3; c++) {
            const float sum =
                w[0] * (u[q[0]][c] + u[q[1]][c]) + w[1] * (u[q[2]][c] + u[q[3]][c]) + w[2] * (u[q[4]][c] + u[q[5]][c]);
            v[i - first][c] = kind[i][c] == STOKES_FACES_CLOSED ? 0 : diagonal[c][kind[i][c]] * u[i][c] - sum;
        }
    }
}

void stokes_kernels_viscous_halves(int halves, const struct stokes_faces_half *half, int c, const int (*next)[6],
                                   const float diagonal[3][256], const uint8_t (*kind)[3], const double d[3],
                                   const float (*u)[3], float (*v)[3]) {
    for (int h = 0; h < halves; h++) {
        const int i = half[h].cell;
        double sum = u[next[i][half[h].inner]][c] / (d[c] * d[c]);
        for (int q = 0; q < 6; q++)
            if (q / 2 != c) sum += 0.5 * u[next[i][q]][c] / (d[q / 2] * d[q / 2]);
        v[i][c] = (float)(diagonal[c][kind[i][c]] * u[i][c] - sum);
    }
}

void stokes_kernels_momentum(int n, const int (*next)[6], const uint8_t (*kind)[3], const double diagonal[3][256],
                             const double d[3], const double force[3], const double *restrict p,
                             const double (*restrict u)[3], float (*restrict r)[3]) {
    const double w[3] = {1 / (d[0] * d[0]), 1 / (d[1] * d[1]), 1 / (d[2] * d[2])};
    for (int i = 0; i < n; i++) {
        const int *q = next[i];
        for (int c = 0; c < 3; c++) {
            const double sum = w[0] * (u[q[0]][c] + u[q[1]][c]) + w[1] * (u[q[2]][c] + u[q[3]][c]) +
                               w[2] * (u[q[4]][c] + u[q[5]][c]),
                         push = force[c] - (p[q[2 * c + 1]] - p[i]) / d[c];
            r[i][c] = kind[i][c] == STOKES_FACES_CLOSED ? 0 : (float)(push - diagonal[c][kind[i][c]] * u[i][c] + sum);
        }
    }
}

void stokes_kernels_momentum_halves(int halves, const struct stokes_faces_half *half, int c, const int (*next)[6],
                                    const double diagonal[3][256], const uint8_t (*kind)[3], const double d[3],
                                    double force, const double *p, const double (*u)[3], float (*r)[3]) {
    for (int h = 0; h < halves; h++) {
        const int i = half[h].cell;
        double sum = u[next[i][half[h].inner]][c] / (d[c] * d[c]);
        for (int q = 0; q < 6; q++)
            if (q / 2 != c) sum += 0.5 * u[next[i][q]][c] / (d[q / 2] * d[q / 2]);
        r[i][c] =
            (float)(0.5 * force - (p[next[i][2 * c + 1]] - p[i]) / d[c] - diagonal[c][kind[i][c]] * u[i][c] + sum);
    }
}

void stokes_kernels_gradient(int n, const int (*next)[6], const uint8_t (*kind)[3], const double d[3],
                             const float *restrict q, float (*restrict r)[3]) {
    const float w[3] = {(float)(1 / d[0]), (float)(1 / d[1]), (float)(1 / d[2])};
    for (int i = 0; i < n; i++)
        for (int c = 0; c < 3; c++)
            r[i][c] = kind[i][c] == STOKES_FACES_CLOSED ? 0 : w[c] * (q[next[i][2 * c + 1]] - q[i]);
}

void stokes_kernels_divergence(int n, const int (*next)[6], const double d[3], const double (*restrict u)[3],
                               float *restrict q) {
    for (int i = 0; i < n; i++) {
        double sum = 0;
        for (int c = 0; c < 3; c++) sum += (u[next[i][2 * c]][c] - u[i][c]) / d[c];
        q[i] = (float)sum;
    }
}

void stokes_kernels_divergence_float(int n, const int (*next)[6], const double d[3], const float (*restrict u)[3],
                                     float *restrict q) {
    const float w[3] = {(float)(1 / d[0]), (float)(1 / d[1]), (float)(1 / d[2])};
    for (int i = 0; i < n; i++) {
        float sum = 0;
        for (int c = 0; c < 3; c++) sum += w[c] * (u[next[i][2 * c]][c] - u[i][c]);
        q[i] = sum;
    }
}

void stokes_kernels_dots(int n, const float (*restrict s)[3], const float (*restrict v)[3], double dot[3]) {
    double sum[3] = {0};
    for (int i = 0; i < n; i++)
        for (int c = 0; c < 3; c++) sum[c] += (double)s[i][c] * v[i][c];
    for (int c = 0; c < 3; c++) dot[c] += sum[c];
}

void stokes_kernels_advance(int n, const double alpha[3], const float (*restrict s)[3], const float (*restrict v)[3],
                            float (*restrict e)[3], float (*restrict r)[3]) {
    const float a[3] = {(float)alpha[0], (float)alpha[1], (float)alpha[2]};
    for (int i = 0; i < n; i++)
        for (int c = 0; c < 3; c++) {
            e[i][c] += a[c] * s[i][c];
            r[i][c] -= a[c] * v[i][c];
        }
}

void stokes_kernels_direction(int n, const double beta[3], const float (*restrict z)[3], float (*restrict s)[3]) {
    const float b[3] = {(float)beta[0], (float)beta[1], (float)beta[2]};
    for (int i = 0; i < n; i++)
        for (int c = 0; c < 3; c++) s[i][c] = z[i][c] + b[c] * s[i][c];
}
