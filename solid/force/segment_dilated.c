/* Sums of extensions, and bond forces with the pressure of dilatations, of one segment: the compiled variants. */
#include "solid/force/segment_dilated.h"
#include "base/ensure.h"
#include "solid/force/segment_kernel.h"

#define CASE(kind)                                                                                                     \
    case kind:                                                                                                         \
        return segment(in, segments, g, (enum solid_kernel)(kind), power)
#define EXTENSION(kind)                                                                                                \
    CASE(KERNEL_EXTENSION | (kind));                                                                                   \
    CASE(KERNEL_EXTENSION | KERNEL_SEVERAL | (kind))
#define PRESSED(kind)                                                                                                  \
    CASE(KERNEL_PRESSED | (kind));                                                                                     \
    CASE(KERNEL_PRESSED | KERNEL_SEVERAL | (kind))

struct solid_range solid_segment_dilated_force(const struct solid_boxes *in, const struct solid_segments *segments,
                                               int g, enum solid_kernel kernel, double *power) {
    switch ((int)kernel) {
        EXTENSION(0);
        EXTENSION(KERNEL_BULK);
        EXTENSION(KERNEL_EXACT);
        EXTENSION(KERNEL_BULK | KERNEL_EXACT);
        PRESSED(0);
        PRESSED(1);
        PRESSED(2);
        PRESSED(3);
        PRESSED(4);
        PRESSED(5);
        PRESSED(6);
        PRESSED(7);
    default:
        ENSURE(0, "kernel %d", (int)kernel);
    }
}
