/* The kernel of one segment of eight lattice sites, which the including file compiles in variants. For solid/ only. */
#pragma once
#include "base/vec4.h"
#include "solid/force/segment.h"
#include "solid/force/series.h"

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
