/* The stable step: how far an integrator can go with the rates of a solid.
 *
 * A mode u of M x'' + D x' + K x = 0 moves as the oscillator x'' + g x' + w x = 0 with g = u.D u/u.M u, w = omega^2 =
 * u.K u/u.M u. The integrator is stable if it is for every pair (g, w) that some u can have. Those pairs fill a convex
 * set, and four largest eigenvalues give a polygon about it:
 *
 *     w/W 1 |  ______           W = largest of K/M, G = largest of D/M
 *           | /      \          w/W + g/G <= sum           (right edge: both at their largest at once or not)
 *           |/        |         w/W - g/G <= difference    (left edge: no fast mode that is hardly damped)
 *         0 +---------1  g/G
 *
 * Contact adds to w alone, an absolute damping to g alone. */
#pragma once
#include "solid/state.h"

struct solid_rates {
    double stiffness;       /* W of the intact bonds, 1/s2 */
    double damping;         /* G of the pairwise damping, 1/s */
    double sum, difference; /* as above; 1 and 1 without damping */
    double absolute;        /* k_a, 1/s */
};

enum solid_bound { SOLID_BOUND_NONE, SOLID_BOUND_BONDS, SOLID_BOUND_DAMPING, SOLID_BOUND_CONTACT, SOLID_BOUNDS };
extern const char *const solid_stable_bound_name[SOLID_BOUNDS]; /* by enum solid_bound */

/* The largest stable step with `contact` 1/s2 of the contacts' stiffness on top, s; *bound: what makes it as small as
 * it is. */
double solid_stable_of(const struct solid_rates *rates, enum solid_integrator integrator, double contact,
                       enum solid_bound *bound);
/* The largest stable step of one oscillator x'' + g x' + w x = 0, s: up to it no step makes it grow. Of g, pairwise and
 * absolute damping are told apart, because Verlet's see different velocities. */
double solid_stable_oscillator(enum solid_integrator integrator, double w, double pairwise, double absolute);
/* What one contact between particles that nothing else holds can add to the rates, 1/s2: two neighbours at r = r_c, of
 * the material for which it is most; 0 where no contact can come about. */
double solid_stable_touch(const struct solid *s);
