/* Plates for the tests of their geometry, and the formulae they are held against. */
#pragma once
#include "solid/geometry/outline.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SHAPE_CORNERS = 64, SHAPE_OUTLINES = 6 };

struct shape {
    int n;
    struct solid_outline outline[SHAPE_OUTLINES];
    double corner[SHAPE_OUTLINES][SHAPE_CORNERS][2], centre[SHAPE_OUTLINES][SHAPE_CORNERS][2];
    signed char turn[SHAPE_OUTLINES][SHAPE_CORNERS];
};

static inline double uniform(double low, double high) { return low + (high - low) * rand() / RAND_MAX; }

static inline void shape_outline(struct shape *s, int is_hole) {
    const int l = s->n++;
    s->outline[l] = (struct solid_outline){is_hole, 0, s->corner[l], s->centre[l], s->turn[l]};
}

static inline void shape_corner(struct shape *s, double x, double y) {
    const int l = s->n - 1, k = s->outline[l].corners++;
    s->corner[l][k][0] = x;
    s->corner[l][k][1] = y;
    s->turn[l][k] = 0;
}

/* The edge from the last corner is an arc. */
static inline void shape_arc(struct shape *s, double x, double y, int turn) {
    const int l = s->n - 1, k = s->outline[l].corners - 1;
    s->centre[l][k][0] = x;
    s->centre[l][k][1] = y;
    s->turn[l][k] = (signed char)turn;
}

static inline void shape_box(struct shape *s, int is_hole, double x0, double y0, double x1, double y1) {
    shape_outline(s, is_hole);
    shape_corner(s, x0, y0);
    shape_corner(s, x1, y0);
    shape_corner(s, x1, y1);
    shape_corner(s, x0, y1);
}

static inline void shape_disc(struct shape *s, int is_hole, double x, double y, double r, int turn) {
    shape_outline(s, is_hole);
    shape_corner(s, x - r, y);
    shape_arc(s, x, y, turn);
    shape_corner(s, x + r, y);
    shape_arc(s, x, y, turn);
}

/* Corners in all directions from the middle, near and far in turn at random: very concave. Some edges are arcs. */
static inline void shape_star(struct shape *s, int is_hole, double x, double y, double r, int corners, int arcs) {
    shape_outline(s, is_hole);
    const double turned = uniform(0, 1);
    const int l = s->n - 1;
    for (int k = 0; k < corners; k++) {
        const double a = 2 * M_PI * (k + turned) / corners, far = r * uniform(0.2, 1);
        shape_corner(s, x + far * cos(a), y + far * sin(a));
    }
    for (int k = 0; k < corners; k++) {
        if (!arcs || uniform(0, 1) < 0.5) continue;
        const double *a = s->corner[l][k], *b = s->corner[l][(k + 1) % corners];
        const double chord[2] = {b[0] - a[0], b[1] - a[1]}, off = uniform(1, 4);
        const int turn = uniform(-1, 1) < 0 ? -1 : 1;
        s->turn[l][k] = (signed char)turn; /* the centre left of the chord, where a minor arc turns left */
        s->centre[l][k][0] = (a[0] + b[0]) / 2 - turn * off * chord[1];
        s->centre[l][k][1] = (a[1] + b[1]) / 2 + turn * off * chord[0];
    }
}

static inline void shape_comb(struct shape *s, int teeth, double width, double gap, double height) {
    shape_outline(s, 0);
    shape_corner(s, 0, 0);
    shape_corner(s, teeth * (width + gap), 0);
    for (int k = teeth - 1; k >= 0; k--) {
        const double from = k * (width + gap);
        shape_corner(s, from + width + gap, 0.1 * height);
        shape_corner(s, from + width, 0.1 * height);
        shape_corner(s, from + width * 0.9, height);
        shape_corner(s, from + width * 0.1, height);
    }
}

/* Shoelace formula and, for every arc, the segment between it and its chord: r^2/2 (phi - sin phi). */
static inline double shape_area(const struct shape *s) {
    long double total = 0;
    for (int l = 0; l < s->n; l++) {
        const int n = s->outline[l].corners;
        const double *o = s->corner[l][0];
        long double sum = 0;
        for (int k = 0; k < n; k++) {
            const double *a = s->corner[l][k], *b = s->corner[l][(k + 1) % n], *c = s->centre[l][k];
            sum += (((long double)a[0] - o[0]) * ((long double)b[1] - o[1]) -
                    ((long double)b[0] - o[0]) * ((long double)a[1] - o[1])) /
                   2;
            if (!s->turn[l][k]) continue;
            const long double radius = hypotl((long double)a[0] - c[0], (long double)a[1] - c[1]);
            const long double cross = ((long double)a[0] - c[0]) * ((long double)b[1] - c[1]) -
                                      ((long double)a[1] - c[1]) * ((long double)b[0] - c[0]);
            const long double dot = ((long double)a[0] - c[0]) * ((long double)b[0] - c[0]) +
                                    ((long double)a[1] - c[1]) * ((long double)b[1] - c[1]);
            long double phi = s->turn[l][k] * atan2l(cross, dot);
            if (phi <= 0) phi += 2 * acosl(-1);
            sum += s->turn[l][k] * radius * radius / 2 * (phi - sinl(phi));
        }
        total += (s->outline[l].is_hole ? -1 : 1) * fabsl(sum);
    }
    return (double)total;
}

/* A body of one outline with straight edges. */
static inline void shape_polygon(struct shape *s, int n, const double (*corner)[2]) {
    s->n = 0;
    memset(s->turn, 0, sizeof s->turn);
    shape_outline(s, 0);
    for (int k = 0; k < n; k++) shape_corner(s, corner[k][0], corner[k][1]);
}
