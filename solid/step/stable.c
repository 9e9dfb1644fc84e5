/* Stable step of both integrators from the largest rates of stiffness, damping and contact. */
#include "solid/step/stable.h"
#include "base/ensure.h"
#include "solid/step/verlet.h"

#include <complex.h>
#include <math.h>

const char *const solid_stable_bound_name[SOLID_BOUNDS] = {"nothing", "bonds", "damping", "contact", "stretched bonds"};

enum { SAMPLES = 64 };
static const double RK3_REAL = 2.5127453266; /* |R(-z)| = 1 */

/* |R(z)|, R = 1 + z + z^2/2 + z^3/6: a step of RK3 multiplies a mode exp(lambda t) by R(lambda dt). */
static double rk3_gain(double complex z) { return cabs(1 + z * (1 + z * (0.5 + z / 6))); }

/* Along the ray z = dt lambda from 0, |R| first exceeds 1 between sqrt(3), where the stability region ends on the
 * imaginary axis, and 2.54, its largest extent. For two real roots the faster one decides. */
static double rk3_limit(double w, double g) {
    const double half = 0.5 * g, root2 = w - half * half;
    if (!(w > 0) || root2 <= 0) return g > 0 ? RK3_REAL / (half + sqrt(fmax(-root2, 0))) : INFINITY;
    const double complex lambda = (-half + I * sqrt(root2)) / sqrt(w);
    double low = sqrt(3) * (1 - 1e-12), high = 2.6;
    for (int i = 0; i < 60; i++) {
        const double middle = 0.5 * (low + high);
        if (rk3_gain(middle * lambda) <= 1)
            low = middle;
        else
            high = middle;
    }
    return low / sqrt(w);
}

/* Velocity Verlet whose damping uses the velocity v + theta dt a. The first root to leave the unit circle leaves it at
 * -1, where v = 0, d = -dt^2 a/4 and a (1 - theta g dt) = a w dt^2/4. So w dt^2/4 + (theta g) dt <= 1. */
static double verlet_limit(double w, double theta_g) {
    return w > 0 || theta_g > 0 ? 2 / (theta_g + sqrt(theta_g * theta_g + w)) : INFINITY;
}

double solid_stable_oscillator(enum solid_integrator integrator, double w, double pairwise, double absolute) {
    switch (integrator) {
    case SOLID_RK3:
        return rk3_limit(w, pairwise + absolute);
    case SOLID_VERLET:
        return verlet_limit(w, SOLID_VERLET_PAIRWISE * pairwise + absolute);
    }
    ENSURE(0, "integrator %d", (int)integrator);
}

/* The least limit over the oscillators on the polygon's upper boundary; for RK3, of those below it only strongly damped
 * ones matter. */
static double polygon_limit(const struct solid_rates *r, enum solid_integrator integrator, double contact) {
    const double corner[] = {1 - r->difference, r->sum - 1, 1};
    double least = INFINITY;
    for (int k = 0; k <= SAMPLES + 3; k++) {
        const double x = k <= SAMPLES ? (double)k / SAMPLES : fmin(fmax(corner[k - SAMPLES - 1], 0), 1);
        const double y = fmin(fmin(1, r->difference + x), r->sum - x);
        if (y >= 0)
            least = fmin(least,
                         solid_stable_oscillator(integrator, y * r->stiffness + contact, x * r->damping, r->absolute));
    }
    const double fastest = r->damping + r->absolute;
    return integrator == SOLID_RK3 && fastest > 0 ? fmin(least, RK3_REAL / fastest) : least;
}

/* Contact sets in and ends between steps. Velocity Verlet with x = w dt^2 in one step and y in the next, both below 4,
 * multiplies a mode over two steps by a matrix of trace (2 - x)(2 - y) - 2. That is stable for 0 <= (2 - x)(2 - y) <=
 * 4: not for x < 2 < y. So with contact the largest w dt^2 must stay below 2, not 4. */
static const double SWITCHED = 0.70710678118654752440;

double solid_stable_linear(const struct solid_rates *r, enum solid_integrator integrator, double contact) {
    return polygon_limit(r, integrator, contact);
}

static double switched_limit(const struct solid_rates *r, enum solid_integrator integrator, double contact) {
    switch (integrator) {
    case SOLID_RK3: /* its steps lose energy where those of Verlet would gain some */
        return polygon_limit(r, integrator, contact);
    case SOLID_VERLET:
        return SWITCHED * polygon_limit(r, integrator, contact);
    }
    ENSURE(0, "integrator %d", (int)integrator);
}

double solid_stable_of(const struct solid_rates *r, enum solid_integrator integrator, double contact,
                       enum solid_bound *bound) {
    const double bonds = solid_stable_oscillator(integrator, r->stiffness, 0, 0),
                 damped = polygon_limit(r, integrator, 0),
                 all = contact > 0 ? fmin(damped, switched_limit(r, integrator, contact)) : damped;
    if (bound)
        *bound = !isfinite(all)           ? SOLID_BOUND_NONE
                 : all < 0.999 * damped   ? SOLID_BOUND_CONTACT
                 : damped < 0.999 * bonds ? SOLID_BOUND_DAMPING
                                          : SOLID_BOUND_BONDS;
    return all;
}
