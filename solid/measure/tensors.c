/* Eigenvalues, pseudo-inverse, principal values and von Mises of symmetric tensors, a vec of them at a time. */
#include "solid/measure/tensors.h"
#include "base/vec.h"

#include <math.h>

static const double nothing = 1e-18; /* relative to the diagonal: a rotation would change no digit */

static inline vec size_of(vec a) { return vec_max(a, -a); }

/* Rotates in the plane (p, q) so that a[p][q] = 0; v accumulates the rotations, by columns, unless it is NULL. Returns
 * the lanes that needed a rotation. */
static inline __attribute__((always_inline)) vec_mask rotate(vec a[3][3], vec (*v)[3], int p, int q) {
    const int r = 3 - p - q;
    const vec apq = a[p][q], apr = a[p][r], aqr = a[q][r], one = vec_set(1);
    const vec_mask turns = size_of(apq) > nothing * (size_of(a[p][p]) + size_of(a[q][q]));
    const vec theta = (a[q][q] - a[p][p]) / (2 * vec_choose(turns, apq, one));
    const vec tangent = vec_choose(theta < 0, -one, one) / (size_of(theta) + vec_sqrt(theta * theta + 1));
    const vec t = vec_choose(turns, tangent, vec_set(0));
    const vec c = 1 / vec_sqrt(t * t + 1), s = t * c;
    a[p][p] -= t * apq;
    a[q][q] += t * apq;
    a[p][q] = a[q][p] = vec_choose(turns, vec_set(0), apq);
    a[p][r] = a[r][p] = c * apr - s * aqr;
    a[q][r] = a[r][q] = s * apr + c * aqr;
    for (int k = 0; k < 3 && v; k++) {
        const vec vp = v[k][p], vq = v[k][q];
        v[k][p] = c * vp - s * vq;
        v[k][q] = s * vp + c * vq;
    }
    return turns;
}

static int any(vec_mask m) { return vec_signs((vec)m) != 0; }

static inline __attribute__((always_inline)) void turn(const vec t[6], vec value[3], vec (*v)[3]) {
    vec a[3][3] = {{t[0], t[3], t[5]}, {t[3], t[1], t[4]}, {t[5], t[4], t[2]}};
    for (int sweep = 0; sweep < 12; sweep++) { /* quadratic convergence: five or six sweeps suffice */
        const vec_mask turns = rotate(a, v, 0, 1) | rotate(a, v, 0, 2) | rotate(a, v, 1, 2);
        if (!any(turns)) break;
    }
    for (int k = 0; k < 3; k++) value[k] = a[k][k];
}

void solid_tensors_turn(const vec t[6], vec value[3], vec vector[3][3]) {
    const vec zero = vec_set(0), one = vec_set(1);
    vec v[3][3] = {{one, zero, zero}, {zero, one, zero}, {zero, zero, one}};
    turn(t, value, v);
    for (int k = 0; k < 3; k++)
        for (int c = 0; c < 3; c++) vector[k][c] = v[c][k];
}

void solid_tensors_eigen(const double t[6], double value[3], double vector[3][3]) {
    vec all[6], values[3], vectors[3][3];
    for (int k = 0; k < 6; k++) all[k] = vec_set(t[k]);
    solid_tensors_turn(all, values, vectors);
    int order[3] = {0, 1, 2};
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2 - i; j++)
            if (values[order[j]][0] < values[order[j + 1]][0]) {
                const int k = order[j];
                order[j] = order[j + 1];
                order[j + 1] = k;
            }
    for (int k = 0; k < 3; k++) {
        value[k] = values[order[k]][0];
        for (int c = 0; c < 3; c++) vector[k][c] = vectors[order[k]][c][0];
    }
}

void solid_tensors_inverse(const vec t[6], double small, vec inverse[6]) {
    vec value[3], v[3][3];
    solid_tensors_turn(t, value, v);
    const vec least = small * vec_max(value[0], vec_max(value[1], value[2]));
    for (int i = 0; i < 6; i++) inverse[i] = vec_set(0);
    for (int k = 0; k < 3; k++) {
        const vec_mask counts = value[k] > least;
        const vec w = vec_choose(counts, 1 / vec_choose(counts, value[k], vec_set(1)), vec_set(0));
        for (int c = 0; c < 3; c++) {
            inverse[c] += w * v[k][c] * v[k][c];
            inverse[3 + c] += w * v[k][c] * v[k][(c + 1) % 3];
        }
    }
}

/* The principal values, in no order, of `lanes` tensors. */
static void turn_some(int lanes, double (*t)[6], vec value[3]) {
    vec all[6];
    for (int k = 0; k < 6; k++) all[k] = vec_set(0);
    for (int i = 0; i < lanes; i++)
        for (int k = 0; k < 6; k++) all[k][i] = t[i][k];
    turn(all, value, NULL);
}

void solid_tensors_sorted(int n, double (*t)[6], double (*sorted)[3]) {
    for (int h = 0; h < n; h += VEC_LANES) {
        const int lanes = n - h < VEC_LANES ? n - h : VEC_LANES;
        vec value[3];
        turn_some(lanes, t + h, value);
        const vec high = vec_max(value[0], value[1]), low = vec_min(value[0], value[1]);
        const vec principal[3] = {vec_max(high, value[2]), vec_max(low, vec_min(high, value[2])),
                                  vec_min(low, value[2])};
        for (int i = 0; i < lanes; i++)
            for (int k = 0; k < 3; k++) sorted[h + i][k] = principal[k][i];
    }
}

void solid_tensors_largest(int n, double (*t)[6], double *largest) {
    for (int h = 0; h < n; h += VEC_LANES) {
        const int lanes = n - h < VEC_LANES ? n - h : VEC_LANES;
        vec value[3];
        turn_some(lanes, t + h, value);
        const vec most = vec_max(value[0], vec_max(value[1], value[2]));
        for (int i = 0; i < lanes; i++) largest[h + i] = most[i];
    }
}

double solid_tensors_von_mises(const double t[6]) {
    const double xy = t[0] - t[1], yz = t[1] - t[2], zx = t[2] - t[0];
    return sqrt(0.5 * (xy * xy + yz * yz + zx * zx) + 3 * (t[3] * t[3] + t[4] * t[4] + t[5] * t[5]));
}
