/* Terzaghi's and Mandel's pressure of consolidation, by their series. */
#include "physics/consolidation.h"
#include "base/ensure.h"

#include <math.h>

static const double SHORT = 0.05;      /* below this T the images of the surface are summed instead of the series */
static const double NEGLIGIBLE = 40.0; /* exp(-40) = 4e-18 */

double physics_consolidation_coefficient(const struct physics_consolidation *in) {
    const double nu = in->poisson_ratio;
    const double confined = in->youngs_modulus * (1 - nu) / ((1 + nu) * (1 - 2 * nu));
    return in->mobility / (1 / in->modulus + in->biot * in->biot / confined);
}

/* K */
static double drained_bulk(const struct physics_consolidation *in) {
    return in->youngs_modulus / (3 * (1 - 2 * in->poisson_ratio));
}

double physics_consolidation_skempton(const struct physics_consolidation *in) {
    return in->biot / (drained_bulk(in) / in->modulus + in->biot * in->biot);
}

double physics_consolidation_undrained(const struct physics_consolidation *in) {
    const double nu = in->poisson_ratio, stiffer = in->biot * physics_consolidation_skempton(in) * (1 - 2 * nu);
    return (3 * nu + stiffer) / (3 - stiffer); /* K_u = K/(1 - alpha B) */
}

double physics_consolidation_terzaghi(double depth, double T) {
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

double physics_consolidation_degree(double T) {
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
static double root(double eta, int i) {
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

double physics_consolidation_mandel(double poisson_ratio, double undrained, double x, double T) {
    const double eta = (1 - poisson_ratio) / (undrained - poisson_ratio);
    double sum = 0;
    ENSURE(T >= 1e-6 && eta > 1, "T %g, eta %g", T, eta);
    for (int i = 0;; i++) {
        const double b = root(eta, i);
        if (b * b * T > NEGLIGIBLE) return sum;
        sum += 2 * sin(b) / (b - sin(b) * cos(b)) * (cos(b * x) - cos(b)) * exp(-b * b * T);
    }
}
