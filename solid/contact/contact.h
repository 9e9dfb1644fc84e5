/* Short-range repulsion of particles that no intact bond joins.  (001: eq. 3.40, mended)
 *
 *     C_h = k_c [(r_c/r)^{n_c} - 1] V_l (X_h - X_l)/r    where r = |X_h - X_l| < r_c, to the nearest periodic image
 *
 * per unit volume; k_c = stiffness * c0 (the mean of the two materials' c0), r_c = radius * spacing, but for two
 * particles of one body at most their initial distance. There are two kinds of pairs. Broken-bond pairs: two particles
 * of one family whose bond is broken. Non-bonded pairs: two particles that never shared a bond, searched for among
 * interface particles and particles with broken bonds, on all ranks. The Verlet lists hold pairs nearer than r_c plus a
 * skin of 0.35 spacings. They are rebuilt when a particle has moved 0.125 spacings. If a bond breaks and its ends are
 * near contact, the pair is listed at once.
 */
#pragma once
#include "solid/state.h"

/* Whether contact is possible in the present stage: bonds may break, or some are broken, or there are several bodies.
 * Collective. */
int solid_contact_is_possible(const struct solid *s);
/* Makes the lists once particles could touch, or updates them. To be called after solid_surface_new, then at least once
 * a step (no particle may move 0.05 spacings between two calls). s->contact is NULL until particles could touch.
 * Collective. */
void solid_contact_update(struct solid *s);
/* Between substeps: updates the lists if a bond has broken on any rank since the last update. A pair that is listed
 * late may already overlap; it then has potential energy that no work has supplied. Collective. */
void solid_contact_update_broken(struct solid *s);
/* Whether a particle may move by more than 0.05 spacings in a time, s. If so, the lists must be updated in each
 * substep. Collective. */
int solid_contact_is_fast(const struct solid *s, double time);
/* Adds C_h/rho to s->a. Ghosts must be current. Needs s->contact. Collective. */
void solid_contact_force(struct solid *s);
/* The repulsion's potential, J, 0 without contact; whole solid. Ghosts must be current. Collective. */
double solid_contact_force_energy(struct solid *s);
/* Adds to force[bodies] the contact force on each body from the others, N, this rank's share. Ghosts must be current.
 * Collective. */
void solid_contact_force_on_bodies(struct solid *s, double (*force)[3]);
/* A bound of the largest eigenvalue of the present contacts' stiffness over mass, 1/s2. With kappa = -dC/dr V_l of a
 * pair and e its direction, and any weights x > 0,
 *
 *     u.K u = sum kappa [e.(u_h - u_l)]^2 <= sum u_h.T_h u_h      T_h = sum over l of kappa (1 + x_l/x_h) e e
 *
 * since (p - q)^2 <= p^2 (1 + x_l/x_h) + q^2 (1 + x_h/x_l). The bound is the largest eigenvalue of a T_h/rho. The
 * largest eigenvalues of the x_h T_h/rho are better weights: with them the bound never rises (Collatz, Wielandt). (The
 * part of the stiffness across e is negative.) The best bound is a continuous function of the state, the same on any
 * number of ranks. The iteration stops once `enough` is true for a bound; NULL: returns the best bound. Updates the
 * ghosts. Collective. */
typedef int solid_contact_enough(const void *with, double rate2);
double solid_contact_rate_bound(struct solid *s, solid_contact_enough *enough, const void *with);
/* The margin, m: pairs count before they touch. No pair outside the bound can touch before two particles have
 * approached by more than the margin. 0: no pairs are near. Not collective. */
double solid_contact_rate_margin(const struct solid *s);
void solid_contact_free(struct solid *s);
/* The largest rate that one contact between otherwise free particles can add, 1/s2: of two neighbours at r = r_c, for
 * the material with the largest one; 0 if contact is not possible. */
double solid_contact_rate_touch(const struct solid *s);
