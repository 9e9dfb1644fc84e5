/* One edge of an outline, straight or an arc: points, parts, monotone pieces, distance, length, area integral. */
#include "solid/geometry/outline_edge.h"

#include <math.h>

static const long double PI = 3.14159265358979323846264338327950288L;

static double rounded(long double x) { return (double)(rintl(x * 0x1p48L) * 0x1p-48L); }

static double between(double x, double a, double b) { return fmin(fmax(x, fmin(a, b)), fmax(a, b)); }

/* The angle from one direction to another in the sense of turn, in [0, 2 pi). */
static long double angle(long double from, long double to, int turn) {
    const long double d = fmodl(turn * (to - from), 2 * PI);
    return d < 0 ? d + 2 * PI : d;
}

static long double direction(const struct solid_outline_edge *e, const double x[2]) {
    return atan2l(x[1] - e->centre[1], x[0] - e->centre[0]);
}

struct solid_outline_edge solid_outline_edge_straight(const double a[2], const double b[2]) {
    return (struct solid_outline_edge){.a = {a[0], a[1]}, .b = {b[0], b[1]}};
}

struct solid_outline_edge solid_outline_edge(const struct solid_outline *o, int k, const double origin[2],
                                             double spacing) {
    const int next = k + 1 < o->corners ? k + 1 : 0;
    struct solid_outline_edge e = {.turn = o->turn ? o->turn[k] : 0};
    for (int c = 0; c < 2; c++) {
        e.a[c] = rounded(((long double)o->corner[k][c] - origin[c]) / spacing);
        e.b[c] = rounded(((long double)o->corner[next][c] - origin[c]) / spacing);
    }
    if (!e.turn) return e;
    long double along = 0, chord2 = 0;
    for (int c = 0; c < 2; c++) {
        const long double d = (long double)e.b[c] - e.a[c];
        e.centre[c] = ((long double)o->centre[k][c] - origin[c]) / spacing;
        along += (e.centre[c] - ((long double)e.a[c] + e.b[c]) / 2) * d;
        chord2 += d * d;
    }
    for (int c = 0; c < 2; c++) e.centre[c] -= along / chord2 * ((long double)e.b[c] - e.a[c]);
    e.radius = hypotl(e.a[0] - e.centre[0], e.a[1] - e.centre[1]);
    e.start = direction(&e, e.a);
    e.sweep = angle(e.start, direction(&e, e.b), e.turn);
    return e;
}

void solid_outline_edge_point(const struct solid_outline_edge *e, long double fraction, double x[2]) {
    const long double at = e->start + e->turn * fraction * e->sweep;
    for (int c = 0; c < 2; c++)
        x[c] = fraction == 0   ? e->a[c]
               : fraction == 1 ? e->b[c]
               : !e->turn      ? rounded(e->a[c] + fraction * ((long double)e->b[c] - e->a[c]))
                               : rounded(e->centre[c] + e->radius * (c ? sinl(at) : cosl(at)));
}

struct solid_outline_edge solid_outline_edge_part(const struct solid_outline_edge *e, long double from,
                                                  long double to) {
    struct solid_outline_edge part = *e;
    solid_outline_edge_point(e, from, part.a);
    solid_outline_edge_point(e, to, part.b);
    part.start = e->start + e->turn * from * e->sweep;
    part.sweep = (to - from) * e->sweep;
    return part;
}

/* An arc is divided at the multiples of a quarter turn, where x or y is extreme. */
int solid_outline_edge_split(const struct solid_outline_edge *e,
                             struct solid_outline_edge piece[SOLID_OUTLINE_PIECES]) {
    if (!e->turn) {
        piece[0] = *e;
        return 1;
    }
    const long double quarter = PI / 2, tiny = 1e-12L, position = e->turn * e->start / quarter;
    long double next = (floorl(position + tiny) + 1 - position) * quarter / e->sweep, from = 0;
    int n = 0;
    while (from < 1) {
        const long double to = next < 1 - tiny ? next : 1;
        struct solid_outline_edge *p = &piece[n++];
        *p = solid_outline_edge_part(e, from, to);
        const long double middle = p->start + p->turn * p->sweep / 2;
        p->side[0] = cosl(middle) < 0 ? -1 : 1;
        p->side[1] = sinl(middle) < 0 ? -1 : 1;
        from = to;
        next += quarter / e->sweep;
    }
    return n;
}

