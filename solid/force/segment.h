/* Bond forces of one segment of a lattice. Inside the room only. */
#pragma once
#include "solid/bonds/lattice.h"
#include "solid/bonds/segments.h"

/* What the kernels work on: boxes, at their first place. */
struct solid_boxes {
    const double *d[3], *v[3], *w;             /* displacement m, velocity m/s, V/V0 */
    double *a[3];                              /* m/s2, added to */
    const struct solid_lattice_offset *offset; /* [all offsets], viscous with k_d in it */
};

enum solid_kernel {
    KERNEL_BULK = 1,   /* alpha = 1 for all its bonds */
    KERNEL_EXACT = 2,  /* square roots, for any eps */
    KERNEL_DAMPED = 4, /* with pairwise damping */
    KERNEL_JUDGE = 8   /* only high and low */
};

struct solid_range {
    double high, low; /* of eps */
};

/* Pure. *power += the sum of viscous bond forces times closing speeds, of directed bonds, m2/s3. */
struct solid_range solid_segment_force(const struct solid_boxes *in, const struct solid_segments *segments, int g,
                                       enum solid_kernel kernel, double *power);
