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
/* Distance of x from the crack. */
double meshless_cut_from_line(const struct galerkin_line *line, const double x[2]);
/* Distance from x to the nearest tip, and which; INFINITY and -1 without one. */
double meshless_cut_nearest(const struct galerkin *g, const double x[2], int *tip);
/* The last straight part of the crack before a tip. */
const struct galerkin_part *meshless_cut_part(const struct galerkin *g, const struct galerkin_tip *tip);
/* Distance of x from the other parts of the tip's crack; INFINITY for a straight one. */
double meshless_cut_from_bends(const struct galerkin *g, const struct galerkin_tip *tip, const double x[2]);
/* How far a crack of several parts is cut beyond its end: by reach, or two supports where it leaves the body. */
double meshless_cut_reach(const struct galerkin *g, const struct galerkin_line *line, int end);
void meshless_cut_end(struct galerkin *g); /* Not collective. */
/* Distance of x from the body's outline and holes (at most that from their corners), positive inside. */
double meshless_cut_depth(const struct galerkin_input *in, const double x[2]);
