/* The micromodulus functions c(xi) = c1 profile(|xi|/delta): one file a law, one line in the table.  (000: eqs 9, 10)
 *
 * The constants follow from two integrals over the family of a bulk particle, dim = 3 in space and 2 in a plate:
 *     elastic energy     e = 1/4 s^2 int c |xi| dV          ~ c1 int_0^1 profile(q) q^dim dq
 *     fracture energy    G0 = s0^2/2 int int c |xi| ...     ~ c1 s0^2 int_0^1 profile(q) q^(dim + 1) dq
 * so that c1 and s0^2 are those of the constant law times the factors
 *     stiffness = 1/((dim + 1) I_dim)      stretch2 = (dim + 1) I_dim/((dim + 2) I_(dim+1)),      I_k = int profile q^k
 */
#pragma once
#include "physics/model.h"

enum physics_micromodulus { PHYSICS_CONSTANT, PHYSICS_CONICAL, PHYSICS_EXPONENTIAL, PHYSICS_MICROMODULI };

struct physics_micromodulus_law {
    const char *name;            /* as a scene has it */
    double (*profile)(double q); /* c(xi)/c1 at q = |xi|/delta; 1 at q = 0 */
    int is_constant;             /* 1: all bonds of a family have the same c; lattice stores hold this one number */
    int ends_at_horizon;         /* 1: the profile is 0 from q = 1 on, and the family ends there */
    double stiffness[PHYSICS_MODELS]; /* c1 over the constant law's c0, by enum physics_model */
    double stretch2[PHYSICS_MODELS];  /* s0^2 over the constant law's */
};

extern const struct physics_micromodulus_law physics_micromodulus_constant, physics_micromodulus_conical,
    physics_micromodulus_exponential;

/* The law of a kind. Not collective. */
const struct physics_micromodulus_law *physics_micromodulus_of(enum physics_micromodulus kind);
