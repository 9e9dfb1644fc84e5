#include "base/vec.h"
#include "solid/force_series.h"
#include "solid/list.h"

#include <math.h>
#include <string.h>

/* Looked at closer a little below the limit: the kernels' eps may differ from bond_eps in its last digit. */
static const double NEAR_LIMIT = 1 - 1e-9;

struct sum {
    double f[3];      /* of a family's bond forces over the density, m/s2 */
    double power;     /* of its viscous bond forces times closing speeds, m2/s3 */
    double high, low; /* of eps */
};

/* Twice the elastic and once the viscous number of all bonds: 2 c0/rho, k_d/rho. */
struct strength {
    double elastic_twice, viscous;
};

static void fill(const struct solid *s, const struct solid_list *b, int damped) {
    const int records = b->n + b->others;
    for (int r = 0; r < records; r++) {
        const int l = solid_list_local(b, r);
        for (int c = 0; c < 3; c++) b->place[(long)SOLID_LIST_PLACE * r + 4 + c] = s->d[c][l];
    }
    for (int r = 0; damped && r < records; r++) {
        const int l = solid_list_local(b, r);
        for (int c = 0; c < 3; c++) b->speed[(long)SOLID_LIST_SPEED * r + c] = s->v[c][l];
    }
}

/* g(eps) = s/(1 + s) = 1 - 1/sqrt(1 + eps), times c. */
static inline vec g_times(vec e, vec c, const int exact) {
    if (!exact) return e * c * ((G0 + e * G1) + e * e * ((G2 + e * G3) + e * e * G4));
    const vec root = vec_sqrt(1 + e);
    return e * c / ((1 + root) * root);
}

/* 1/(1 + eps) */
static inline vec inverse(vec e, const int exact) {
    if (exact) return 1 / (1 + e);
    const vec two = (1 - e) + (1 - e) * (e * e);
    return two + two * (e * e * (e * e));
}

/* Eight bytes of 0 or 1 to eight bits, the first the lowest (of a little-endian word). */
static inline unsigned bits_of(const uint8_t *intact) {
    uint64_t b;
    memcpy(&b, intact, sizeof b);
    return (unsigned)(b * 0x0102040810204080u >> 56);
}

/* What the bonds j .. end-1 of one particle do to it, eight at a time  (SPEC 2; 001: eqs 3.20, 3.41),
 *     zeta = xi + eta      eps = (2 xi.eta + eta.eta)/|xi|^2      alpha = 2/(w_h + w_l)
 *     a_h += alpha c0 Gamma V/(rho |xi|) g(eps) zeta
 *     a_h += k_d Gamma V/(rho |xi|^2) [(v_l - v_h).zeta]/(1 + eps) zeta
 * place, speed  records of all particles    i  the particle's */
static inline __attribute__((always_inline)) struct sum
family(const struct solid_list *b, int i, const struct strength *of, const int exact, const int damped) {
    const double *here = b->place + (long)SOLID_LIST_PLACE * i,
                 *speed = b->speed + (long)SOLID_LIST_SPEED * i;
    const vec zero = vec_set(0), x = vec_set(here[0]), y = vec_set(here[1]), z = vec_set(here[2]),
              w = vec_set(here[3]), dx = vec_set(here[4]), dy = vec_set(here[5]), dz = vec_set(here[6]);
    vec ax = zero, ay = zero, az = zero, power = zero, high = zero, low = zero;
    const long end = b->start[i + 1];
    for (long j = b->start[i]; j < end; j += VEC_LANES) {
        const unsigned rest = end - j < VEC_LANES ? (1u << (end - j)) - 1 : 0xffu;
        const unsigned lambda = bits_of(b->intact + j) & rest;
        vec at[4], by[4], v[4];
        vec_gather4(b->place, SOLID_LIST_PLACE, b->record + j, at);
        vec_gather4(b->place + 4, SOLID_LIST_PLACE, b->record + j, by);
        const vec inv_length = vec_load(b->inv_length + j), gv = vec_load(b->weight + j) * inv_length;
        const vec ex = by[0] - dx, ey = by[1] - dy, ez = by[2] - dz;
        const vec xx = at[0] - x, xy = at[1] - y, xz = at[2] - z;
        const vec zx = xx + ex, zy = xy + ey, zz = xz + ez;
        const vec q = ex * (xx + zx) + ey * (xy + zy) + ez * (xz + zz);
        const vec eps = vec_where(lambda, q * (inv_length * inv_length));
        high = vec_max(high, eps);
        low = vec_min(low, eps);
        vec f = g_times(eps, gv * of->elastic_twice * vec_reciprocal(w + at[3]), exact);
        if (damped) {
            vec_gather4(b->speed, SOLID_LIST_SPEED, b->record + j, v);
            const vec closing = (v[0] - speed[0]) * zx + (v[1] - speed[1]) * zy + (v[2] - speed[2]) * zz;
            const vec fd = vec_where(lambda, closing * gv * (of->viscous * inv_length)) * inverse(eps, exact);
            power += fd * closing;
            f += fd;
        }
        ax += f * zx;
        ay += f * zy;
        az += f * zz;
    }
    return (struct sum){{vec_sum(ax), vec_sum(ay), vec_sum(az)},
                        damped ? vec_sum(power) : 0,
                        vec_highest(high),
                        vec_lowest(low)};
}

