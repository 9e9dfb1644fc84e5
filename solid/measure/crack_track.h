/* The motion of a crack's tips: speed over a window of time, and length added to the crack.  (000: eq. 41) */
#pragma once
#include "solid/measure/crack.h"

struct solid_crack_motion {
    double speed;                   /* of the faster side, m/s; NaN before a second sample */
    double side[SOLID_CRACK_SIDES]; /* m/s */
    double length;                  /* of all branches since the first sample, m */
};

struct solid_crack_track; /* opaque */

/* window: s; spacing: of the particles, m. */
struct solid_crack_track *solid_crack_track_new(double window, double spacing);
void solid_crack_track_free(struct solid_crack_track *k);
/* Adds the tips at a later time. Speeds are |x(t) - x(t_1)|/(t - t_1), with t_1 the last sample at least a window ago,
 * or the first one. x(t_1) is the nearest of the tips at that time, so that a tip that jumps from one branch to another
 * does not count as a fast one. The length is that of a tree of chords behind the tips, each a few particles long.
 * Pure. */
struct solid_crack_motion solid_crack_track_add(struct solid_crack_track *k, double t,
                                                const struct solid_crack_tips *tips, const double direction[2]);
