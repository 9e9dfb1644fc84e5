/* Elastic energy of one segment of eight lattice sites: the kernel in its compiled variants. */
#include "solid/force/segment_energy.h"
#include "base/vec4.h"

#define REAL vec
#define OF(op) vec_##op
#define NAME(name) wide_##name
#define PLACES 8
#define LANES VEC_LANES
#include "solid/force/strip_energy.h"
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
#include "solid/force/strip_energy.h"

SOLID_FOR_EACH_KERNEL struct solid_segment_energy
energy(const struct solid_boxes *in, const struct solid_segments *segments, int g, const enum solid_kernel kernel) {
    const uint32_t *entry = segments->entry + segments->first[g];
    const int *far = segments->far + segments->first[g];
    const uint16_t *count = segments->count[g];
    vec wide[2] = {vec_set(0), vec_set(0)}, wide_largest = vec_set(0);
    vec4 narrow[2] = {vec4_set(0), vec4_set(0)}, narrow_largest = vec4_set(0);
    for (int strip = 0; strip < SOLID_STRIPS; strip++) {
        const long at = segments->at[g] + solid_segments_strip_site(strip);
        const int n = count[strip];
        if (n == 0) continue;
        if (strip < 2)
            wide_energy(in, at, entry, far, n, kernel, &wide[strip], &wide_largest);
        else
            narrow_energy(in, at, entry, far, n, kernel, &narrow[strip % 2], &narrow_largest);
        entry += n;
        far += n;
    }
    const double by_wide = vec_highest(wide_largest), by_narrow = vec4_highest(narrow_largest);
    return (struct solid_segment_energy){.whole = vec_sum(wide[0]) + vec4_sum(narrow[0]),
                                         .half = vec_sum(wide[1]) + vec4_sum(narrow[1]),
                                         .largest = by_wide > by_narrow ? by_wide : by_narrow};
}

struct solid_segment_energy solid_segment_energy(const struct solid_boxes *in, const struct solid_segments *segments,
                                                 int g, enum solid_kernel kernel) {
    if (kernel & KERNEL_SEVERAL)
        return kernel & KERNEL_EXACT ? energy(in, segments, g, KERNEL_SEVERAL | KERNEL_EXACT)
                                     : energy(in, segments, g, KERNEL_SEVERAL);
    if (kernel & KERNEL_EXACT) return energy(in, segments, g, KERNEL_EXACT);
    return kernel & KERNEL_BULK ? energy(in, segments, g, KERNEL_BULK) : energy(in, segments, g, (enum solid_kernel)0);
}
