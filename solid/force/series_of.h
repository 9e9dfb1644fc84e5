/* g(eps), s(eps) and 1/(1 + eps) of several bonds at a time. The including file defines:
 *     REAL, OF(op)   vec or vec4, and its functions      NAME(name)   the names of the functions here */
#include "solid/force/series.h"

/* All are written for a short chain of dependent operations rather than for few operations, because the bonds are
 * independent of each other. */

/* Whether the long series holds. It is seldom otherwise, so that the processor foresees the branch. */
static inline int NAME(is_long)(REAL e, enum solid_series series) {
    const double limit2 = SOLID_SERIES_LONG_LIMIT * SOLID_SERIES_LONG_LIMIT;
    return series == SERIES_LONG && !OF(any_above)(e * e, limit2);
}

/* c times g(eps) = s/(1 + s) = 1 - 1/sqrt(1 + eps). */
static inline REAL NAME(g_times)(REAL e, REAL c, const enum solid_series series) {
    const REAL e2 = e * e;
    if (NAME(is_long)(e, series))
        return (e * c) * (((L0 + e * L1) + e2 * (L2 + e * L3)) + (e2 * e2) * ((L4 + e * L5) + e2 * L6));
    if (series != SERIES_SHORT) {
        const REAL root = OF(sqrt)(1 + e);
        return e * c / ((1 + root) * root);
    }
    return (e * c) * ((G0 + e * G1) + e2 * ((G2 + e * G3) + e2 * G4));
}

/* c times s = sqrt(1 + eps) - 1. */
static inline REAL NAME(s_times)(REAL e, REAL c, const enum solid_series series) {
    const REAL e2 = e * e;
    if (NAME(is_long)(e, series))
        return (e * c) * (((R0 + e * R1) + e2 * (R2 + e * R3)) + (e2 * e2) * ((R4 + e * R5) + e2 * R6));
    if (series != SERIES_SHORT) return e * c / (1 + OF(sqrt)(1 + e));
    return (e * c) * ((S0 + e * S1) + e2 * ((S2 + e * S3) + e2 * S4));
}

/* 1/(1 + eps); for small |eps| (1 - eps)(1 + eps^2)(1 + eps^4), which differs by a factor 1 - eps^8, and the next such
 * factor. */
static inline REAL NAME(inverse)(REAL e, const enum solid_series series) {
    const int is_long = NAME(is_long)(e, series);
    if (series != SERIES_SHORT && !is_long) return 1 / (1 + e);
    const REAL e2 = e * e, e4 = e2 * e2, two = (1 - e) + (1 - e) * e2, four = two + two * e4;
    return is_long ? four + four * (e4 * e4) : four;
}
