/* Bond forces of one segment of eight lattice sites in single precision: differences in double, the rest in single. */
#include "solid/force/segment_single.h"
#include "base/ensure.h"
#include "base/vecf.h"
#include "solid/force/series.h"

/* As in series_of.h, for single precision and |eps| < SOLID_SINGLE_SERIES_LIMIT: a fit of degree two, good to 2e-8, for
 * g and s, and 1/(1 + eps) = (1 - eps)(1 + eps^2), which differs by a factor 1 - eps^4. */
#define SERIES                                                                                                         \
    static inline REAL NAME(g_times)(REAL e, REAL c, const enum solid_series series) {                                 \
        const REAL root = series != SERIES_SHORT ? OF(sqrt)(1 + e) : e;                                                \
        if (series != SERIES_SHORT) return e * c / ((1 + root) * root);                                                \
        return (e * c) * (F0 + e * (F1 + e * F2));                                                                     \
    }                                                                                                                  \
    static inline REAL NAME(s_times)(REAL e, REAL c, const enum solid_series series) {                                 \
        if (series != SERIES_SHORT) return e * c / (1 + OF(sqrt)(1 + e));                                              \
        return (e * c) * (H0 + e * (H1 + e * H2));                                                                     \
    }                                                                                                                  \
    static inline REAL NAME(inverse)(REAL e, const enum solid_series series) {                                         \
        if (series != SERIES_SHORT) return 1 / (1 + e);                                                                \
        return (1 - e) + (1 - e) * (e * e);                                                                            \
    }
static const float F0 = 0.5F, F1 = -0.37500513F, F2 = 0.31250615F;
static const float H0 = 0.5F, H1 = -0.12500073F, H2 = 0.062500513F;

#define BOXES struct solid_boxes_single
#define OFFSET struct solid_lattice_offset_single

/* The strips of both widths, first of displacements in double, then of rounded ones. */
#define REAL vecf
#define OF(op) vecf_##op
#define PLACES 8
#define LANES VEC_LANES
#define NAME(name) wide_##name
#define WIDE vec
#define WIDE_LOAD(c, at) vec_load(box->d[c] + (at))
#define DIFFERENCE(difference) vecf_of(difference)
SERIES
#include "solid/force/strip.h"
#undef NAME
#undef WIDE
#undef WIDE_LOAD
#undef DIFFERENCE
#define NAME(name) wide_near_##name
#define WIDE vecf
#define WIDE_LOAD(c, at) vecf_load(box->d_single[c] + (at))
#define DIFFERENCE(difference) (difference)
SERIES
#include "solid/force/strip.h"
#undef REAL
#undef OF
#undef PLACES
#undef LANES
#undef NAME
#undef WIDE
#undef WIDE_LOAD
#undef DIFFERENCE

#define REAL vecf4
#define OF(op) vecf4_##op
#define PLACES 4
#define LANES VECF4_LANES
#define NAME(name) narrow_##name
#define WIDE vecf4_wide
#define WIDE_LOAD(c, at) vecf4_wide_load(box->d[c] + (at))
#define DIFFERENCE(difference) vecf4_of(difference)
SERIES
#include "solid/force/strip.h"
#undef NAME
#undef WIDE
#undef WIDE_LOAD
#undef DIFFERENCE
#define NAME(name) narrow_near_##name
#define WIDE vecf4
#define WIDE_LOAD(c, at) vecf4_load(box->d_single[c] + (at))
#define DIFFERENCE(difference) (difference)
SERIES
#include "solid/force/strip.h"

