/* Stiffness, breaking limit and partial volume of one bond from its two ends.  (000: sec. 1.2.5) */
#include "solid/law/pair.h"
#include "base/ensure.h"
#include "physics/micromodulus.h"
#include "solid/law/material.h"
#include "solid/law/weight.h"
#include "solid/law/weight_plane.h"

#include <math.h>

enum { COLUMNS = 24 }; /* of the quadrature of partial volumes, if few of them are equal: accurate to 1e-4 */

/* A cell that only touches the horizon is outside, also with rounding errors. */
static const double INSIDE = 1 - 1e-12;

struct solid_bond_law solid_pair_law(const struct solid_input *in, const struct solid_material *m) {
    const double delta = m->horizon_ratio * in->spacing;
    const struct physics_bond k = solid_material_constants(in->model, in->thickness, m, delta);
    const struct physics_softening soft = solid_material_softening(in->model, in->thickness, m, delta);
    return (struct solid_bond_law){.dim = solid_dim(in),
                                   .partial = in->partial,
                                   .horizons = in->horizons,
                                   .micromodulus = physics_micromodulus_of((enum physics_micromodulus)m->micromodulus),
                                   .horizon = m->horizon_ratio,
                                   .c = k.c,
                                   .s0 = soft.s_c > 0 ? soft.s_e : k.s0,
                                   .s_c = soft.s_c,
                                   .density = m->density,
                                   .bonds_energy = solid_material_bonds_energy(in->model, m),
                                   .columns = COLUMNS};
}

static double square(const struct solid_bond_law *law, const double *xi) {
    double sum = xi[0] * xi[0];
    for (int c = 1; c < law->dim; c++) sum += xi[c] * xi[c];
    return sum;
}

/* In space the cells up to half a spacing beyond the horizon, as on the lattice; in a plate every cell that the disc
 * meets. The ramp ends half a spacing beyond, and a law that falls to 0 at the horizon itself. The ramp that is cut
 * ends at the horizon: a cell whose centre is on it is inside. */
int solid_pair_holds(const struct solid_bond_law *law, const double *xi, double delta, double size) {
    const double xi2 = square(law, xi);
    if (law->micromodulus->ends_at_horizon && xi2 >= delta * delta * INSIDE) return 0;
    if (law->partial == SOLID_PARTIAL_RAMP_CUT) return xi2 <= delta * delta * (2 - INSIDE);
    if (law->dim == 2 && law->partial == SOLID_PARTIAL_EXACT) {
        const double x = fmax(fabs(xi[0]) - 0.5 * size, 0), y = fmax(fabs(xi[1]) - 0.5 * size, 0);
        return x * x + y * y < delta * delta * INSIDE;
    }
    const double limit = delta + 0.5 * size;
    return xi2 < limit * limit * INSIDE;
}

int solid_pair_exists(const struct solid_bond_law *law, const double *xi, const struct solid_end *h,
                      const struct solid_end *l) {
    return solid_pair_holds(law, xi, h->horizon, l->size) ||
           (law->horizons == SOLID_DUAL_HORIZON && solid_pair_holds(law, xi, l->horizon, h->size));
}

double solid_pair_gamma(const struct solid_bond_law *law, const double *xi, double delta, double size) {
    switch (law->partial) {
    case SOLID_PARTIAL_RAMP:
    case SOLID_PARTIAL_RAMP_CUT: {
        const double part = (delta + 0.5 * size - sqrt(square(law, xi))) / size;
        return part < 1 ? fmax(part, 0) : 1;
    }
    case SOLID_PARTIAL_EXACT:
        if (law->dim == 2) return solid_weight_plane_fraction(xi, size, delta);
        return law->table ? solid_weight_fraction_cached(law->table, xi, size, delta, law->columns)
                          : solid_weight_fraction(xi, size, delta, law->columns);
    }
    ENSURE(0, "partial volume %d", (int)law->partial);
}

/* c_h(xi); c0 and c1 are proportional to delta^-(dim + 1).  (000: eqs 9, 10) */
static double micromodulus(const struct solid_bond_law *law, double xi2, double delta) {
    double c = law->c;
    if (delta != law->horizon)
        for (int k = 0; k <= law->dim; k++) c *= law->horizon / delta;
    return c * law->micromodulus->profile(sqrt(xi2) / delta);
}

/* s0_h^2, proportional to 1/delta. */
static double stretch2(const struct solid_bond_law *law, double delta) {
    return law->s0 * law->s0 * (law->horizon / delta);
}

struct half {
    double stiffness, stretch2, gamma;
};

/* The half of a bond that comes from the end with this horizon. Not inlined: the compiler could fuse its products into
 * sums, and the two ends would differ in the last digit. */
static __attribute__((noinline)) struct half half_of(const struct solid_bond_law *law, const double *xi, double delta,
                                                     double size) {
    struct half half = {0, stretch2(law, delta), 0};
    if (solid_pair_holds(law, xi, delta, size)) {
        half.gamma = solid_pair_gamma(law, xi, delta, size);
        half.stiffness = micromodulus(law, square(law, xi), delta) * half.gamma;
    }
    return half;
}

