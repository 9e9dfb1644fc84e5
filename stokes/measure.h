/* Means of a solution over a box within the cells. */
#pragma once
#include "stokes/stokes.h"

struct stokes_measure {
    double mean[3];    /* of the velocity at centres over the box, solid included, m2 */
    double tortuosity; /* sum of |u| over sum of u along the axis, over the pore cells of the box  (001: eq. 2.7) */
};

/* low, high [3]: in cells from the corner of the box, of which they may cut cells. Collective. */
struct stokes_measure stokes_measure_box(const struct stokes *s, int axis, const double low[3], const double high[3]);

/* Of a section across the axis: the mean of p over its pore cells, and their number. [n] of the box's cells along the
 * axis. Collective. */
struct stokes_measure_section {
    double p, pores;
};
void stokes_measure_sections(const struct stokes *s, int axis, struct stokes_measure_section *section);
