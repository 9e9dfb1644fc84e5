/* Bond forces of one segment of a lattice in single precision. For solid/ only. */
#pragma once
#include "solid/force/segment.h"

/* eps of an intact bond differs from that in double by less than this, however its ends have moved and turned: eight
 * roundings of 2^-24 of the sum of |eta_i| (2 |xi_i| + |eta_i|)/|xi|^2, with |eta| < 2.1 |xi|. */
#define SOLID_SINGLE_EPS_ERROR 5e-6

/* The largest |eps| for the series. */
#define SOLID_SINGLE_SERIES_LIMIT 5e-3

/* Displacements of at most this many spacings are rounded to single before their difference is taken, which is then off
 * by at most 2^-28 spacings; of larger ones the difference is taken in double. */
#define SOLID_SINGLE_NEAR 0.0625

enum { KERNEL_NEAR = 128 }; /* with enum solid_kernel: the displacements are d_single */

/* As struct solid_boxes. */
struct solid_boxes_single {
    const double *d[3];                  /* m */
    const float *d_single[3], *v[3], *w; /* m, m/s, - */
    const float *half, *threshold;       /* NULL: of one material only */
    const float *pressure;
    float *a[3]; /* m/s2, added to */
    const struct solid_lattice_offset_single *offset;
};

/* The constants of the offsets in single. */
void solid_segment_single_offsets(const struct solid_lattice_offset *from, int n,
                                  struct solid_lattice_offset_single *to);

/* Pure; as solid_segment_force. Forces are added in single, the power of each lane of a segment to *power in double. */
struct solid_range solid_segment_single_force(const struct solid_boxes_single *in,
                                              const struct solid_segments *segments, int g, int kernel, double *power);
