/* Bond forces of one segment of eight lattice sites in single precision: differences in double, the rest in single. */
#include "solid/force/segment_single.h"
#include "base/vec.h"

/* As in series_of.h, for single precision and |eps| < SOLID_SINGLE_SERIES_LIMIT: a fit of degree two, good to 2e-8, and
 * 1/(1 + eps) = (1 - eps)(1 + eps^2), which differs by a factor 1 - eps^4. */
static inline vecf single_g_times(vecf e, vecf c, const int exact) {
    const vecf root = exact ? vecf_sqrt(1 + e) : e;
    if (exact) return e * c / ((1 + root) * root);
    return (e * c) * (0.5f + e * (-0.37500513f + e * 0.31250615f));
}

static inline vecf single_inverse(vecf e, const int exact) {
    if (exact) return 1 / (1 + e);
    return (1 - e) + (1 - e) * (e * e);
}

#define REAL vecf
#define OF(op) vecf_##op
#define NAME(name) single_##name
#define PLACES 8
#define LANES VEC_LANES
#define BOXES struct solid_boxes_single
#define WIDE vec
#define WIDE_LOAD(p) vec_load(p)
#define APART(difference) vecf_of(difference)
#include "solid/force/strip.h"

static inline __attribute__((always_inline)) struct solid_range segment(const struct solid_boxes_single *in,
                                                                        const struct solid_segments *segments, int g,
                                                                        const enum solid_kernel kernel, double *power) {
    const uint32_t *entry = segments->entry + segments->first[g];
    const uint16_t *count = segments->count[g];
    const int *far = segments->far + segments->first[g];
    const long at = segments->at[g];
    struct single_result of = {vecf_set(0), vecf_set(0), vecf_set(0)};
    single_strip(in, at, entry, far, count[0], &of, kernel, 1);
    if (count[1]) single_strip(in, at, entry + count[0], far + count[0], count[1], &of, kernel, 0);
    if (kernel & KERNEL_DAMPED) *power += vecf_sum(of.power);
    return (struct solid_range){vecf_highest(of.high), vecf_lowest(of.low)};
}

#define CASE(kind)                                                                                                     \
    case kind:                                                                                                         \
        return segment(in, segments, g, (enum solid_kernel)(kind), power)

struct solid_range solid_segment_single_force(const struct solid_boxes_single *in,
                                              const struct solid_segments *segments, int g, enum solid_kernel kernel,
                                              double *power) {
    switch ((int)kernel) {
        CASE(0);
        CASE(1);
        CASE(2);
        CASE(3);
        CASE(4);
        CASE(5);
        CASE(6);
        CASE(7);
    default:
        return segment(in, segments, g, KERNEL_JUDGE, power);
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
    }
}