/* The kernel of a segment, by its strips of both widths. */
#define SEGMENT(name, wide, narrow)                                                                                    \
    SOLID_FOR_EACH_KERNEL struct solid_range name(const struct solid_boxes_single *in,                                 \
                                                  const struct solid_segments *segments, int g,                        \
                                                  const enum solid_kernel kernel, double *power) {                     \
        const uint32_t *entry = segments->entry + segments->first[g];                                                  \
        const uint16_t *count = segments->count[g];                                                                    \
        const int *far = segments->far + segments->first[g];                                                           \
        const long at = segments->at[g];                                                                               \
        struct wide##_result of8 = {vecf_set(0), vecf_set(0), vecf_set(0)};                                            \
        struct narrow##_result of4 = {vecf4_set(0), vecf4_set(0), vecf4_set(0)};                                       \
        for (int strip = 0; strip < SOLID_STRIPS; entry += count[strip], far += count[strip], strip++) {               \
            const long from = at + solid_segments_strip_site(strip);                                                   \
            if (!count[strip]) continue;                                                                               \
            if (strip == 0 && SOLID_STRIPS_WIDE) wide##_strip(in, at, entry, far, count[strip], &of8, kernel, 1);      \
            if (strip == 1 && SOLID_STRIPS_WIDE) wide##_strip(in, at, entry, far, count[strip], &of8, kernel, 0);      \
            if (strip > 1 && strip % 2 == 0) narrow##_strip(in, from, entry, far, count[strip], &of4, kernel, 1);      \
            if (strip > 1 && strip % 2) narrow##_strip(in, from, entry, far, count[strip], &of4, kernel, 0);           \
        }                                                                                                              \
        if (kernel & KERNEL_DAMPED) *power += vecf_sum(of8.power) + vecf4_sum(of4.power);                              \
        const float high[2] = {vecf_highest(of8.high), vecf4_highest(of4.high)},                                       \
                    low[2] = {vecf_lowest(of8.low), vecf4_lowest(of4.low)};                                            \
        return (struct solid_range){(double)(high[0] > high[1] ? high[0] : high[1]),                                   \
                                    (double)(low[0] < low[1] ? low[0] : low[1])};                                      \
    }
SEGMENT(segment, wide, narrow)
SEGMENT(segment_near, wide_near, narrow_near)

/* The sums of enum solid_kernel that are compiled: forces, stretches alone, extensions, forces with pressure. */
/* clang-format off */
#define KINDS(X) X(0) X(1) X(2) X(3) X(4) X(5) X(6) X(7) X(8) X(32) X(33) X(34) X(35) \
    X(64) X(65) X(66) X(67) X(68) X(69) X(70) X(71)
/* clang-format on */
#define KERNEL(name, kind)                                                                                             \
    static struct solid_range name##_##kind(const struct solid_boxes_single *in, const struct solid_segments *t,       \
                                            int g, double *power) {                                                    \
        return name(in, t, g, (enum solid_kernel)(kind), power);                                                       \
    }
#define KERNELS(kind) KERNEL(segment, kind) KERNEL(segment_near, kind)
KINDS(KERNELS)

#define CASES(kind)                                                                                                    \
    case kind:                                                                                                         \
        return segment_##kind(in, segments, g, power);                                                                 \
    case (kind) | KERNEL_NEAR:                                                                                         \
        return segment_near_##kind(in, segments, g, power);

struct solid_range solid_segment_single_force(const struct solid_boxes_single *in,
                                              const struct solid_segments *segments, int g, int kernel, double *power) {
    switch (kernel) {
        KINDS(CASES)
    default:
        ENSURE(0, "kernel %d", kernel);
    }
}

static void singles(const double *from, int n, float *to) {
    for (int i = 0; i < n; i++) to[i] = (float)from[i];
}

void solid_segment_single_offsets(const struct solid_lattice_offset *from, int n,
                                  struct solid_lattice_offset_single *to) {
    for (int o = 0; o < n; o++) {
        singles(from[o].xi, 3, to[o].xi);
        singles(from[o].xi2, 3, to[o].xi2);
        singles(&from[o].inv_length2, 1, &to[o].inv_length2);
        singles(&from[o].elastic, 1, &to[o].elastic);
        singles(&from[o].elastic_twice, 1, &to[o].elastic_twice);
        singles(&from[o].viscous, 1, &to[o].viscous);
        singles(&from[o].length2, 1, &to[o].length2);
    }
}
