/* Bond forces on one particle of the list store: the kernel, in a plate or in 3D. For solid/ only. */
#pragma once
#include "base/vec_shuffle.h"
#include "solid/bonds/family.h"
#include "solid/bonds/list_lanes.h"

struct solid_sweep_family {
    vec sum[3];    /* of bond forces over the density, separately for each lane, m/s2 */
    vec power;     /* of viscous forces times closing speeds, m2/s3 */
    vec high, far; /* the largest eps and |eps| */
    vec largest;   /* largest component of a bond force; not of forces of bonds alone without damping */
};

#define REAL vec
#define OF(op) vec_##op
#define NAME(name) solid_sweep_family_##name
#include "solid/force/series_of.h"
#undef REAL
#undef OF
#undef NAME

/* In a plate sums are the same to the bit in any order, so that mirror images get mirror-image forces. Forces are
 * rounded to multiples of a digit that leaves room for the sum of all of them within 53 bits, by adding and subtracting
 * 1.5 2^52 times the digit. The digit follows from the power of two at or below the largest |eps| (with damping, the
 * largest component of a force). This power is mostly that of the sweep before, so that is tried first. */

/* A bond in each lane: of one particle, or at one offset from consecutive particles. */
struct solid_sweep_bonds {
    vec xi[3], eta[3], dv[3]; /* xi, eta in spacings; v_l - v_h, m/s */
    vec inverse;              /* 1/|xi|^2 */
    vec k, scale;             /* see below; k_d (k/c)/(alpha |xi|) */
    vec plain, pressure;      /* k without alpha; P_h + P_l (solid/force/dilatation.h) */
};

/* Adds the forces of the bonds to the sums; those whose bit of lambda is 0 are broken. */
static inline __attribute__((always_inline)) void
solid_sweep_family_add(struct solid_sweep_family *sums, const struct solid_sweep_bonds *b, unsigned lambda, vec shift,
                       const int dim, const int exact, const int damped, const int pressed) {
    vec zeta[3], q, closing;
    for (int c = 0; c < dim; c++) {
        zeta[c] = b->xi[c] + b->eta[c];
        q = c == 0 ? b->eta[c] * (b->xi[c] + zeta[c]) : q + b->eta[c] * (b->xi[c] + zeta[c]);
    }
    const vec eps = vec_where(lambda, q * b->inverse);
    sums->high = vec_max(sums->high, eps);
    sums->far = vec_absmax(sums->far, eps);
    vec f;
    if (pressed) {
        const vec g = solid_sweep_family_g_times(eps, vec_set(1), exact ? SERIES_ROOTS : SERIES_SHORT);
        f = b->k * g + vec_where(lambda, b->plain * b->pressure) * (1 - g);
    } else {
        f = solid_sweep_family_g_times(eps, b->k, exact ? SERIES_ROOTS : SERIES_SHORT);
    }
    if (damped) {
        for (int c = 0; c < dim; c++) closing = c == 0 ? b->dv[c] * zeta[c] : closing + b->dv[c] * zeta[c];
        const vec fd = vec_where(lambda, closing * b->scale) *
                       solid_sweep_family_inverse(eps, exact ? SERIES_ROOTS : SERIES_SHORT);
        sums->power += fd * closing;
        f += fd;
    }
    for (int c = 0; c < dim; c++) {
        if (dim == 2) {
            if (damped || pressed) sums->largest = vec_absmax(sums->largest, f * zeta[c]);
            sums->sum[c] += (f * zeta[c] + shift) - shift;
        } else {
            sums->sum[c] += f * zeta[c];
        }
    }
}

/* P of the other ends of the bonds from j on. */
static inline vec solid_sweep_family_pressure(const struct solid_list *list, long j, const int dim) {
    double lane[VEC_LANES];
    for (int k = 0; k < VEC_LANES; k++) lane[k] = list->pressure[list->at[j + k] >> (dim == 2 ? 1 : 2)];
    return vec_load(lane);
}

/* The bond forces of the i-th particle, a vec of bonds at a time  (001: eqs 3.20, 3.41 mended),
 *     zeta = xi + eta      eps = (2 xi.eta + eta.eta)/|xi|^2      k = alpha K V/(rho |xi|)
 *     f  = k g(eps) zeta
 *     f  = [k g + (k/alpha)(P_h + P_l)(1 - g)] zeta      if pressed (solid/force/dilatation.h)
 *     f += (k_d/c) k/(alpha |xi|) [(v_l - v_h).zeta]/(1 + eps) zeta     1/alpha = (w_h + w_l)/2
 * Lengths in spacings. viscous: k_d/(2 c), s/m. */