static struct sum family_elastic(const struct solid_list *b, int i, const struct strength *of, int exact) {
    return exact ? family(b, i, of, 1, 0) : family(b, i, of, 0, 0);
}

static struct sum family_damped(const struct solid_list *b, int i, const struct strength *of, int exact) {
    return exact ? family(b, i, of, 1, 1) : family(b, i, of, 0, 1);
}

/* The number that decides on a bond; both ends get the same to the bit: all signs turn, nothing else. */
static __attribute__((noinline)) double bond_eps(const double xi[3], const double eta[3], double inv_length) {
    double q = 0;
    for (int c = 0; c < 3; c++) q += eta[c] * (xi[c] + (xi[c] + eta[c]));
    return q * (inv_length * inv_length);
}

/* Breaks the bonds of the particle that are beyond s0, on its side. Returns how many. */
static int break_bonds(struct solid *s, struct solid_list *b, int i) {
    const int h = b->first + i;
    int broken = 0;
    for (long j = b->start[i]; j < b->start[i + 1]; j++) {
        const int l = solid_list_local(b, b->record[j]);
        if (!b->intact[j] || ((s->flag[h] | s->flag[l]) & SOLID_UNBREAKABLE)) continue;
        double xi[3], eta[3];
        solid_list_xi(b, h, j, xi);
        for (int c = 0; c < 3; c++) eta[c] = s->d[c][l] - s->d[c][h];
        const double eps = bond_eps(xi, eta, b->inv_length[j]);
        if (!(eps > b->law.eps_limit)) continue;
        const double stretch = eps / (1 + sqrt(1 + eps));
        b->intact[j] = 0;
        s->e_fracture += 0.25 * b->law.c0 * solid_list_alpha(b, h, j) * stretch * stretch / b->inv_length[j] *
                         b->weight[j] * s->volume[h];
        broken++;
    }
    if (broken) {
        s->flag[h] |= SOLID_BROKEN;
        s->broke = 1;
    }
    return broken;
}

/* A family in which bonds break or the series does not hold is computed again; one with large eps starts with square roots. */
double solid_list_force(struct solid *s, struct solid_list *b, const struct solid_sweep *sweep) {
    const double look = sweep->may_break ? b->law.eps_limit * NEAR_LIMIT : INFINITY;
    const struct strength of = {2 * b->law.c0 / b->law.density, sweep->damping / b->law.density};
    const int damped = sweep->damping > 0;
    struct sum (*const kernel)(const struct solid_list *, int, const struct strength *, int) =
        damped ? family_damped : family_elastic;
    double power = 0;
    fill(s, b, damped);
    for (int i = 0; i < b->n; i++) {
        const int h = b->first + i, exact = b->large[i];
        struct sum sum = kernel(b, i, &of, exact);
        const int too_large = fmax(sum.high, -sum.low) > (exact ? 0.5 : 1) * SOLID_SERIES_LIMIT;
        const int broken = sum.high > look && break_bonds(s, b, i);
        if (broken || (too_large && !exact)) sum = kernel(b, i, &of, exact || too_large);
        b->large[i] = (uint8_t)too_large;
        for (int c = 0; c < 3; c++) s->a[c][h] = sum.f[c];
        power += sum.power * s->volume[h];
    }
    return 0.5 * b->law.density * power;
}
