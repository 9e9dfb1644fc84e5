/* Terzaghi's and Mandel's pressure of consolidation, by their series: the fluid in a porous elastic solid that is
 * loaded at once and then drains. */
#pragma once
#include "physics/consolidation.h"
#include "tests/check.h"

#include <math.h>

static const double SHORT = 0.05;      /* below this T the images of the surface are summed instead of the series */
static const double NEGLIGIBLE = 40.0; /* exp(-40) = 4e-18 */

/* K */
static inline double drained_bulk(const struct physics_consolidation *in) {
    return in->youngs_modulus / (3 * (1 - 2 * in->poisson_ratio));
}

/* Skempton's B: the pressure over the mean compression while no fluid moves, alpha M/K_u. */
static inline double consolidation_skempton(const struct physics_consolidation *in) {
    return in->biot / (drained_bulk(in) / in->modulus + in->biot * in->biot);
}

/* Poisson's ratio while no fluid moves: (3 K_u - 2 G)/(2 (3 K_u + G)), K_u = K + alpha^2 M; 1/2 if M is INFINITY. */
static inline double consolidation_undrained(const struct physics_consolidation *in) {
    const double nu = in->poisson_ratio, stiffer = in->biot * consolidation_skempton(in) * (1 - 2 * nu);
    return (3 * nu + stiffer) / (3 - stiffer); /* K_u = K/(1 - alpha B) */
}

/* Terzaghi's column, whose top drains and whose base is closed, under a load from time 0 on: the pressure over that of
 * time 0 at the depth z, in parts of the height H; T = c t/H^2 >= 0.  (Terzaghi 1943)
 *     p/p_u = sum over m of 2/M sin(M z/H) exp(-M^2 T),   M = pi (2 m + 1)/2 */
static inline double consolidation_terzaghi(double depth, double T) {
    const double pi = acos(-1);
    double sum = 0;
    if (T <= 0) return depth > 0 ? 1 : 0;
    if (T < SHORT) { /* a step from 1 to 0 at the top, and its mirror images at the base and at the top in turn */
        const double reach = 2 * sqrt(T);
        for (int n = 0; n < 4; n++)
            sum += (n % 2 ? -1 : 1) * (erfc((2 * n + depth) / reach) + erfc((2 * n + 2 - depth) / reach));
        return 1 - sum;
    }
    for (int m = 0;; m++) {
        const double M = 0.5 * pi * (2 * m + 1);
        if (M * M * T > NEGLIGIBLE) return sum;
        sum += 2 / M * sin(M * depth) * exp(-M * M * T);
    }
}

/* The part of the settlement that has come: 1 - sum of 2/M^2 exp(-M^2 T). */
static inline double consolidation_degree(double T) {
    const double pi = acos(-1);
    double sum = 0;
    if (T <= 0) return 0;
    if (T < SHORT) { /* with the first image; the second is below exp(-4/T) */
        const double root = sqrt(T);
        return 2 * sqrt(T / pi) + 4 * (erfc(1 / root) - root * exp(-1 / T) / sqrt(pi));
    }
    for (int m = 0;; m++) {
        const double M = 0.5 * pi * (2 * m + 1);
        if (M * M * T > NEGLIGIBLE) return 1 - sum;
        sum += 2 / (M * M) * exp(-M * M * T);
    }
}

/* The i-th root of sin b = eta b cos b, eta > 1: one sign change in (i pi, (i + 1/2) pi), halved until two numbers are
 * left. */
static inline double root(double eta, int i) {
    const double pi = acos(-1), side = i % 2 ? -1 : 1;
    double low = i * pi, high = (i + 0.5) * pi;
    if (i == 0) low = 0.5 * sqrt(3 * (1 - 1 / eta)); /* above 0 and below the root, since b cot b > 1 - b^2/2 */
    for (;;) {
        const double b = 0.5 * (low + high);
        if (b <= low || b >= high) return b;
        if (side * (sin(b) - eta * b * cos(b)) < 0)
            low = b;
        else
            high = b;
    }
}

/* Mandel's slab |x| <= a between two stiff plates, pressed with the force 2 F per depth from time 0 on, which drains at
 * x = +-a: the pressure over that of time 0, which is B (1 + nu_u)/3 F/a; x in parts of a, T = c t/a^2 >= 1e-6.
 * (Mandel 1953; Abousleiman et al. 1996)
 *     p/p_0 = 2 sum over i of sin b/(b - sin b cos b) (cos(b x/a) - cos b) exp(-b^2 T),
 *     tan b = b (1 - nu)/(nu_u - nu),   b in (i pi, (i + 1/2) pi) */
static inline double consolidation_mandel(double poisson_ratio, double undrained, double x, double T) {
    const double eta = (1 - poisson_ratio) / (undrained - poisson_ratio);
    double sum = 0;
    assert_true(T >= 1e-6 && eta > 1);
    for (int i = 0;; i++) {
        const double b = root(eta, i);
        if (b * b * T > NEGLIGIBLE) return sum;
        sum += 2 * sin(b) / (b - sin(b) * cos(b)) * (cos(b * x) - cos(b)) * exp(-b * b * T);
    }
}
