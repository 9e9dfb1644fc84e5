/* Checks an initial crack's geometry, and tests exactly whether a bond crosses it. */
#include "solid/geometry/cut.h"
#include "base/die.h"
#include "base/memory.h"
#include "solid/geometry/on_surface.h"

#include <math.h>
#include <stdio.h>

static const double PLANE = 1e-9; /* of the extent */

static void minus(const double a[3], const double b[3], double d[3]) {
    for (int c = 0; c < 3; c++) d[c] = a[c] - b[c];
}

static double dot(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

static void cross(const double a[3], const double b[3], double r[3]) {
    for (int c = 0; c < 3; c++) r[c] = a[(c + 1) % 3] * b[(c + 2) % 3] - a[(c + 2) % 3] * b[(c + 1) % 3];
}

/* The unit normal, from the diagonals. Returns the length of the longer one as the extent. */
static double normal_of(const double (*corner)[3], double normal[3]) {
    double one[3], other[3];
    minus(corner[2], corner[0], one);
    minus(corner[3], corner[1], other);
    cross(one, other, normal);
    const double length = sqrt(dot(normal, normal));
    for (int c = 0; c < 3; c++) normal[c] = length > 0 ? normal[c] / length : 0;
    return sqrt(fmax(dot(one, one), dot(other, other)));
}

/* Distance of x from the line that starts at corner k, in the plane, positive inside the quadrilateral. */
static double inner_side(const double (*corner)[3], int k, const double normal[3], const double x[3]) {
    double along[3], to[3], inward[3];
    minus(corner[(k + 1) % 4], corner[k], along);
    minus(x, corner[k], to);
    cross(normal, along, inward);
    return dot(inward, to) / sqrt(dot(along, along));
}

static int plane_fault(const struct solid_cut *cut, char *text, size_t size) {
    double normal[3], to[3];
    if (cut->points != 4) return snprintf(text, size, "a crack in three dimensions has 4 corners, not %d", cut->points);
    const double extent = normal_of(cut->point, normal);
    for (int k = 1; k < 4; k++) {
        minus(cut->point[k], cut->point[0], to);
        if (fabs(dot(to, normal)) > PLANE * extent)
            return snprintf(text, size, "corner %d of the crack is not in the plane of the others", k + 1);
    }
    for (int k = 0; k < 4; k++)
        if (dot(normal, normal) == 0 || inner_side(cut->point, k, normal, cut->point[(k + 2) % 4]) <= PLANE * extent ||
            inner_side(cut->point, k, normal, cut->point[(k + 3) % 4]) <= PLANE * extent)
            return snprintf(text, size, "the corners of the crack are not those of a convex quadrilateral, in order");
    return 0;
}

static int are_same(const double a[3], const double b[3], int dim) {
    return a[0] == b[0] && a[1] == b[1] && (dim == 2 || a[2] == b[2]);
}

int solid_cut_fault(const struct solid_cut *cut, int dim, char *text, size_t size) {
    if (cut->points < 2) return snprintf(text, size, "a crack needs at least 2 points"), 1;
    for (int k = 1; k < cut->points; k++)
        if (are_same(cut->point[k], cut->point[k - 1], dim))
            return snprintf(text, size, "points %d and %d of the crack are the same", k, k + 1), 1;
    return dim == 3 && plane_fault(cut, text, size);
}

struct solid_cut_line *solid_cut_line_new(const struct solid_cut *cut, const double origin[2], double spacing) {
    struct solid_cut_line *line = memory_new(MEMORY_SOLID, 1, sizeof *line);
    line->points = cut->points;
    line->point = memory_new(MEMORY_SOLID, (size_t)cut->points, sizeof *line->point);
    for (int k = 0; k < cut->points; k++)
        for (int c = 0; c < 2; c++) {
            const double at = (cut->point[k][c] - origin[c]) / spacing;
            if (!(fabs(at) < 0x1p28))
                die_all(EXIT_CODE_SCENE, "a crack's point is %g spacings from the lattice's origin", at);
            const double unit = 2 * SOLID_ON_SURFACE; /* what lies on a row of particles is moved into it */
            line->point[k][c] = (int64_t)rint(at / unit) * (int64_t)(unit * 0x1p32);
        }
    return line;
}

void solid_cut_line_free(struct solid_cut_line *line) {
    if (!line) return;
    MEMORY_FREE(line->point, line);
}

/* On which side of the line from p to q x is: 1, 0, -1. */
static int side_of(const int64_t p[2], const int64_t q[2], const int64_t x[2]) {
    const __int128 left = (__int128)(q[0] - p[0]) * (x[1] - p[1]), right = (__int128)(q[1] - p[1]) * (x[0] - p[0]);
    return (left > right) - (left < right);
}

/* Whether two closed segments meet: their boxes overlap, and neither segment lies wholly on one side of the other. */
static int segments_meet(const int64_t p[2], const int64_t q[2], const int64_t a[2], const int64_t b[2]) {
    for (int c = 0; c < 2; c++) {
        if ((p[c] < a[c] && p[c] < b[c] && q[c] < a[c] && q[c] < b[c]) ||
            (p[c] > a[c] && p[c] > b[c] && q[c] > a[c] && q[c] > b[c]))
            return 0;
    }
    return side_of(p, q, a) * side_of(p, q, b) <= 0 && side_of(a, b, p) * side_of(a, b, q) <= 0;
}

int solid_cut_line_crosses(const struct solid_cut_line *line, const double a[2], const double b[2]) {
    int64_t from[2], to[2];
    for (int c = 0; c < 2; c++) {
        from[c] = (int64_t)rint(a[c] * 0x1p32);
        to[c] = (int64_t)rint(b[c] * 0x1p32);
    }
    for (int k = 1; k < line->points; k++)
        if (segments_meet(line->point[k - 1], line->point[k], from, to)) return 1;
    return 0;
}

/* Whether the bond from a to b, which lies in the quadrilateral's plane, has a part inside: it is clipped by one side
 * after another. */
static int in_plane(const double (*corner)[3], const double normal[3], const double a[3], const double b[3],
                    double tolerance) {
    double from = 0, to = 1;
    for (int k = 0; k < 4; k++) {
        const double at_a = inner_side(corner, k, normal, a) + tolerance,
                     at_b = inner_side(corner, k, normal, b) + tolerance;
        if (at_a < 0 && at_b < 0) return 0;
        if (at_a < 0) from = fmax(from, at_a / (at_a - at_b));
        if (at_b < 0) to = fmin(to, at_a / (at_a - at_b));
    }
    return from <= to;
}

int solid_cut_plane_crosses(const double (*corner)[3], const double first[3], const double second[3], double spacing) {
    double normal[3], to[3], away[2], x[3];
    const double tolerance = SOLID_ON_SURFACE * spacing;
    int c = 0;
    normal_of(corner, normal);
    while (c < 2 && first[c] == second[c]) c++;
    const int swap = first[c] > second[c];
    const double *end[2] = {swap ? second : first, swap ? first : second};
    for (int k = 0; k < 2; k++) {
        minus(end[k], corner[0], to);
        away[k] = dot(to, normal);
        if (fabs(away[k]) <= tolerance) away[k] = 0;
    }
    if (away[0] == 0 && away[1] == 0) return in_plane(corner, normal, end[0], end[1], tolerance);
    if (away[0] * away[1] > 0) return 0;
    const double fraction = away[0] / (away[0] - away[1]);
    for (c = 0; c < 3; c++) x[c] = end[0][c] + fraction * (end[1][c] - end[0][c]);
    for (int k = 0; k < 4; k++)
        if (inner_side(corner, k, normal, x) < -tolerance) return 0;
    return 1;
}
