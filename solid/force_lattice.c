#include "base/memory.h"
#include "base/vec.h"
#include "solid/lattice.h"

#include <math.h>

enum { ROW = VEC_LANES };

/* Up to this |eps| the polynomial below stands for the square root, to 5e-16. */
static const double SERIES_LIMIT = 2e-3;
static const double G0 = 0.5, G1 = -0.3749999999988720654, G2 = 0.31249999999895263208,
                    G3 = -0.27343862793361512552, G4 = 0.24609479736699067424;

struct row_input {
    const double *d[3], *v[3], *w; /* dense, at the row's first site: displacement m, velocity m/s, V/V0 */
    const struct solid_lattice_offset *offset; /* [all offsets] */
    const uint8_t *lambda;                     /* [all offsets] a bit a particle of the row */
    const uint16_t *active;                    /* [n] offsets to look at */
    long n;
    double damping; /* k_d */
};

struct row_output {
    vec a[3];              /* m/s2 */
    vec eps_high, eps_low; /* over the row's intact bonds */
    vec power;             /* sum of viscous bond forces times closing speeds, m2/s3 */
};

/* g(eps) = s/(1 + s) = 1 - 1/sqrt(1 + eps), divided by eps; a Chebyshev fit of degree four on |eps| <= SERIES_LIMIT. */
static inline vec g_over_eps_series(vec e) {
    return vec_set(G0) + e * (vec_set(G1) + e * (vec_set(G2) + e * (vec_set(G3) + e * vec_set(G4))));
}

static inline vec g_over_eps_exact(vec e) {
    const vec q = vec_sqrt(1 + e);
    return 1 / ((1 + q) * q);
}

/* Bond forces on a row of eight particles, each bond  (SPEC 2; 001: eqs 3.20, 3.41)
 *     zeta = xi + eta      eps = (2 xi.eta + eta.eta)/|xi|^2 = (1 + s)^2 - 1
 *     a += alpha c0 Gamma V/(rho |xi|) g(eps) zeta,   since s zeta/|zeta| = g(eps) zeta/|xi|
 *     a += k_d Gamma V/(rho |zeta|^2) [(v_l - v_h).zeta] zeta
 * Seen from the other end all signs of xi and eta turn and eps is the same number. */
static inline __attribute__((always_inline)) void row_force(const struct row_input *in,
                                                            struct row_output *out, const int bulk,
                                                            const int exact, const int damped) {
    const vec dx = vec_load(in->d[0]), dy = vec_load(in->d[1]), dz = vec_load(in->d[2]);
    vec w = vec_set(1), vx = vec_set(0), vy = vx, vz = vx;
    if (!bulk) w = vec_load(in->w);
    if (damped) {
        vx = vec_load(in->v[0]);
        vy = vec_load(in->v[1]);
        vz = vec_load(in->v[2]);
    }
    vec ax = vec_set(0), ay = ax, az = ax, high = ax, low = ax, power = ax;
    for (long i = 0; i < in->n; i++) {
        const unsigned o = in->active[i];
        const struct solid_lattice_offset *t = &in->offset[o];
        const unsigned lambda = in->lambda[o];
        const vec ex = vec_load(in->d[0] + t->shift) - dx;
        const vec ey = vec_load(in->d[1] + t->shift) - dy;
        const vec ez = vec_load(in->d[2] + t->shift) - dz;
        const vec zx = t->xi[0] + ex, zy = t->xi[1] + ey, zz = t->xi[2] + ez;
        const vec q = ex * (t->xi[0] + zx) + ey * (t->xi[1] + zy) + ez * (t->xi[2] + zz);
        const vec eps = vec_where(lambda, q * t->inv_length2);
        high = vec_max(high, eps);
        low = vec_min(low, eps);
        const vec g = exact ? g_over_eps_exact(eps) : g_over_eps_series(eps);
        vec f = g * (eps * (bulk ? t->elastic : t->elastic_twice));
        if (!bulk) f /= w + vec_load(in->w + t->shift);
        if (damped) {
            const vec closing = (vec_load(in->v[0] + t->shift) - vx) * zx +
                                (vec_load(in->v[1] + t->shift) - vy) * zy +
                                (vec_load(in->v[2] + t->shift) - vz) * zz;
            const vec fd = vec_where(lambda, closing * (in->damping * t->viscous) / (1 + eps));
            power += fd * closing;
            f += fd;
        }
        ax += f * zx;
        ay += f * zy;
        az += f * zz;
    }
    *out = (struct row_output){{ax, ay, az}, high, low, power};
}

typedef void row_kernel(const struct row_input *, struct row_output *);

#define ROW_KERNEL(bulk, exact, damped)                                                                      \
    static void row_force_##bulk##exact##damped(const struct row_input *in, struct row_output *out) {        \
        row_force(in, out, bulk, exact, damped);                                                             \
    }
