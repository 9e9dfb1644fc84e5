/* Richardson extrapolation from two or three levels, with the grid convergence index.  (Roache 1994) */
#include "program/study/result/richardson.h"
#include "base/ensure.h"

#include <math.h>

enum { BISECTIONS = 80, ORDER_MAX = 64 };

/* 1.25 with an observed order, 3 with an assumed one.  (Roache 1994) */
static const double safety_observed = 1.25, safety_assumed = 3;
static const double near_formal = 1.1; /* an observed order up to this times the formal one counts as the formal one */

static struct study_richardson extrapolate(enum study_convergence kind, const double *f, const double *h, double p,
                                           double safety) {
    const double gain = pow(h[1] / h[0], p) - 1;
    return (struct study_richardson){.kind = kind,
                                     .order = p,
                                     .extrapolated = f[0] + (f[0] - f[1]) / gain,
                                     .gci = safety * fabs(f[0] - f[1]) / gain};
}

static struct study_richardson without(enum study_convergence kind) {
    return (struct study_richardson){.kind = kind, .order = NAN, .extrapolated = NAN, .gci = NAN};
}

/* p ln r21 - ln((r21^p - s)/(r32^p - s)): grows with p, for either s. */
static double spread_of(double p, double s, double ln21, double ln32) {
    const double a = s > 0 ? expm1(p * ln21) : exp(p * ln21) + 1;
    const double b = s > 0 ? expm1(p * ln32) : exp(p * ln32) + 1;
    return p * ln21 - log(a / b);
}

/* The order by bisection; NAN if there is no positive one. */
static double order_of(double ratio, double r21, double r32) {
    const double s = ratio > 0 ? 1 : -1, at = log(fabs(ratio)), ln21 = log(r21), ln32 = log(r32);
    double low = 1e-9, high = ORDER_MAX;
    if (spread_of(low, s, ln21, ln32) >= at || spread_of(high, s, ln21, ln32) <= at) return NAN;
    for (int k = 0; k < BISECTIONS; k++) {
        const double p = 0.5 * (low + high);
        if (spread_of(p, s, ln21, ln32) < at)
            low = p;
        else
            high = p;
    }
    return 0.5 * (low + high);
}

struct study_richardson study_richardson_three(const double f[3], const double h[3], double formal) {
    const double e21 = f[1] - f[0], e32 = f[2] - f[1];
    if (!isfinite(e21) || !isfinite(e32) || !(h[0] > 0 && h[1] > h[0] && h[2] > h[1])) return without(STUDY_UNKNOWN);
    if (e21 == 0) return without(STUDY_FLAT);
    if (e32 == 0) return without(STUDY_DIVERGENT);
    const double p = order_of(e32 / e21, h[1] / h[0], h[2] / h[1]);
    if (isnan(p)) return without(STUDY_DIVERGENT);
    const enum study_convergence kind = e32 / e21 > 0 ? STUDY_MONOTONE : STUDY_OSCILLATORY;
    struct study_richardson r =
        extrapolate(kind, f, h, fmin(p, formal), p > near_formal * formal ? safety_assumed : safety_observed);
    r.order = p;
    r.capped = p > formal;
    return r;
}

struct study_richardson study_richardson_two(const double f[2], const double h[2], double order) {
    if (!isfinite(f[0]) || !isfinite(f[1]) || !(h[0] > 0 && h[1] > h[0] && order > 0)) return without(STUDY_UNKNOWN);
    if (f[0] == f[1]) return without(STUDY_FLAT);
    return extrapolate(STUDY_MONOTONE, f, h, order, safety_assumed);
}

const char *study_richardson_name(enum study_convergence kind) {
    switch (kind) {
    case STUDY_UNKNOWN:
        return "unknown";
    case STUDY_MONOTONE:
        return "monotone";
    case STUDY_OSCILLATORY:
        return "oscillatory";
    case STUDY_DIVERGENT:
        return "divergent";
    case STUDY_FLAT:
        return "flat";
    }
    ENSURE(0, "convergence %d", (int)kind);
}
