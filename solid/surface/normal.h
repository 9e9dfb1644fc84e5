/* Outward normals.  (001: sec. 3.3.9, eqs 3.45, 3.46) */
#pragma once
#include "solid/bonds/family.h"

/* A normal and the data that it was computed from. */
struct solid_normal_data {
    double n[3];        /* unit */
    double moved[2][3]; /* d_l - d_h of two long intact bonds that are not parallel, when the normal was computed, m;
                         * their rotation tells when the normal must be recomputed */
    int l[2];           /* their other ends; -1: none */
    uint8_t two_sided;  /* enum solid_faces */
    uint8_t open;       /* the void cones when it was computed */
};

/* n = -sum (X_l - X_h) lambda Gamma V_l / sum lambda Gamma V_l, normalised.
 * If this vector is short (below 0.15 spacing; a flat face has 0.9) and opposite cones are void, the particle is a wall
 * one particle thick: two faces are wetted, and n is the axis along which its family extends least. (In a wall two
 * particles thick each layer has a long vector and its own face.) If it is short and no opposite cones are void, there
 * is a small pore on one side: n points to it. For a particle without intact bonds n is the normal of its unbroken
 * family if that is long, else x. open: the void cones. Ghosts must be current. Not collective. */
void solid_normal_compute(const struct solid *s, int h, const struct solid_family_view *view, unsigned open,
                          struct solid_normal_data *out);
/* The same for the undeformed, unbroken solid. */
void solid_normal_compute_initial(const struct solid *s, int h, const struct solid_family_view *view, unsigned open,
                                  struct solid_normal_data *out);
/* The same for the undeformed solid with the bonds that are intact now. */
void solid_normal_compute_undeformed(const struct solid *s, int h, const struct solid_family_view *view, unsigned open,
                                     struct solid_normal_data *out);
/* 1 if the two reference bonds have rotated so far (0.02 spacings at their ends, about 0.4 degrees) that the normal
 * must be recomputed; a common translation does not count. Ghosts must be current. Not collective. */
int solid_normal_has_turned(const struct solid *s, int h, const struct solid_normal_data *data);
