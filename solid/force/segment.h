/* Bond forces of one segment of a lattice. For solid/ only. */
#pragma once
#include "solid/bonds/lattice.h"
#include "solid/bonds/segments.h"

/* The field arrays that the kernels use, from their first element. */
struct solid_boxes {
    const double *d[3], *v[3], *w;             /* displacement m, velocity m/s, V/V0 */
    const double *half, *threshold;            /* of several materials (solid/bonds/materials.h) */
    const double *pressure;                    /* solid_lattice.pressure; read with KERNEL_PRESSED */
    double *a[3];                              /* m/s2, added to */
    const struct solid_lattice_offset *offset; /* [all offsets], viscous includes k_d */
};

enum solid_kernel {
    KERNEL_BULK = 1,         /* alpha = 1 for all its bonds */
    KERNEL_EXACT = 2,        /* for any eps: SERIES_LONG */
    KERNEL_DAMPED = 4,       /* with pairwise damping */
    KERNEL_STRETCH_ONLY = 8, /* computes only high and low */
    KERNEL_SEVERAL = 16,     /* bonds of several materials */
    KERNEL_EXTENSION = 32,   /* sums of extensions and of stiffnesses, in place of forces */
    KERNEL_PRESSED = 64      /* with the pressure of the families' dilatation */
};

struct solid_range {
    double high, low; /* of eps; with KERNEL_STRETCH_ONLY and KERNEL_SEVERAL high: of eps less the lower `threshold` of
                         both ends; 0 with KERNEL_PRESSED, whose bonds the pass of extensions has tested */
};

/* A function that is compiled once for each kind of kernel. It is compiled once for all kinds in debug builds, where
 * the sanitizers make clang take minutes, and in the tests of other machines (FRANA_KERNELS_ONCE), where vectors are
 * loops. */
#if defined FRANA_DEBUG || defined FRANA_KERNELS_ONCE
#    define SOLID_FOR_EACH_KERNEL static
#else
#    define SOLID_FOR_EACH_KERNEL static inline __attribute__((always_inline))
#endif

/* Pure. Adds to *power the sum of viscous bond forces times closing speeds, over directed bonds, m2/s3. */
struct solid_range solid_segment_force(const struct solid_boxes *in, const struct solid_segments *segments, int g,
                                       enum solid_kernel kernel, double *power);
