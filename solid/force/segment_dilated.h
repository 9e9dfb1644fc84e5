/* One segment of a lattice whose families have a dilatation (solid/force/dilatation.h). For solid/ only. */
#pragma once
#include "solid/force/segment.h"

/* Pure; as solid_segment_force, of the kernels with KERNEL_EXTENSION or KERNEL_PRESSED. */
struct solid_range solid_segment_dilated_force(const struct solid_boxes *in, const struct solid_segments *segments,
                                               int g, enum solid_kernel kernel, double *power);
