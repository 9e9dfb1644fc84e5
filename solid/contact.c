#include "solid/contact.h"

#include "base/clock.h"
#include "base/memory.h"
#include "base/par.h"
#include "base/par_exchange.h"
#include "solid/contact_list.h"
#include "solid/surface_lost.h"

#include <math.h>
#include <stdlib.h>

static const double skin = 0.5, rebuild = 0.2; /* spacings */
enum { BODIES = 256 };                         /* solid.body is a byte */

/* Of each body, lowest and negated highest: positions (0-5), displacements (6-11); and whether a bond has broken (12). */
static void bounds(const struct solid *s, double (*of)[13]) {
    for (int b = 0; b < s->in.bodies; b++)
        for (int k = 0; k < 13; k++) of[b][k] = INFINITY;
    for (int from = 0, to; from < s->n; from = to) { /* a body's particles follow one another */
        double *b = of[s->body[from]];
        unsigned flags = 0;
        for (to = from; to < s->n && s->body[to] == s->body[from]; to++) flags |= s->flag[to];
        if (flags & SOLID_BROKEN) b[12] = 0;
        for (int c = 0; c < 3; c++) {
            double x_low = INFINITY, x_high = -INFINITY, d_low = INFINITY, d_high = -INFINITY;
            for (int h = from; h < to; h++) {
                const double d = s->d[c][h], x = s->x0[c][h] + d;
                x_low = x < x_low ? x : x_low;
                x_high = x > x_high ? x : x_high;
                d_low = d < d_low ? d : d_low;
                d_high = d > d_high ? d : d_high;
            }
            b[c] = x_low;
            b[3 + c] = -x_high;
            b[6 + c] = d_low;
            b[9 + c] = -d_high;
        }
    }
    par_min_array(&of[0][0], 13 * s->in.bodies);
}

static int are_near(const struct solid *s, const double *a, const double *b, double reach) {
    for (int c = 0; c < 3; c++) {
        const double extent = -a[3 + c] - a[c] - b[3 + c] - b[c]; /* of both together */
        double apart = fabs(0.5 * (a[c] - a[3 + c]) - 0.5 * (b[c] - b[3 + c]));
        if (s->in.periodic[c]) apart = fabs(apart - s->in.length[c] * rint(apart / s->in.length[c]));
        if (apart - 0.5 * extent > reach) return 0;
    }
    return 1;
}

/* A bond has broken; or two bodies' bounds are within r_c and the skin; or a body is so deformed that two particles that
 * are not of one family, which started delta + spacing/2 apart or more, might be. Collective. */
static int could_touch(const struct solid *s, double reach) {
    double of[BODIES][13];
    bounds(s, of);
    for (int b = 0; b < s->in.bodies; b++) {
        const double ratio = s->in.material[s->in.body[b].material].horizon_ratio;
        double spread = 0;
        for (int c = 0; c < 3; c++) spread = hypot(spread, -of[b][9 + c] - of[b][6 + c]);
        if (of[b][12] == 0 || spread > (ratio + 0.5) * s->in.spacing - reach) return 1;
        for (int other = 0; other < b; other++)
            if (are_near(s, of[b], of[other], reach)) return 1;
    }
    return 0;
}

static struct solid_contact *contact_new(struct solid *s) {
    struct solid_contact *c = memory_new(MEMORY_SOLID, 1, sizeof *c);
    const size_t n = (size_t)s->n + 1;
    c->radius = s->in.contact_radius * s->in.spacing;
    c->skin = skin * s->in.spacing;
    c->lost = solid_lost_new(s);
    c->again = memory_new(MEMORY_SOLID, n, 1);
    for (int k = 0; k < 3; k++) c->built[k] = memory_new(MEMORY_SOLID, n, sizeof(double));
    c->id = memory_new(MEMORY_SOLID, n + (size_t)s->n_ghost, sizeof(double));
    for (int h = 0; h < s->n; h++) c->id[h] = (double)(s->first[par_rank()] + h);
    par_ghost_update(s->ghost, 1, &c->id, s->n);
    return c;
}

void solid_contact_free(struct solid *s) {
    struct solid_contact *c = s->contact;
    s->contact = NULL;
    if (!c) return;
    solid_lost_free(c->lost);
    memory_free(c->again);
    for (int k = 0; k < 3; k++) memory_free(c->built[k]);
    memory_free(c->id);
    free(c->broken.h);
    free(c->broken.l);
    free(c->strangers.h);
    free(c->strangers.l);
    par_exchange_free(c->exchange);
    free(c->sent_h);
    free(c->sent_x);
    free(c->other);
    free(c->other_x);
    memory_free(c);
}

/* The square of the furthest way of a candidate since the lists were made, m2. */
static double moved2(const struct solid *s, const struct solid_contact *c) {
    double most = 0;
    for (int h = 0; h < s->n; h++) {
        if (!solid_contact_is_candidate(s, h)) continue;
        double r2 = 0;
        for (int k = 0; k < 3; k++) r2 += (s->d[k][h] - c->built[k][h]) * (s->d[k][h] - c->built[k][h]);
        if (r2 > most) most = r2;
    }
    return most;
}

void solid_contact_update(struct solid *s) {
    if (!s->in.contact) return;
    clock_begin(CLOCK_CONTACT);
    solid_ghosts_update(s);
    const int broke = solid_lost_take(s, SOLID_BROKE_CONTACT), is_new = !s->contact;
    if (is_new && could_touch(s, (s->in.contact_radius + skin) * s->in.spacing)) s->contact = contact_new(s);
    struct solid_contact *c = s->contact;
    if (c) {
        if (broke && !is_new) solid_contact_list_broken(s, c);
        double most[2] = {is_new ? INFINITY : moved2(s, c), c->broken.n + c->strangers.n};
        par_max_array(most, 2);
        if (most[0] > rebuild * rebuild * s->in.spacing * s->in.spacing) {
            solid_contact_list(s, c);
            most[1] = par_max(c->broken.n + c->strangers.n);
        }
        c->any = most[1] > 0;
    }
    clock_end(CLOCK_CONTACT);
}
