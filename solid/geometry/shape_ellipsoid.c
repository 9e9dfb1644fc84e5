/* Ellipsoid with axes along x, y and z, or turned. */
#include "solid/geometry/shape.h"
#include "solid/geometry/turn.h"

#include <math.h>
#include <string.h>

enum { ROUNDS = 200 };

static void bounds(const struct solid_body *body, double low[3], double high[3]) {
    double centre[3];
    solid_turn_place_out(&body->turn, body->centre, centre);
    for (int c = 0; c < 3; c++) {
        double half = body->radii[c], sum = 0;
        for (int k = 0; k < 3; k++)
            sum += body->turn.edge[k][c] * body->turn.edge[k][c] * (body->radii[k] * body->radii[k]);
        if (body->turn.is_turned) half = sqrt(sum);
        low[c] = centre[c] - half;
        high[c] = centre[c] + half;
    }
}

/* x - centre along the ellipsoid's axes. */
static void from_centre(const struct solid_piece *p, const double x[3], double y[3]) {
    for (int c = 0; c < 3; c++) y[c] = x[c] - p->centre[c];
    if (!p->turn) return;
    const double v[3] = {y[0], y[1], y[2]};
    solid_turn_into(p->turn, v, y);
}

/* q = n/(r - 1 + u), the nearest point over the radii; returns |q|^2. */
static double nearest(const double n[3], const double r[3], double u, double q[3]) {
    double sum = 0;
    for (int c = 0; c < 3; c++) {
        q[c] = n[c] > 0 ? n[c] / (r[c] - 1 + u) : 0;
        sum += q[c] * q[c];
    }
    return sum;
}

/* The root u > 0 of |q(u)| = 1, which falls with u, from least, which is n of the shortest radius; 0 where there is
 * none. Halves the interval, by its ratio while that is large, until no number is left between its ends. */
static double root_of(const double n[3], const double r[3], double least) {
    double low = least, high = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]), q[3];
    if (least == 0 && nearest(n, r, 0, q) <= 1) return 0;
    for (int k = 0; k < ROUNDS; k++) {
        const double u = low > 0 && high > 4 * low ? sqrt(low) * sqrt(high) : 0.5 * (low + high);
        if (u <= low || u >= high) break;
        if (nearest(n, r, u, q) > 1)
            low = u;
        else
            high = u;
    }
    return 0.5 * (low + high);
}

/* The nearest point p of the ellipsoid has y - p = t p/e^2 for some t, e the radii, y = |x - centre|: p = e q with
 * q = e y/(t + e^2) and |q| = 1. In units of the shortest radius m, r = (e/m)^2, n = e y/m^2, u = 1 + t/m^2, the root
 * is between n of that radius and |n|  (Eberly 2013: Distance from a point to an ellipse, an ellipsoid, or a
 * hyperellipsoid). In the middle plane of the shortest radius there may be no root: u = 0, and q of that radius follows
 * from |q| = 1. The depth is -t |q/e|. */
static double depth(const struct solid_piece *p, const double x[3], double normal[3]) {
    const double *e = p->radii;
    double n[3], r[3], q[3], y[3], steep = 0;
    int m = 0;
    from_centre(p, x, y);
    for (int c = 1; c < 3; c++)
        if (e[c] < e[m]) m = c;
    for (int c = 0; c < 3; c++) {
        r[c] = (e[c] / e[m]) * (e[c] / e[m]);
        n[c] = e[c] / e[m] * (fabs(y[c]) / e[m]);
    }
    const double u = root_of(n, r, n[m]);
    const double others = nearest(n, r, u, q);
    if (u == 0) q[m] = sqrt(1 - others);
    for (int c = 0; c < 3; c++) {
        normal[c] = q[c] / e[c];
        steep += normal[c] * normal[c];
    }
    steep = sqrt(steep);
    for (int c = 0; c < 3; c++) normal[c] *= p->inside * (y[c] < 0 ? -1 : 1) / steep;
    if (p->turn) {
        const double own[3] = {normal[0], normal[1], normal[2]};
        solid_turn_out(p->turn, own, normal);
    }
    return p->inside * (1 - u) * e[m] * e[m] * steep;
}

/* The level |(x - centre)/e| falls or rises by at most 1 in the shortest radius. */
static double least(const struct solid_piece *p, const double x[3]) {
    double level2 = 0, y[3];
    from_centre(p, x, y);
    for (int c = 0; c < 3; c++) {
        const double q = y[c] / p->radii[c];
        level2 += q * q;
    }
    return p->inside * (1 - sqrt(level2)) * fmin(fmin(p->radii[0], p->radii[1]), p->radii[2]);
}

/* Of the level set q = sum (y/e)^2 = 1, with the gradient 2 n/w, w = |(e n)|, and the Hessian 2/e^2: half the
 * divergence of n is (w/2) sum (1 - n^2)/e^2. */
static double curvature(const struct solid_piece *p, const double normal[3]) {
    double w2 = 0, sum = 0, n[3] = {normal[0], normal[1], normal[2]};
    if (p->turn) solid_turn_into(p->turn, normal, n);
    for (int c = 0; c < 3; c++) {
        w2 += n[c] * n[c] * p->radii[c] * p->radii[c];
        sum += (1 - n[c] * n[c]) / (p->radii[c] * p->radii[c]);
    }
    return p->inside * 0.5 * sqrt(w2) * sum;
}

static int pieces(const struct solid_body *body, struct solid_piece piece[SOLID_PIECES_MAX]) {
    piece[0] = (struct solid_piece){.depth = depth, .least = least, .curvature = curvature, .inside = 1};
    memcpy(piece[0].centre, body->centre, sizeof piece[0].centre);
    memcpy(piece[0].radii, body->radii, sizeof piece[0].radii);
    solid_piece_turn(&piece[0], &body->turn);
    return 1;
}

const struct solid_shape_kind solid_shape_ellipsoid = {
    .name = "ellipsoid", .places = SOLID_PLACES_LATTICE, .bounds = bounds, .pieces = pieces};
