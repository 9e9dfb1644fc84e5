/* The shape of a crack from the damage on a grid: the level that encloses the initial crack, branches, angles. */
#pragma once
#include "postproc/data/grid.h"
#include "scene/scene.h"

/* The ends of the initial cracks inside the plate: cracks may grow from them. */
struct postproc_tip {
    double x[2], direction[2]; /* m; of the crack's last piece, outward, length 1 */
    const struct scene_crack *crack;
};
/* tip [2 * cracks]; returns how many. g: any field of the plate. */
int postproc_crack_shape_tips(const struct postproc_grid *g, int cracks, const struct scene_crack *crack,
                              struct postproc_tip *tip);

/* The level whose contour encloses the initial cracks most closely. The area above a level shrinks as the level rises.
 * So this is the highest level that all points of the cracks exceed, except points within `margin` of a tip; times
 * 0.98, so that the contour goes round the particles beside the crack and not through them. NAN if no point is damaged.
 * (003: sec. 3, "curve di livello") */
double postproc_crack_shape_level(const struct postproc_grid *damage, int cracks, const struct scene_crack *crack,
                                  double margin);

/* The nodes above the level that are connected to a point, across gaps of up to two nodes: a grid with all other nodes
 * NaN. */
struct postproc_grid *postproc_crack_shape_connected(const struct postproc_grid *damage, double level,
                                                     const double x[2]);

struct postproc_angle {
    double value, error; /* degrees away from the axis; twice the standard error of the fit; NAN: none */
};
struct postproc_branching {
    int found;
    double place[2]; /* along and across the axis, m: the first column from which on undamaged nodes separate the
                      * branches */
    struct {
        struct postproc_angle first, last; /* over the given length, behind the branching point and at the branch's
                                            * end */
        double end[2];                     /* along and across, m */
    } side[2];                             /* left and right of the axis */
};
/* Branching of a crack along the first axis of the (turned) grid; nodes outside the crack are NaN. The branches are the
 * outermost runs of damaged nodes in the columns; their centre lines are means weighted by damage. length: the angles
 * are fitted over it, m. */
struct postproc_branching postproc_crack_branch_of(const struct postproc_grid *crack, double length);

/* The damaged point farthest from a tip that is on no initial crack, and the angle between the tip's direction and the
 * line to this point. */
struct postproc_chord {
    int found;
    double end[2], length; /* m */
    struct postproc_angle angle;
};
struct postproc_chord postproc_crack_shape_chord(const struct postproc_grid *crack, const struct postproc_tip *tip);
