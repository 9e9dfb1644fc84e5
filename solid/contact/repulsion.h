/* The repulsion of two particles per unit k_c V_h V_l, its potential, and the potential's slope over a finite motion.
 * (001: eq. 3.40, mended)
 *
 *     c(r) = (r_c/r)^n - 1          phi(r) = int_r^{r_c} c dr          both 0 for r >= r_c
 *
 * Pressed particles often overlap by 1e-6 of r_c only. So all three are functions of the depth q = 1 - r/r_c, by power
 * series where it is small: c = n q + n (n + 1)/2 q^2 + ..., phi/r_c = n/2 q^2 + n (n + 1)/6 q^3 + ... */
#pragma once
#include <math.h>

/* Up to this depth the series are exact to round-off with SOLID_REPULSION_TERMS terms. */
#define SOLID_REPULSION_SHALLOW 0.03
enum { SOLID_REPULSION_TERMS = 10 };

/* c(r), 1; for r < r_c. */
static inline double solid_repulsion(double r, double rc, double exponent) {
    return (exponent == 1 ? rc / r : pow(rc / r, exponent)) - 1;
}

/* q, 1; r2 is r^2. Negative beyond r_c. */
static inline double solid_repulsion_depth(double r2, double rc) { return (rc * rc - r2) / (rc * (rc + sqrt(r2))); }

/* phi, m, at the depth q. */
static inline double solid_repulsion_potential(double q, double rc, double exponent) {
    if (q <= 0) return 0;
    if (q < SOLID_REPULSION_SHALLOW) {
        double term = 0.5 * exponent * q * q, sum = 0;
        for (int k = 2; k < 2 + SOLID_REPULSION_TERMS; k++) {
            sum += term;
            term *= q * (exponent + k - 1) / (k + 1);
        }
        return rc * sum;
    }
    if (exponent == 1) return rc * (-log1p(-q) - q);
    return rc * (expm1((1 - exponent) * log1p(-q)) / (exponent - 1) - q);
}

/* (phi(a) - phi(b))/(a - b)/r_c for shallow depths a, b > 0, term by term: (a^k - b^k)/(a - b) = sum of a^i b^{k-1-i}.
 */
static inline double solid_repulsion_quotient(double a, double b, double exponent) {
    const int terms = a + b < 1e-3 ? 5 : SOLID_REPULSION_TERMS;
    double factor = 0.5 * exponent, power = a, sums = a + b, quotient = 0;
    for (int k = 2; k < 2 + terms; k++) {
        quotient += factor * sums;
        factor *= (exponent + k - 1) / (k + 1);
        power *= a;
        sums = power + b * sums;
    }
    return quotient;
}

/* -(phi(q1) - phi(q0))/(r1^2 - r0^2), 1/m: times the vector zeta_0 + zeta_1 it is the force whose work over the motion
 * from zeta_0 to zeta_1 is the loss of potential, to round-off. For q1 = q0 it is c/(2 r). phi0: phi(q0).
 * (Gonzalez 1996: the discrete gradient) */
static inline double solid_repulsion_slope(double q0, double phi0, double q1, double rc, double exponent) {
    if (q0 <= 0 && q1 <= 0) return 0;
    const double mean = rc * (2 - q0 - q1); /* r0 + r1 */
    if (q0 > 0 && q1 > 0 && fmax(q0, q1) < SOLID_REPULSION_SHALLOW)
        return solid_repulsion_quotient(q0, q1, exponent) / mean;
    if (q0 > 0 && q1 > 0 && fabs(q1 - q0) < 1e-6) { /* deep: c hardly changes over so short a way */
        const double r = 0.5 * mean;
        return solid_repulsion(r, rc, exponent) / (2 * r);
    }
    return (solid_repulsion_potential(q1, rc, exponent) - phi0) / ((q1 - q0) * rc * mean);
}
