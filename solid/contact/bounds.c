/* Bounds of the bodies' positions and displacements, and whether anything could touch within them. */
#include "base/par.h"
#include "solid/contact/list.h"
#include "solid/geometry/shape.h"

#include <math.h>

enum { VALUES = sizeof(solid_contact_bounds) / sizeof(double) };

static void range(int from, int to, const double *restrict x0, const double *restrict d, double out[4]) {
    double x_low = INFINITY, x_high = -INFINITY, d_low = INFINITY, d_high = -INFINITY;
    for (int h = from; h < to; h++) {
        const double x = x0[h] + d[h];
        x_low = x < x_low ? x : x_low;
        x_high = x > x_high ? x : x_high;
        d_low = d[h] < d_low ? d[h] : d_low;
        d_high = d[h] > d_high ? d[h] : d_high;
    }
    out[0] = x_low, out[1] = -x_high, out[2] = d_low, out[3] = -d_high;
}

void solid_contact_bounds_of(const struct solid *s, solid_contact_bounds *bounds) {
    for (int b = 0; b < s->in.bodies; b++)
        for (int k = 0; k < VALUES; k++) bounds[b][k] = INFINITY;
    for (int from = 0, to; from < s->n; from = to) { /* the particles of a body are contiguous */
        double *b = bounds[s->body[from]];
        unsigned flags = 0;
        for (to = from; to < s->n && s->body[to] == s->body[from]; to++) flags |= s->flag[to];
        if (flags & SOLID_BROKEN) b[12] = 0;
        if (flags & (SOLID_HELD_X | SOLID_HELD_Y | SOLID_HELD_Z)) b[13] = 0;
        for (int k = 0; k < 4; k++) b[3 * k + 2] = 0; /* in a plate */
        for (int c = 0; c < s->dim; c++) {
            double out[4];
            range(from, to, s->x0[c], s->d[c], out);
            for (int k = 0; k < 4; k++) b[3 * k + c] = out[k];
        }
    }
    par_min_array(&bounds[0][0], VALUES * s->in.bodies);
}

int solid_contact_bounds_near(const struct solid *s, const double *a, const double *b, double reach) {
    for (int c = 0; c < 3; c++) {
        const double extent = -a[3 + c] - a[c] - b[3 + c] - b[c]; /* extent of both bodies together */
        const double separation = fabs(solid_shortest(s, c, 0.5 * (a[c] - a[3 + c]) - 0.5 * (b[c] - b[3 + c])));
        if (!(separation - 0.5 * extent <= reach)) return 0;
    }
    return 1;
}

double solid_contact_bounds_least_unbonded(const struct solid *s, int body) {
    const struct solid_body *b = &s->in.body[body];
    /* on a lattice a family is |xi| < delta + spacing/2; in a plate at least that */
    return b->least_horizon + (solid_shape_of(b)->places == SOLID_PLACES_POINTS ? 0 : 0.5) * s->in.spacing;
}

int solid_contact_bounds_touch(const struct solid *s, const solid_contact_bounds *bounds, double reach) {
    for (int b = 0; b < s->in.bodies; b++) {
        double spread = 0;
        for (int c = 0; c < 3; c++) spread = hypot(spread, -bounds[b][9 + c] - bounds[b][6 + c]);
        if (bounds[b][12] == 0 || spread > solid_contact_bounds_least_unbonded(s, b) - reach) return 1;
        for (int other = 0; other < b; other++)
            if (solid_contact_bounds_near(s, bounds[b], bounds[other], reach)) return 1;
    }
    return 0;
}
