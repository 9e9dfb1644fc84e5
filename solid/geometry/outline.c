/* Area, bounds and point membership of a plate's outline, and the length of a crack inside it. */
#include "solid/geometry/outline.h"
#include "base/memory.h"
#include "base/sort.h"
#include "solid/geometry/on_surface.h"
#include "solid/geometry/outline_edge.h"

#include <math.h>

/* A unit so small that rounding to multiples of 2^-48 of it has no effect. */
static double fine_unit(const struct solid_outline *o) {
    double extent = 0;
    for (int k = 1; k < o->corners; k++)
        extent = fmax(extent, hypot(o->corner[k][0] - o->corner[0][0], o->corner[k][1] - o->corner[0][1]));
    return extent > 0 ? extent * 0x1p-16 : 1;
}

/* Signed area, m2: positive if the corners run counterclockwise. */
static double signed_area(const struct solid_outline *o) {
    const double unit = fine_unit(o);
    long double sum = 0;
    for (int k = 0; k < o->corners; k++) {
        struct solid_outline_edge piece[SOLID_OUTLINE_PIECES];
        const int pieces = solid_outline_edge_pieces(o, k, o->corner[0], unit, piece);
        for (int p = 0; p < pieces; p++) sum += solid_outline_edge_integral(&piece[p], piece[p].a, piece[p].b, 0);
    }
    return (double)sum * unit * unit;
}

int solid_outline_sense(const struct solid_outline *o) { return (signed_area(o) > 0) != (o->is_hole != 0) ? 1 : -1; }

double solid_outline_area(const struct solid_outline *outline, int n) {
    double area = 0;
    for (int l = 0; l < n; l++) area += (outline[l].is_hole ? -1 : 1) * fabs(signed_area(&outline[l]));
    return area;
}

void solid_outline_bounds(const struct solid_outline *outline, int n, double low[2], double high[2]) {
    for (int c = 0; c < 2; c++) {
        low[c] = INFINITY;
        high[c] = -INFINITY;
    }
    for (int l = 0; l < n; l++) {
        const double unit = fine_unit(&outline[l]), *origin = outline[l].corner[0];
        for (int k = 0; k < outline[l].corners; k++) {
            struct solid_outline_edge piece[SOLID_OUTLINE_PIECES];
            const int pieces = solid_outline_edge_pieces(&outline[l], k, origin, unit, piece);
            for (int p = 0; p < pieces; p++)
                for (int c = 0; c < 2; c++) {
                    const double x = p == 0 ? outline[l].corner[k][c] : origin[c] + unit * piece[p].a[c];
                    low[c] = fmin(low[c], x);
                    high[c] = fmax(high[c], x);
                }
        }
    }
}

/* Counts the edges that a ray from x to the right crosses. */
int solid_outline_parity(const struct solid_outline *outline, int n, const double x[2], double spacing) {
    int odd = 0;
    for (int l = 0; l < n; l++)
        for (int k = 0; k < outline[l].corners; k++) {
            struct solid_outline_edge piece[SOLID_OUTLINE_PIECES];
            const int pieces = solid_outline_edge_pieces(&outline[l], k, x, spacing, piece);
            for (int p = 0; p < pieces; p++)
                if ((piece[p].a[1] <= 0) != (piece[p].b[1] <= 0) && solid_outline_edge_at(&piece[p], 1, 0) > 0)
                    odd ^= 1;
        }
    return odd;
}

int solid_outline_contains(const struct solid_outline *outline, int n, const double x[2], double spacing) {
    const double here[2] = {0, 0};
    for (int l = 0; l < n; l++)
        for (int k = 0; k < outline[l].corners; k++) {
            const struct solid_outline_edge e = solid_outline_edge(&outline[l], k, x, spacing);
            if (solid_on_surface_is_on(solid_outline_edge_distance(&e, here), 1)) return 1;
        }
    return solid_outline_parity(outline, n, x, spacing);
}

/* Green's theorem: the area is the integral of clamp(x, 0, 1) dy over the boundary within 0 <= y <= 1. */
double solid_outline_area_in(const struct solid_outline *outline, int n, const double centre[2], double side) {
    const double origin[2] = {centre[0] - side / 2, centre[1] - side / 2};
    const int low[2] = {0, 0}, high[2] = {1, 1};
    double area = 0;
    for (int l = 0; l < n; l++) {
        const int sense = solid_outline_sense(&outline[l]);
        for (int k = 0; k < outline[l].corners; k++) {
            struct solid_outline_edge piece[SOLID_OUTLINE_PIECES];
            const int pieces = solid_outline_edge_pieces(&outline[l], k, origin, side, piece);
            for (int p = 0; p < pieces; p++) {
                struct solid_outline_walk w = solid_outline_walk_begin(&piece[p], low, high);
                while (solid_outline_walk_next(&w)) {
                    if (w.cell[1] != 0 || w.cell[0] < 0) continue;
                    area += sense * (w.cell[0] > 0 ? w.to[1] - w.from[1]
                                                   : solid_outline_edge_integral(&piece[p], w.from, w.to, 0));
                }
            }
        }
    }
    return area * side * side;
}

/* The segment is divided where it meets the outlines; each part is inside or outside as its midpoint is. */
static double inside_of_segment(const struct solid_outline *outline, int n, const double a[2], const double b[2],
                                double spacing, double *at) {
    const double length = hypot(b[0] - a[0], b[1] - a[1]), nothing[2] = {0, 0};
    const double end[2] = {(b[0] - a[0]) / spacing, (b[1] - a[1]) / spacing};
    const struct solid_outline_edge segment = solid_outline_edge_straight(nothing, end);
    int cuts = 0;
    at[cuts++] = 0;
    at[cuts++] = 1;
    for (int l = 0; l < n; l++)
        for (int k = 0; k < outline[l].corners; k++) {
            const struct solid_outline_edge e = solid_outline_edge(&outline[l], k, a, spacing);
            double point[8][2];
            const int points = solid_outline_meet(&segment, &e, 1e-9, point);
            for (int p = 0; p < points; p++) {
                const double fraction = (double)solid_outline_edge_fraction(&segment, point[p]);
                at[cuts++] = fmin(fmax(fraction, 0), 1);
            }
        }
    sort_ascending(at, (size_t)cuts);
    double inside = 0;
    for (int k = 1; k < cuts; k++) {
        const double middle = 0.5 * (at[k - 1] + at[k]);
        const double x[2] = {a[0] + middle * (b[0] - a[0]), a[1] + middle * (b[1] - a[1])};
        if (at[k] > at[k - 1] && solid_outline_contains(outline, n, x, spacing)) inside += at[k] - at[k - 1];
    }
    return inside * length;
}

double solid_outline_length_inside(const struct solid_outline *outline, int n, const struct solid_cut *cut,
                                   double spacing) {
    size_t capacity = 2;
    double length = 0;
    for (int l = 0; l < n; l++) capacity += 8 * (size_t)outline[l].corners;
    double *work = memory_new(MEMORY_SOLID, capacity, sizeof *work);
    for (int k = 1; k < cut->points; k++)
        length += inside_of_segment(outline, n, cut->point[k - 1], cut->point[k], spacing, work);
    memory_free(work);
    return length;
}