ROW_KERNEL(0, 0, 0)
ROW_KERNEL(0, 0, 1)
ROW_KERNEL(0, 1, 0)
ROW_KERNEL(0, 1, 1)
ROW_KERNEL(1, 0, 0)
ROW_KERNEL(1, 0, 1)
ROW_KERNEL(1, 1, 0)
ROW_KERNEL(1, 1, 1)

static row_kernel *const kernel[2][2][2] = {
    {{row_force_000, row_force_001}, {row_force_010, row_force_011}},
    {{row_force_100, row_force_101}, {row_force_110, row_force_111}},
};

/* Displacements (and velocities) of particles, ghosts and periodic images into the box. */
static void fill_box(const struct solid *s, struct solid_lattice *b, int damped) {
    for (int c = 0; c < 3; c++) {
        for (int i = 0; i < b->copies; i++) b->d[c][b->copy_cell[i]] = s->d[c][b->copy_local[i]];
        if (!damped) continue;
        if (!b->v[c]) b->v[c] = memory_new(MEMORY_SOLID, (size_t)b->sites + ROW, sizeof *b->v[c]);
        for (int i = 0; i < b->copies; i++) b->v[c][b->copy_cell[i]] = s->v[c][b->copy_local[i]];
    }
}

/* The number that decides on a bond. One function, one order of operations: both ends get the same to the bit. */
static __attribute__((noinline)) double bond_eps(const double xi[3], const double eta[3],
                                                 double inv_length2) {
    double q = 0;
    for (int c = 0; c < 3; c++) q += eta[c] * (xi[c] + (xi[c] + eta[c]));
    return q * inv_length2;
}

/* Breaks the row's bonds beyond s0, each from this end alone: the other end's row finds the same. Returns how many. */
static int break_row(struct solid *s, struct solid_lattice *b, int r) {
    const double volume = b->stencil->spacing * b->stencil->spacing * b->stencil->spacing;
    uint8_t *lambda = b->lambda + (size_t)r * (size_t)b->stencil->n;
    int broken = 0;
    for (int o = 0; o < b->stencil->n; o++)
        for (int k = 0; k < ROW; k++) {
            if (!(lambda[o] >> k & 1)) continue;
            const struct solid_offset *t = &b->stencil->offset[o];
            const long cell = b->row_cell[r] + k, other = cell + b->offset[o].shift;
            double eta[3];
            for (int c = 0; c < 3; c++) eta[c] = b->d[c][other] - b->d[c][cell];
            const double eps = bond_eps(t->xi, eta, t->inv_length2);
            if (!(eps > b->law.eps_limit)) continue;
            const int h = b->local[cell];
            if ((s->flag[h] | s->flag[b->local[other]]) & SOLID_UNBREAKABLE) continue;
            lambda[o] &= (uint8_t) ~(1u << k);
            s->flag[h] |= SOLID_BROKEN;
            const double stretch = eps / (1 + sqrt(1 + eps)), alpha = 2 / (b->w[cell] + b->w[other]);
            s->e_fracture += 0.25 * b->law.c0 * alpha * stretch * stretch * t->length * t->weight * volume;
            broken++;
        }
    if (broken) s->broke = 1;
    return broken;
}

double solid_lattice_force(struct solid *s, struct solid_lattice *b, const struct solid_sweep *sweep) {
    const int damped = sweep->damping > 0;
    /* the rows' eps may differ from bond_eps in its last digit: look closer a little below the limit */
    const double look = sweep->may_break ? b->law.eps_limit * (1 - 1e-9) : INFINITY;
    const double volume = b->stencil->spacing * b->stencil->spacing * b->stencil->spacing;
    double power = 0;
    fill_box(s, b, damped);
    for (int r = 0; r < b->rows; r++) {
        const int cell = b->row_cell[r], bulk = b->row_bulk[r];
        struct row_input in = {.offset = b->offset,
                               .active = b->active + b->row_active[r],
                               .n = b->row_active[r + 1] - b->row_active[r],
                               .lambda = b->lambda + (size_t)r * (size_t)b->stencil->n,
                               .w = b->w + cell,
                               .damping = sweep->damping};
        for (int c = 0; c < 3; c++) {
            in.d[c] = b->d[c] + cell;
            if (damped) in.v[c] = b->v[c] + cell;
        }
        struct row_output out;
        kernel[bulk][0][damped](&in, &out);
        double high = vec_highest(out.eps_high);
        const double low = vec_lowest(out.eps_low);
        if (high > look && break_row(s, b, r))
            kernel[bulk][0][damped](&in, &out), high = vec_highest(out.eps_high);
        if (high > SERIES_LIMIT || low < -SERIES_LIMIT) kernel[bulk][1][damped](&in, &out);
        if (damped) power += vec_sum(out.power);
        int h = b->row_first[r];
        for (int k = 0; k < ROW; k++) {
            if (!(b->row_owned[r] >> k & 1)) continue;
            for (int c = 0; c < 3; c++) s->a[c][h] = out.a[c][k];
            h++;
        }
    }
    return 0.5 * b->law.density * volume * power;
}
