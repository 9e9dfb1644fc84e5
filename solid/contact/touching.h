/* The pairs that touch in a substep, copied into arrays of their own, and the accelerations that they give. For
 * solid/contact only. */
#pragma once
#include "base/vec_type.h"

/* Some pairs, one in each lane. */
struct solid_contact_lanes {
    vec xi[3], start[3]; /* X0_h - X0_l; X_h - X_l at the beginning of the substep, m; third 0 in a plate */
    vec depth, radius;   /* q at the beginning; r_c of the pair, m */
    vec on_h, on_l;      /* k_c V_l/rho_h, k_c V_h/rho_l (0: l is not owned), m/s2 */
};
enum { SOLID_CONTACT_NUMBERS = sizeof(struct solid_contact_lanes) / sizeof(vec) };

struct solid_contact_touching {
    int pairs, capacity;
    double *number[SOLID_CONTACT_NUMBERS]; /* [pairs] those of solid_contact_lanes in their order; a vec of pairs beyond
                                            * the last one give 0 */
    int *h, *l;                            /* [pairs] indices in now and push */
};

/* What all pairs have in common. */
struct solid_contact_law {
    double exponent, quantum, least2; /* n_c; m/s2; square of the least distance, m2 */
};

/* Adds those lanes whose bit is set in `which`; h, l: indices in now and push of these lanes' pairs, in turn. */
void solid_contact_touching_add(struct solid_contact_touching *t, const struct solid_contact_lanes *some,
                                unsigned which, const int *h, const int *l);
/* Puts a vec of pairs that are far apart behind the last one; to be called after the last add. */
void solid_contact_touching_fill_up(struct solid_contact_touching *t);
void solid_contact_touching_free(struct solid_contact_touching *t);
/* Adds to push what the particles get if the substep ends with the displacements `now`; both [particles][4], m/s2 and
 * m. Sums are of multiples of the quantum: the same in any order. Not collective. */
void solid_contact_touching_push(const struct solid_contact_touching *t, const struct solid_contact_law *law,
                                 const double (*now)[4], double (*push)[4]);