int solid_outline_edge_pieces(const struct solid_outline *o, int k, const double origin[2], double spacing,
                              struct solid_outline_edge piece[SOLID_OUTLINE_PIECES]) {
    const struct solid_outline_edge e = solid_outline_edge(o, k, origin, spacing);
    return solid_outline_edge_split(&e, piece);
}

long double solid_outline_edge_fraction(const struct solid_outline_edge *e, const double x[2]) {
    if (e->turn) {
        const long double on = angle(e->start, direction(e, x), e->turn);
        return (on > e->sweep / 2 + PI ? on - 2 * PI : on) / e->sweep;
    }
    long double along = 0, length2 = 0;
    for (int c = 0; c < 2; c++) {
        const long double d = (long double)e->b[c] - e->a[c];
        along += ((long double)x[c] - e->a[c]) * d;
        length2 += d * d;
    }
    return length2 > 0 ? along / length2 : 0;
}

double solid_outline_edge_distance(const struct solid_outline_edge *e, const double x[2]) {
    const long double f = solid_outline_edge_fraction(e, x);
    if (f <= 0) return hypot(x[0] - e->a[0], x[1] - e->a[1]);
    if (f >= 1) return hypot(x[0] - e->b[0], x[1] - e->b[1]);
    if (e->turn) return (double)fabsl(hypotl(x[0] - e->centre[0], x[1] - e->centre[1]) - e->radius);
    const long double dx = (long double)e->b[0] - e->a[0], dy = (long double)e->b[1] - e->a[1];
    return (double)(fabsl(dx * (x[1] - e->a[1]) - dy * (x[0] - e->a[0])) / hypotl(dx, dy));
}

double solid_outline_edge_at(const struct solid_outline_edge *piece, int c, double value) {
    const int o = 1 - c;
    long double x;
    if (piece->turn) {
        const long double d = value - piece->centre[c], rest = (piece->radius - d) * (piece->radius + d);
        x = piece->centre[o] + piece->side[o] * sqrtl(fmaxl(rest, 0));
    } else {
        const long double rise = (long double)piece->b[c] - piece->a[c];
        x = piece->a[o] +
            ((long double)piece->b[o] - piece->a[o]) * (rise == 0 ? 0 : ((long double)value - piece->a[c]) / rise);
    }
    return between(rounded(x), piece->a[o], piece->b[o]);
}

/* The angle of the arc above a chord, at most a quarter turn. */
static double spanned(const struct solid_outline_edge *piece, const double from[2], const double to[2]) {
    return 2 * asin(fmin(hypot(to[0] - from[0], to[1] - from[1]) / (2 * (double)piece->radius), 1));
}

double solid_outline_edge_length(const struct solid_outline_edge *piece, const double from[2], const double to[2]) {
    return piece->turn ? (double)piece->radius * spanned(piece, from, to) : hypot(to[0] - from[0], to[1] - from[1]);
}

/* t - sin t without cancellation. */
static double minus_sine(double t) {
    const double t2 = t * t;
    if (t > 0.3) return t - sin(t);
    return t * t2 / 6 * (1 - t2 / 20 * (1 - t2 / 42 * (1 - t2 / 72 * (1 - t2 / 110))));
}

/* The area under the chord, and the area between chord and arc. */
double solid_outline_edge_integral(const struct solid_outline_edge *piece, const double from[2], const double to[2],
                                   double x0) {
    const double chord = 0.5 * ((from[0] - x0) + (to[0] - x0)) * (to[1] - from[1]);
    if (!piece->turn) return chord;
    const double radius = (double)piece->radius;
    return chord + piece->turn * 0.5 * radius * radius * minus_sine(spanned(piece, from, to));
}
