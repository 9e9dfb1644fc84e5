/* The way of a crack's tips: speed over a window of time, and the length that has been added.  (000: eq. 41) */
#pragma once
#include "solid/measure/crack.h"

struct solid_crack_motion {
    double speed;                   /* of the side that leads, m/s; NaN before a second sample */
    double side[SOLID_CRACK_SIDES]; /* m/s */
    double length;                  /* of all branches since the first sample, m */
};

struct solid_crack_track; /* opaque */

/* window: s; spacing: of the particles, m. */
struct solid_crack_track *solid_crack_track_new(double window, double spacing);
void solid_crack_track_free(struct solid_crack_track *k);
/* The tips at a later time. Speeds are |x(t) - x(t_1)|/(t - t_1), t_1 the last sample at least a window ago, or the
 * first one; x(t_1) is the nearer of the places at which a tip stood then, so that a tip that leaps from one branch to
 * another is not taken for a fast one. The length is that of a tree of chords, a few particles each, that the tips
 * leave behind. Pure. */
struct solid_crack_motion solid_crack_track_add(struct solid_crack_track *k, double t,
                                                const struct solid_crack_tips *tips, const double direction[2]);
