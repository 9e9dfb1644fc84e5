/* Interpolates displacement and velocity of a new particle from its neighbours.  (000: eq. 37, sec. 2.1.3) */
#include "solid/refine/places.h"
#include "solid/refine/plan.h"

/* A new particle's value is interpolated from the eight neighbouring positions of the coarser lattice: the mean of two
 * neighbours on an edge's midpoint; in a cell's middle the mean of four, or of two opposite ones if another is missing.
 * At an edge of the body it is extrapolated with the next particle behind. Sums are of two pairs that are mirror images
 * of each other. */
static void source_add(struct solid_refine_interpolated *b, int k, long source, double weight) {
    b->source[k] = source;
    b->weight[k] = weight;
}

static void midway(const struct solid_refine_plan *p, struct solid_refine_interpolated *b, const int at[2], int dx,
                   int dy) {
    const long one = solid_refine_places_at(p, at[0] - dx, at[1] - dy),
               two = solid_refine_places_at(p, at[0] + dx, at[1] + dy);
    if (one >= 0 && two >= 0) {
        source_add(b, 0, one, 0.5);
        source_add(b, 2, two, 0.5);
        return;
    }
    const int side = one >= 0 ? -1 : 1;
    const long behind = solid_refine_places_at(p, at[0] + 3 * side * dx, at[1] + 3 * side * dy);
    source_add(b, 0, one >= 0 ? one : two, behind >= 0 ? 1.5 : 1);
    if (behind >= 0) source_add(b, 1, behind, -0.5);
}

static long corner(const struct solid_refine_plan *p, const int at[2], int h, int x, int y) {
    return solid_refine_places_at(p, at[0] + x * h, at[1] + y * h);
}

/* The edge of the body runs along one direction (dx, dy): there are two particles on this side of it, at (sx, sy) from
 * the middle of the four. */
static void at_edge(const struct solid_refine_plan *p, struct solid_refine_interpolated *b, const int at[2], int h,
                    int along, int side) {
    for (int k = 0; k < 2; k++) {
        const int s = 2 * k - 1;
        const long here = along == 0 ? corner(p, at, h, s, side) : corner(p, at, h, side, s),
                   behind = along == 0 ? corner(p, at, h, s, 3 * side) : corner(p, at, h, 3 * side, s);
        source_add(b, 2 * k, here, behind >= 0 ? 0.75 : 0.5);
        if (behind >= 0) source_add(b, 2 * k + 1, behind, -0.25);
    }
}

static void at_corner(const struct solid_refine_plan *p, struct solid_refine_interpolated *b, const int at[2], int h,
                      int x, int y) {
    const long here = corner(p, at, h, x, y), beside[2] = {corner(p, at, h, 3 * x, y), corner(p, at, h, x, 3 * y)};
    source_add(b, 0, here, 1 + 0.5 * (beside[0] >= 0) + 0.5 * (beside[1] >= 0));
    for (int k = 0; k < 2; k++)
        if (beside[k] >= 0) source_add(b, 1 + k, beside[k], -0.5);
}

static void amid(const struct solid_refine_plan *p, struct solid_refine_interpolated *b, const int at[2], int h) {
    long q[2][2];
    int there = 0;
    for (int k = 0; k < 4; k++) there += (q[k / 2][k % 2] = corner(p, at, h, 2 * (k % 2) - 1, 2 * (k / 2) - 1)) >= 0;
    if (there == 4) {
        source_add(b, 0, q[0][0], 0.25);
        source_add(b, 1, q[1][1], 0.25);
        source_add(b, 2, q[0][1], 0.25);
        source_add(b, 3, q[1][0], 0.25);
        return;
    }
    for (int k = 0; k < 2; k++)
        if (q[0][k] >= 0 && q[1][1 - k] >= 0) {
            source_add(b, 0, q[0][k], 0.5);
            source_add(b, 2, q[1][1 - k], 0.5);
            return;
        }
    for (int side = 0; side < 2; side++) {
        if (q[side][0] >= 0 && q[side][1] >= 0) at_edge(p, b, at, h, 0, 2 * side - 1);
        if (q[0][side] >= 0 && q[1][side] >= 0) at_edge(p, b, at, h, 1, 2 * side - 1);
    }
    for (int k = 0; k < 4 && there == 1; k++)
        if (q[k / 2][k % 2] >= 0) at_corner(p, b, at, h, 2 * (k % 2) - 1, 2 * (k / 2) - 1);
}

/* For a position of the level's lattice that is not on the lattice of the level above; h is half the spacing of that
 * one. */
struct solid_refine_interpolated solid_refine_interpolate_at(const struct solid_refine_plan *p, const int at[2],
                                                             int level) {
    struct solid_refine_interpolated b = {0};
    const int h = solid_refine_plan_spacing(level), shift = level == 1 ? h : 0;
    const int odd[2] = {(at[0] + shift) / h & 1, (at[1] + shift) / h & 1};
    if (odd[0] && odd[1])
        amid(p, &b, at, h);
    else
        midway(p, &b, at, odd[0] * h, odd[1] * h);
    for (int k = 0; k < 9; k++) {
        if ((k % 3 != 1) != odd[0] || (k / 3 != 1) != odd[1]) continue;
        const long parent = solid_refine_places_at(p, at[0] + (k % 3 - 1) * h, at[1] + (k / 3 - 1) * h);
        if (parent >= 0) b.parent[b.parents++] = parent;
    }
    return b;
}
