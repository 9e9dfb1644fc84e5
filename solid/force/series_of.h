/* g(eps) and 1/(1 + eps) of several bonds at a time. The including file defines:
 *     REAL, OF(op)   vec or vec4, and its functions      NAME(name)   the names of the functions here */
#include "solid/force/series.h"

/* Both are written for a short chain of dependent operations rather than for few operations, because the bonds are
 * independent of each other. g(eps) = s/(1 + s) = 1 - 1/sqrt(1 + eps), times c; where |eps| is small a Chebyshev fit of
 * degree four to g/eps. */
static inline REAL NAME(g_times)(REAL e, REAL c, const int exact) {
    const REAL root = exact ? OF(sqrt)(1 + e) : e, e2 = e * e;
    if (exact) return e * c / ((1 + root) * root);
    return (e * c) * ((G0 + e * G1) + e2 * ((G2 + e * G3) + e2 * G4));
}

/* 1/(1 + eps); for small |eps| (1 - eps)(1 + eps^2)(1 + eps^4), which differs by a factor 1 - eps^8. */
static inline REAL NAME(inverse)(REAL e, const int exact) {
    if (exact) return 1 / (1 + e);
    const REAL e2 = e * e, two = (1 - e) + (1 - e) * e2;
    return two + two * (e2 * e2);
}
