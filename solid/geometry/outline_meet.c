/* Common points of two edges of outlines. */
#include "solid/geometry/outline_edge.h"

#include <math.h>

/* The crossing of two straight lines. */
static int lines_cross(const struct solid_outline_edge *e, const struct solid_outline_edge *f, double x[2][2]) {
    const double ex = e->b[0] - e->a[0], ey = e->b[1] - e->a[1], fx = f->b[0] - f->a[0], fy = f->b[1] - f->a[1],
                 cross = ex * fy - ey * fx;
    if (cross == 0) return 0;
    const double t = ((f->a[0] - e->a[0]) * fy - (f->a[1] - e->a[1]) * fx) / cross;
    x[0][0] = e->a[0] + t * ex;
    x[0][1] = e->a[1] + t * ey;
    return 1;
}

/* Two points at distances +-h from the foot point, perpendicular to the direction d. */
static int both_sides(const long double foot[2], const long double d[2], long double h2, double x[2][2]) {
    const long double h = sqrtl(fmaxl(h2, 0));
    for (int k = 0; k < 2; k++) {
        x[k][0] = (double)(foot[0] + (k ? h : -h) * d[0]);
        x[k][1] = (double)(foot[1] + (k ? h : -h) * d[1]);
    }
    return 2;
}

static int line_meets_circle(const struct solid_outline_edge *line, const struct solid_outline_edge *arc,
                             double x[2][2]) {
    const long double length = hypotl(line->b[0] - line->a[0], line->b[1] - line->a[1]);
    if (length == 0) return 0;
    const long double d[2] = {(line->b[0] - line->a[0]) / length, (line->b[1] - line->a[1]) / length};
    const long double to[2] = {arc->centre[0] - line->a[0], arc->centre[1] - line->a[1]};
    const long double along = to[0] * d[0] + to[1] * d[1], off = d[0] * to[1] - d[1] * to[0];
    const long double foot[2] = {line->a[0] + along * d[0], line->a[1] + along * d[1]};
    return both_sides(foot, d, (arc->radius - off) * (arc->radius + off), x);
}

static int circles_meet(const struct solid_outline_edge *e, const struct solid_outline_edge *f, double x[2][2]) {
    const long double separation[2] = {f->centre[0] - e->centre[0], f->centre[1] - e->centre[1]};
    const long double distance = hypotl(separation[0], separation[1]);
    if (distance == 0) return 0;
    const long double d[2] = {separation[0] / distance, separation[1] / distance}, across[2] = {-d[1], d[0]};
    const long double a =
        (distance + (e->radius - f->radius) * (e->radius + f->radius) / distance) / 2; /* distance from e's centre */
    const long double foot[2] = {e->centre[0] + a * d[0], e->centre[1] + a * d[1]};
    return both_sides(foot, across, (e->radius - a) * (e->radius + a), x);
}

/* The candidates are the crossings of the lines and circles, and the ends and midpoints of both edges: an overlap
 * contains one of these. */
int solid_outline_meet(const struct solid_outline_edge *e, const struct solid_outline_edge *f, double tolerance,
                       double point[8][2]) {
    double x[8][2];
    int n = e->turn && f->turn ? circles_meet(e, f, x)
            : e->turn          ? line_meets_circle(f, e, x)
            : f->turn          ? line_meets_circle(e, f, x)
                               : lines_cross(e, f, x);
    for (int k = 0; k < 3; k++) {
        solid_outline_edge_point(e, 0.5L * k, x[n++]);
        solid_outline_edge_point(f, 0.5L * k, x[n++]);
    }
    int kept = 0;
    for (int k = 0; k < n; k++)
        if (solid_outline_edge_distance(e, x[k]) <= tolerance && solid_outline_edge_distance(f, x[k]) <= tolerance) {
            point[kept][0] = x[k][0];
            point[kept++][1] = x[k][1];
        }
    return kept;
}
