/* The pairs that touch in a substep, copied into arrays of their own, and the accelerations that they give. For
 * solid/contact only. */
#pragma once
#include "base/vec.h"

/* As many pairs as a vec has lanes. Lanes without a pair have particles 0 and give 0. */
struct solid_contact_block {
    double xi[3][VEC_LANES], start[3][VEC_LANES]; /* X0_h - X0_l; X_h - X_l at the beginning of the substep, m */
    double depth[VEC_LANES], radius[VEC_LANES];   /* q at the beginning; r_c of the pair, m */
    double on_h[VEC_LANES], on_l[VEC_LANES];      /* k_c V_l/rho_h, k_c V_h/rho_l (0: l is not owned), m/s2 */
    int h[VEC_LANES], l[VEC_LANES];               /* indices in now and push */
};

struct solid_contact_touching {
    int pairs, room;
    struct solid_contact_block *block; /* [ceil(pairs/VEC_LANES)] */
};

/* What all pairs have in common. */
struct solid_contact_law {
    double exponent, quantum, least2; /* n_c; m/s2; square of the least distance, m2 */
};

/* A pair, as in solid_contact_block. */
struct solid_contact_one {
    double xi[3], start[3], depth, radius, on_h, on_l;
    int h, l;
};

void solid_contact_touching_add(struct solid_contact_touching *t, const struct solid_contact_one *pair);
/* Adds to push what the particles get if the substep ends with the displacements `now`; both [particles][4], m/s2 and
 * m. Sums are of multiples of the quantum: the same in any order. Not collective. */
void solid_contact_touching_push(const struct solid_contact_touching *t, const struct solid_contact_law *law,
                                 const double (*now)[4], double (*push)[4]);
