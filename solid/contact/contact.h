/* Short-range repulsion of particles that no intact bond joins.  (001: eq. 3.40, mended; SPEC 2)
 *
 *     C_h = k_c [(r_c/r)^{n_c} - 1] V_l (X_h - X_l)/r    where r = |X_h - X_l| < r_c, the shortest across periodic
 * sides
 *
 * per unit volume; k_c = stiffness * c0 (the mean of the two materials' c0), r_c = radius * spacing. Two sorts of
 * pairs: torn: particles of one family whose bond is broken; strangers: particles that never were of one family, sought
 * among interface and broken particles of all ranks. Lists hold pairs within r_c + a skin of half a spacing, and are
 * made anew when a particle has moved 0.2 spacings; a bond that breaks near contact joins its list at once. */
#pragma once
#include "solid/state.h"

/* Whether contact can come about in the present stage: bonds may break, or some are broken, or there are other bodies.
 * Collective. */
int solid_contact_is_possible(const struct solid *s);
/* Makes the lists, once something could touch, or keeps them: after solid_surface_new, then once a step or more often
 * (nothing may move 0.05 spacings between two calls). Until something could touch s->contact stays NULL. Collective. */
void solid_contact_update(struct solid *s);
/* Adds C_h/rho to s->a. Ghosts must be current. Needs s->contact. Collective. */
void solid_contact_force(struct solid *s);
/* The repulsion's potential, J, 0 without contact; whole solid. Ghosts must be current. Collective. */
double solid_contact_force_energy(struct solid *s);
/* A bound of the largest eigenvalue of the present contacts' stiffness over mass, 1/s2. With kappa = -dC/dr V_l of a
 * pair and e its direction, and any weights x > 0,
 *
 *     u.K u = sum kappa [e.(u_h - u_l)]^2 <= sum u_h.T_h u_h      T_h = sum over l of kappa (1 + x_l/x_h) e e
 *
 * since (p - q)^2 <= p^2 (1 + x_l/x_h) + q^2 (1 + x_h/x_l): the largest eigenvalue of a T_h/rho. The largest
 * eigenvalues of the x_h T_h/rho are better weights: the bound never rises (Collatz, Wielandt). (The part of the
 * stiffness across e is negative.) The best is a continuous function of the state, the same on any number of ranks;
 * where a bound is `enough` for the caller, with what it brings, no better one is sought (NULL: none is). Brings ghosts
 * up to date. Collective. */
typedef int solid_contact_enough(const void *with, double rate2);
double solid_contact_rate_bound(struct solid *s, solid_contact_enough *enough, const void *with);
/* How far from touching pairs count already, m: nothing that the bound has not seen touches before two particles have
 * come nearer by as much. 0: nothing is near. Not collective. */
double solid_contact_rate_margin(const struct solid *s);
void solid_contact_free(struct solid *s);
/* What one contact between particles that nothing else holds can add to the rates, 1/s2: two neighbours at r = r_c, of
 * the material for which it is most; 0 where no contact can come about. */
double solid_contact_rate_touch(const struct solid *s);
