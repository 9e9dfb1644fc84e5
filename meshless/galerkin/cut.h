/* Which nodes a point sees past the cracks.  (002: sec. 4) */
#pragma once
#include "meshless/galerkin/galerkin.h"

/* Frames and tips of the cracks. Dies (exit 2) where a crack is outside the body. Collective. */
void meshless_cut_begin(struct galerkin *g);
/* Marks the nodes whose supports meet a crack. Not collective. */
void meshless_cut_mark(struct galerkin *g);
/* Distance from the place to the node as the weight takes it, and its gradient; INFINITY where a crack hides the node.
 */
double meshless_cut_distance(const struct galerkin *g, const struct galerkin_place *at, int node, double gradient[2]);
/* Polar coordinates of x about a tip; the angle is from straight ahead, its sign on the crack is that of `see`. */
void meshless_cut_polar(const struct galerkin_tip *tip, const double x[2], const double see[2], double *r,
                        double *angle);
/* Distance of x from the crack's segment. */
double meshless_cut_from_line(const struct galerkin_line *line, const double x[2]);
/* Distance from x to the nearest tip, and which; INFINITY and -1 without one. */
double meshless_cut_nearest(const struct galerkin *g, const double x[2], int *tip);
/* Distance of x from the body's outline, positive inside. */
double meshless_cut_depth(const struct galerkin_input *in, const double x[2]);