static inline __attribute__((always_inline)) struct solid_sweep_family
solid_sweep_family_of(const struct solid_list *list, int i, double viscous, const int dim, const int exact,
                      const int damped, const int pressed) {
    const double *here = list->record + (long)list->width * i,
                 *speed = damped ? list->speed + (long)SOLID_LIST_SPEED * i : NULL;
    const vec zero = vec_set(0),
              shift = vec_set(list->power[i] * (damped || pressed ? solid_list_headroom(list, i) : list->digit[i]));
    struct solid_sweep_family sums = {{zero, zero, zero}, zero, zero, zero, zero};
    vec d[3], v[3], w = zero;
    for (int c = 0; c < dim; c++) {
        d[c] = vec_set(here[c]);
        if (damped) v[c] = vec_set(speed[c]);
    }
    if (damped) w = vec_set(speed[SOLID_LIST_SPEED - 1]);
    const long end = list->end[i];
    for (long j = list->start[i]; j < end; j += VEC_LANES) {
        const float *step = solid_list_lanes_step(list, j, dim);
        struct solid_sweep_bonds b;
        vec there[4], speeds[4], xi2 = zero;
        if (dim == 2)
            vec_shuffle_gather2(list->record, list->at + j, there);
        else
            vec_shuffle_gather4(list->record, 1, list->at + j, there);
        for (int c = 0; c < dim; c++) {
            b.xi[c] = vec_load_floats(step + SOLID_LIST_BLOCK * c);
            b.eta[c] = there[c] - d[c];
            xi2 = c == 0 ? b.xi[c] * b.xi[c] : xi2 + b.xi[c] * b.xi[c];
        }
        b.k = vec_load(list->stiffness + j);
        b.inverse = vec_reciprocal(xi2);
        if (pressed) b.plain = vec_load(list->plain + j);
        if (pressed) b.pressure = list->pressure[i] + solid_sweep_family_pressure(list, j, dim);
        if (damped) {
            vec_shuffle_gather4(list->speed, SOLID_LIST_SPEED / (dim == 2 ? 2 : 4), list->at + j, speeds);
            for (int c = 0; c < dim; c++) b.dv[c] = speeds[c] - v[c];
            b.scale = b.k * vec_sqrt(b.inverse) * ((w + speeds[3]) * viscous);
        }
        solid_sweep_family_add(&sums, &b, ~vec_signs(b.k), shift, dim, exact, damped, pressed);
    }
    return sums;
}

/* Sums over the family of the i-th particle, in place of forces, rounded in a plate by the same rule: k |xi|^2 s and k
 * |xi|^2 without alpha, with s = eps (1 - g) - g; lengths in spacings. */
static inline __attribute__((always_inline)) struct solid_sweep_family
solid_sweep_family_extension(const struct solid_list *list, int i, const int dim, const int exact) {
    const double *here = list->record + (long)list->width * i;
    const vec zero = vec_set(0), shift = vec_set(list->extension_power[i] * list->extension_digit[i]),
              steady = vec_set(0.5 * list->extension_digit[i]);
    struct solid_sweep_family sums = {{zero, zero, zero}, zero, zero, zero, zero};
    for (long j = list->start[i]; j < list->end[i]; j += VEC_LANES) {
        const float *step = solid_list_lanes_step(list, j, dim);
        const vec k = vec_load(list->stiffness + j);
        const unsigned lambda = ~vec_signs(k);
        vec there[4], xi2 = zero, q = zero;
        if (dim == 2)
            vec_shuffle_gather2(list->record, list->at + j, there);
        else
            vec_shuffle_gather4(list->record, 1, list->at + j, there);
        for (int c = 0; c < dim; c++) {
            const vec xi = vec_load_floats(step + SOLID_LIST_BLOCK * c), eta = there[c] - here[c];
            xi2 = c == 0 ? xi * xi : xi2 + xi * xi;
            q = c == 0 ? eta * (xi + (xi + eta)) : q + eta * (xi + (xi + eta));
        }
        const vec eps = vec_where(lambda, q * vec_reciprocal(xi2)),
                  weight = vec_where(lambda, vec_load(list->plain + j) * xi2),
                  g = solid_sweep_family_g_times(eps, vec_set(1), exact ? SERIES_ROOTS : SERIES_SHORT),
                  extension = weight * (eps * (1 - g) - g);
        sums.high = vec_max(sums.high, eps);
        sums.far = vec_absmax(sums.far, eps);
        sums.sum[0] += dim == 2 ? (extension + shift) - shift : extension;
        sums.sum[1] += dim == 2 ? (weight + steady) - steady : weight;
    }
    return sums;
}
