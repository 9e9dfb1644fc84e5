/* Outward normals.  (001: sec. 3.3.9, eqs 3.45, 3.46) */
#pragma once
#include "solid/bonds/family.h"

/* A normal and what it was computed from. */
struct solid_facing {
    double n[3];        /* unit */
    double moved[2][3]; /* d_l - d_h of two feelers, long intact bonds that are not parallel, when it was computed, m */
    int l[2];           /* their other ends; -1: none */
    uint8_t two_sided;  /* enum solid_faces */
    uint8_t open;       /* the void cones when it was computed */
};

/* n = -sum (X_l - X_h) lambda Gamma V_l / sum lambda Gamma V_l, normalised.
 * Where that is short (below 0.15 spacing; a flat face has 0.9) and opposite cones are void, the particle is a wall one
 * thick: two-sided, n the axis along which its family extends least. (Of a wall two thick each layer has a long n and
 * its own face.) Where it is short and no opposite cones are void, a small pore lies on one side: n still points there.
 * A particle without intact bonds is two-sided, along the normal of its unbroken family where that is long, along x
 * otherwise. open: the void cones. Ghosts must be current. Not collective. */
void solid_normal_look(const struct solid *s, int h, const struct solid_family_view *view, unsigned open,
                       struct solid_facing *out);
/* The same for the undeformed, unbroken solid. */
void solid_normal_look_start(const struct solid *s, int h, const struct solid_family_view *view, unsigned open,
                             struct solid_facing *out);
/* 1 if the feelers have turned by enough (0.02 spacings at their ends, some 0.4 degrees) for the normal to be looked at
 * again; a common translation never is. Ghosts must be current. Not collective. */
int solid_normal_has_turned(const struct solid *s, int h, const struct solid_facing *facing);
