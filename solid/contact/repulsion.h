/* The repulsion of two particles per unit k_c V_h V_l, its potential, and the potential's slope over a finite motion.
 * (001: eq. 3.40, mended)
 *
 *     c(r) = (r_c/r)^n - 1          phi(r) = int_r^{r_c} c dr          both 0 for r >= r_c
 */
#pragma once
#include <math.h>

/* c(r), 1; for r < r_c. */
static inline double solid_repulsion(double r, double rc, double exponent) {
    return (exponent == 1 ? rc / r : pow(rc / r, exponent)) - 1;
}

/* phi(r), m; r2 is r^2. With q = 1 - r/r_c, phi/r_c = n/2 q^2 + n (n + 1)/6 q^3 + ...: no digits are lost near r_c. */
static inline double solid_repulsion_potential(double r2, double rc, double exponent) {
    enum { TERMS = 10 };
    if (r2 >= rc * rc) return 0;
    const double q = (rc * rc - r2) / (rc * (rc + sqrt(r2)));
    if (q < 0.03) {
        double term = 0.5 * exponent * q * q, sum = 0;
        for (int k = 2; k < 2 + TERMS; k++) {
            sum += term;
            term *= q * (exponent + k - 1) / (k + 1);
        }
        return rc * sum;
    }
    if (exponent == 1) return rc * (-log1p(-q) - q);
    return rc * (expm1((1 - exponent) * log1p(-q)) / (exponent - 1) - q);
}

/* -(phi(r1) - phi(r0))/(r1^2 - r0^2), 1/m: times the vector zeta_0 + zeta_1 it is the force whose work over the motion
 * from zeta_0 to zeta_1 is the loss of potential, to round-off. For r1 = r0 it is c/(2 r). r02, r12: squares; phi0:
 * phi(r0).  (Gonzalez 1996: the discrete gradient) */
static inline double solid_repulsion_slope(double r02, double phi0, double r12, double rc, double exponent) {
    const double rc2 = rc * rc, change = r12 - r02;
    if (r02 >= rc2 && r12 >= rc2) return 0;
    if (fabs(change) < 1e-6 * r02) {
        const double r = sqrt(0.5 * (r02 + r12));
        return r < rc ? solid_repulsion(r, rc, exponent) / (2 * r) : 0;
    }
    if (exponent == 1 && r02 < 0.9 * rc2 && r12 < 0.9 * rc2)
        return 0.5 * rc * log1p(change / r02) / change - 1 / (sqrt(r02) + sqrt(r12));
    return (phi0 - solid_repulsion_potential(r12, rc, exponent)) / change;
}
