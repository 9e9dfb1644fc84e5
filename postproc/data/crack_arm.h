/* One arm of a crack, from its particles. */
#pragma once
#include "postproc/data/crack_arms.h"

struct postproc_crack_member {
    double d, t, x[2]; /* distance along the crack from its beginning, m; first damaged, s; place, m */
};

/* Sorts the n members by this distance. Sets the arm's ends, directions and length. The length is that of chords of
 * five spacings between means over a band. */
void postproc_crack_arm_line(struct postproc_arm *a, struct postproc_crack_member *m, long n,
                             const struct postproc_arms_input *in);
/* After the line. Sorts the members by time. The tip is the mean of the farthest particles whenever damage has gone
 * farther. Sets the arm's times, speeds and jumps, and its places, p[n]. */
void postproc_crack_arm_tip(struct postproc_arm *a, struct postproc_crack_member *m, long n,
                            const struct postproc_arms_input *in, struct postproc_place *p);
