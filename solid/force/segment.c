/* Bond forces of one segment of eight lattice sites: the kernel in its compiled variants. */
#include "solid/force/segment_kernel.h"
#include "solid/force/segment_dilated.h"

#include <assert.h>

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
    if (kernel & (KERNEL_EXTENSION | KERNEL_PRESSED))
        return solid_segment_dilated_force(in, segments, g, kernel, power);
    return kernels[several][kind & KERNEL_STRETCH_ONLY ? KERNEL_STRETCH_ONLY : kind](in, segments, g, power);
}