static double eps_of(double s0) { return s0 * (2 + s0); }

/* eps at which the energy of the bond is the sum of what both halves can store. */
static double limit_of(struct half a, struct half b) {
    if (isinf(a.stretch2)) return INFINITY;
    if (a.stretch2 == b.stretch2) return eps_of(sqrt(a.stretch2));
    if (a.stiffness < b.stiffness || (a.stiffness == b.stiffness && a.stretch2 < b.stretch2)) {
        const struct half t = a;
        a = b;
        b = t;
    }
    const double energy = a.stiffness * a.stretch2 + b.stiffness * b.stretch2;
    return eps_of(sqrt(energy / (a.stiffness + b.stiffness)));
}

struct solid_pair solid_pair_across(const struct solid_bond_law *law, const struct solid_bond_law *other,
                                    const double *xi, const struct solid_end *h, const struct solid_end *l) {
    const struct half here = half_of(law, xi, h->horizon, l->size);
    switch (law->horizons) {
    case SOLID_ONE_SIDED:
        return (struct solid_pair){here.stiffness, eps_of(sqrt(here.stretch2)), here.gamma};
    case SOLID_DUAL_HORIZON: {
        const struct half there = half_of(other, xi, l->horizon, h->size);
        return (struct solid_pair){0.5 * (here.stiffness + there.stiffness), limit_of(here, there), here.gamma};
    }
    }
    ENSURE(0, "horizons %d", (int)law->horizons);
}

struct solid_pair solid_pair_of(const struct solid_bond_law *law, const double *xi, const struct solid_end *h,
                                const struct solid_end *l) {
    return solid_pair_across(law, law, xi, h, l);
}

int solid_pair_across_exists(const struct solid_bond_law *law, const struct solid_bond_law *other, const double *xi,
                             const struct solid_end *h, const struct solid_end *l) {
    return solid_pair_holds(law, xi, h->horizon, l->size) || solid_pair_holds(other, xi, l->horizon, h->size);
}

double solid_pair_across_micromodulus(const struct solid_bond_law *law, const struct solid_bond_law *other,
                                      const double *xi, const struct solid_end *h, const struct solid_end *l) {
    const double xi2 = square(law, xi);
    const int here = solid_pair_holds(law, xi, h->horizon, l->size),
              there = solid_pair_holds(other, xi, l->horizon, h->size);
    const double a = here ? micromodulus(law, xi2, h->horizon) : 0,
                 b = there ? micromodulus(other, xi2, l->horizon) : 0;
    return here && there ? 0.5 * (a + b) : a + b;
}

double solid_pair_limit(const struct solid_bond_law *law, const double *xi, const struct solid_end *h,
                        const struct solid_end *l) {
    const int own = law->horizons == SOLID_ONE_SIDED || h->horizon == l->horizon;
    return own ? eps_of(sqrt(stretch2(law, h->horizon))) : solid_pair_of(law, xi, h, l).eps_limit;
}

double solid_pair_micromodulus(const struct solid_bond_law *law, const double *xi, const struct solid_end *h,
                               const struct solid_end *l) {
    const double xi2 = square(law, xi);
    const int here = solid_pair_holds(law, xi, h->horizon, l->size);
    if (h->horizon == l->horizon && h->size == l->size) return here ? micromodulus(law, xi2, h->horizon) : 0;
    const int there = law->horizons == SOLID_DUAL_HORIZON && solid_pair_holds(law, xi, l->horizon, h->size);
    const double a = here ? micromodulus(law, xi2, h->horizon) : 0, b = there ? micromodulus(law, xi2, l->horizon) : 0;
    return here && there ? 0.5 * (a + b) : a + b;
}

double solid_pair_rounded(const struct solid_bond_law *law, double delta, double volume) {
    double unit = delta * delta;
    if (law->dim == 3) unit *= delta;
    const double digit = ldexp(1, ilogb(unit) - 47);
    return digit * rint(volume / digit);
}

/* Sums over one octant (quadrant) of the family, each cell multiplied by the number of its mirror images. */
double solid_pair_full_volume(const struct solid_bond_law *law, double delta, double size) {
    const double side = ldexp(1, (int)rint(log2(size))), cell = law->dim == 3 ? side * side * side : side * side;
    const int reach = (int)(delta / side + 1);
    double sum = 0;
    for (int k = 0; k <= (law->dim == 3 ? reach : 0); k++)
        for (int j = 0; j <= reach; j++)
            for (int i = 0; i <= reach; i++) {
                const double xi[3] = {i * side, j * side, k * side};
                if (i + j + k == 0 || !solid_pair_holds(law, xi, delta, side)) continue;
                const int times = (i ? 2 : 1) * (j ? 2 : 1) * (k ? 2 : 1);
                sum += times * solid_pair_rounded(law, delta, solid_pair_gamma(law, xi, delta, side) * cell);
            }
    return sum;
}
