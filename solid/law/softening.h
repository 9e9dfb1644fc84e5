/* The bilinear law of one bond (physics/softening.h). For solid/ only. */
#pragma once

/* The part of its stiffness that a bond has kept after the stretch `most`; 0: it is broken. Its force is this part of
 * the elastic force, at any stretch up to `most`. */
static inline double solid_softening_share(double s_e, double s_c, double most) {
    if (most <= s_e) return 1;
    return most < s_c ? s_e * (s_c - most) / ((s_c - s_e) * most) : 0;
}
