/* The largest stable step of an integrator for the rates of a solid.
 *
 * A mode u of M x'' + D x' + K x = 0 moves as the oscillator x'' + g x' + w x = 0 with g = u.D u/u.M u, w = omega^2 =
 * u.K u/u.M u. The integrator is stable if it is stable for every pair (g, w) of all vectors u. These pairs form a
 * convex set, and four largest eigenvalues give a polygon around it:
 *
 *     w/W 1 |  ______           W = largest of K/M, G = largest of D/M
 *           | /      \          w/W + g/G <= sum           (right edge: < 2 if no mode has both at their largest)
 *           |/        |         w/W - g/G <= difference    (left edge: < 1 if every fast mode is damped)
 *         0 +---------1  g/G
 *
 * Contact adds to w only, absolute damping to g only. */
#pragma once
#include "solid/state.h"

struct solid_rates {
    double stiffness;       /* W of the intact bonds, 1/s2 */
    double damping;         /* G of the pairwise damping, 1/s */
    double sum, difference; /* as above; 1 and 1 without damping */
    double absolute;        /* k_a, 1/s */
};

enum solid_bound {
    SOLID_BOUND_NONE,
    SOLID_BOUND_BONDS,
    SOLID_BOUND_DAMPING,
    SOLID_BOUND_CONTACT,
    SOLID_BOUND_STRETCH,
    SOLID_BOUNDS
};
extern const char *const solid_stable_bound_name[SOLID_BOUNDS]; /* by enum solid_bound */

/* The largest stable step, s, with the rate `contact` of the contacts' stiffness added, 1/s2; *bound: which rate limits
 * the step. */
double solid_stable_of(const struct solid_rates *rates, enum solid_integrator integrator, double contact,
                       enum solid_bound *bound);
/* The same for contacts that stay closed: 1.41 times as long where contact limits velocity Verlet. */
double solid_stable_linear(const struct solid_rates *rates, enum solid_integrator integrator, double contact);
/* The largest stable step of one oscillator x'' + g x' + w x = 0, s: it does not grow in any step up to this one.
 * Pairwise and absolute damping are separate parts of g, because Verlet uses different velocities for them. */
double solid_stable_oscillator(enum solid_integrator integrator, double w, double pairwise, double absolute);
