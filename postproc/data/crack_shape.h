/* The shape of a crack, read off the damage on a grid: the level that encloses the initial crack, branches, angles. */
#pragma once
#include "postproc/data/grid.h"
#include "scene/scene.h"

/* The ends of the initial cracks that are in the plate's inside: where they may grow from. */
struct postproc_tip {
    double x[2], direction[2]; /* m; of the crack's last piece, outward, length 1 */
    const struct scene_crack *crack;
};
/* tip [2 * cracks]; returns how many. g: any field of the plate. */
int postproc_crack_shape_tips(const struct postproc_grid *g, int cracks, const struct scene_crack *crack,
                              struct postproc_tip *tip);

/* The level whose contour encloses the initial cracks most closely. What is above a level shrinks as the level rises,
 * so it is the highest that every place of a crack is above, away from its tips by more than `margin`: 0.98 of that, so
 * that the contour goes round the particles beside the crack, not through them. NAN where no place is damaged.  (003:
 * sec. 3, "curve di livello") */
double postproc_crack_shape_level(const struct postproc_grid *damage, int cracks, const struct scene_crack *crack,
                                  double margin);

/* What hangs together with a place: nodes above the level, across gaps of up to two nodes; a grid with the others NaN.
 */
struct postproc_grid *postproc_crack_shape_connected(const struct postproc_grid *damage, double level,
                                                     const double x[2]);

struct postproc_angle {
    double value, error; /* degrees to the axis, away from it; twice the standard error of the fit; NAN: none */
};
struct postproc_branching {
    int found;
    double
        place[2]; /* along and across the axis, m: the first column in which undamaged nodes part the crack for good */
    struct {
        struct postproc_angle first, last; /* over the length given, behind the place and at the branch's end */
        double end[2];                     /* along and across, m */
    } side[2];                             /* left, right of the axis */
};
/* Of a crack along the first axis of the grid (a turned one), all else NaN. Branches are the outermost runs of damaged
 * nodes of the columns; their centre lines are means weighted by damage. length: over which angles are taken, m. */
struct postproc_branching postproc_crack_branch_of(const struct postproc_grid *crack, double length);

/* The place farthest from a tip among what is damaged and no initial crack, and the angle from the tip's direction to
 * it. */
struct postproc_chord {
    int found;
    double end[2], length; /* m */
    struct postproc_angle angle;
};
struct postproc_chord postproc_crack_shape_chord(const struct postproc_grid *crack, const struct postproc_tip *tip);
