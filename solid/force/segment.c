/* Bond forces of one segment of eight lattice sites: the kernel in its compiled variants. */
#include "solid/force/segment.h"
#include "base/vec4.h"
#include "solid/force/series.h"

#include <assert.h>

#define REAL vec
#define OF(op) vec_##op
#define NAME(name) wide_##name
#define PLACES 8
#define LANES VEC_LANES
#define BOXES struct solid_boxes
#define OFFSET struct solid_lattice_offset
#define WIDE REAL
#define WIDE_LOAD(c, at) OF(load)(box->d[c] + (at))
#define DIFFERENCE(difference) (difference)
#include "solid/force/series_of.h"
#include "solid/force/strip.h"
#undef REAL
#undef OF
#undef NAME
#undef PLACES
#undef LANES

#define REAL vec4
#define OF(op) vec4_##op
#define NAME(name) narrow_##name
#define PLACES 4
#define LANES VEC4_LANES
#include "solid/force/series_of.h"
#include "solid/force/strip.h"

SOLID_FOR_EACH_KERNEL struct solid_range segment(const struct solid_boxes *in, const struct solid_segments *segments,
                                                 int g, const enum solid_kernel kernel, double *power) {
    const uint32_t *entry = segments->entry + segments->first[g];
    const uint16_t *count = segments->count[g];
    const int *far = segments->far + segments->first[g];
    const long at = segments->at[g];
    struct wide_result wide = {vec_set(0), vec_set(0), vec_set(0)};
    struct narrow_result narrow = {vec4_set(0), vec4_set(0), vec4_set(0)};
    struct solid_range range = {0, 0};
    if (SOLID_STRIPS_WIDE) {
        wide_strip(in, at, entry, far, count[0], &wide, kernel, 1);
        entry += count[0];
        far += count[0];
        if (count[1]) wide_strip(in, at, entry, far, count[1], &wide, kernel, 0);
        entry += count[1];
        far += count[1];
        range = (struct solid_range){vec_highest(wide.high), vec_lowest(wide.low)};
        if (kernel & KERNEL_DAMPED) *power += vec_sum(wide.power);
    }
    for (int strip = 2; strip < SOLID_STRIPS; strip += 2) {
        const long from = at + solid_segments_strip_site(strip);
        if (count[strip]) narrow_strip(in, from, entry, far, count[strip], &narrow, kernel, 1);
        entry += count[strip];
        far += count[strip];
        if (count[strip + 1]) narrow_strip(in, from, entry, far, count[strip + 1], &narrow, kernel, 0);
        entry += count[strip + 1];
        far += count[strip + 1];
    }
    if (kernel & KERNEL_DAMPED) *power += vec4_sum(narrow.power);
    const double high = vec4_highest(narrow.high), low = vec4_lowest(narrow.low);
    if (high > range.high) range.high = high;
    if (low < range.low) range.low = low;
    return range;
}

typedef struct solid_range segment_kernel(const struct solid_boxes *, const struct solid_segments *, int, double *);

#define SEGMENT_KERNEL(kind)                                                                                           \
    static struct solid_range segment_##kind(const struct solid_boxes *in, const struct solid_segments *t, int g,      \
                                             double *power) {                                                          \
        return segment(in, t, g, (enum solid_kernel)(kind), power);                                                    \
    }
SEGMENT_KERNEL(0)
SEGMENT_KERNEL(1)
SEGMENT_KERNEL(2)
SEGMENT_KERNEL(3)
SEGMENT_KERNEL(4)
SEGMENT_KERNEL(5)
SEGMENT_KERNEL(6)
SEGMENT_KERNEL(7)
SEGMENT_KERNEL(8)
SEGMENT_KERNEL(16)
SEGMENT_KERNEL(17)
SEGMENT_KERNEL(18)
SEGMENT_KERNEL(19)
SEGMENT_KERNEL(20)
SEGMENT_KERNEL(21)
SEGMENT_KERNEL(22)
SEGMENT_KERNEL(23)
SEGMENT_KERNEL(24)

/* [bonds of several materials] */
static segment_kernel *const kernels[][KERNEL_STRETCH_ONLY + 1] = {
    {segment_0, segment_1, segment_2, segment_3, segment_4, segment_5, segment_6, segment_7, segment_8},
    {segment_16, segment_17, segment_18, segment_19, segment_20, segment_21, segment_22, segment_23, segment_24}};
static_assert(sizeof kernels / sizeof **kernels == 2 * (KERNEL_STRETCH_ONLY + 1) &&
                  KERNEL_SEVERAL == 2 * KERNEL_STRETCH_ONLY,
              "every kernel of enum solid_kernel needs its line");

struct solid_range solid_segment_force(const struct solid_boxes *in, const struct solid_segments *segments, int g,
                                       enum solid_kernel kernel, double *power) {
    const int several = (kernel & KERNEL_SEVERAL) != 0, kind = (int)kernel & (KERNEL_SEVERAL - 1);
    return kernels[several][kind & KERNEL_STRETCH_ONLY ? KERNEL_STRETCH_ONLY : kind](in, segments, g, power);
}
