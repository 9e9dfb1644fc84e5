/* Sums of extensions, and bond forces with the pressure of dilatations, of one segment: the compiled variants. */
#include "solid/force/segment_dilated.h"
#include "base/ensure.h"
#include "solid/force/segment_kernel.h"

/* The sums of enum solid_kernel that are compiled: extensions and forces with pressure; 16 more: several materials. */
/* clang-format off */
#define KINDS(X) X(32) X(33) X(34) X(35) X(48) X(49) X(50) X(51) \
    X(64) X(65) X(66) X(67) X(68) X(69) X(70) X(71) X(80) X(81) X(82) X(83) X(84) X(85) X(86) X(87)
/* clang-format on */
#define KERNEL(kind)                                                                                                   \
    static struct solid_range segment_##kind(const struct solid_boxes *in, const struct solid_segments *t, int g,      \
                                             double *power) {                                                          \
        return segment(in, t, g, (enum solid_kernel)(kind), power);                                                    \
    }
KINDS(KERNEL)

#define CASE(kind)                                                                                                     \
    case kind:                                                                                                         \
        return segment_##kind(in, segments, g, power);

struct solid_range solid_segment_dilated_force(const struct solid_boxes *in, const struct solid_segments *segments,
                                               int g, enum solid_kernel kernel, double *power) {
    switch ((int)kernel) {
        KINDS(CASE)
    default:
        ENSURE(0, "kernel %d", (int)kernel);
    }
}
