/* Compares the change of the solid's momentum with the impulses on it. */
#include "coupling/control/momentum.h"
#include "base/par.h"
#include "coupling/run.h"
#include "solid/imposed/reactions.h"

#include <math.h>
#include <string.h>

/* The least momentum that counts as exchanged, as a part of the sum of the magnitudes of the particles' momenta. */
static const double LEAST = 1e-3;

static int is_booked(const struct run *r) {
    const struct solid *s = r->solid;
    const int imposed = s->in.constraints + s->in.loads + s->in.indenters;
    return !s->added && (imposed == 0 || s->reactions);
}

/* Momentum in the directions in which no particle is held, the sum of its sizes, and the mass; of all ranks. */
enum { SIZES = 3, MASS, SUMS };
static void measure(const struct solid *s, double sum[SUMS]) {
    memset(sum, 0, SUMS * sizeof *sum);
    for (int h = 0; h < s->n; h++) {
        const double mass = solid_density(s, h) * s->volume[h];
        sum[MASS] += mass;
        for (int c = 0; c < s->dim; c++) {
            const double p = s->flag[h] >> c & SOLID_HELD_X ? 0 : mass * s->v[c][h];
            sum[c] += p;
            sum[SIZES] += fabs(p);
        }
    }
    par_sum_array(sum, SUMS);
}

void momentum_begin(struct run *r) {
    struct momentum_watch *w = &r->watch.momentum;
    double sum[SUMS];
    *w = (struct momentum_watch){.begun = 1};
    measure(r->solid, sum);
    memcpy(w->first, sum, sizeof w->first);
    w->mass = sum[MASS];
}

void momentum_note(struct run *r) {
    struct momentum_watch *w = &r->watch.momentum;
    if (!w->begun) return;
    w->begun = is_booked(r);
    solid_reactions_impulse(r->solid, w->impulse);
    for (int c = 0; c < r->solid->dim; c++) {
        w->fluid[c] += r->dt * ((r->needs.immersed ? r->load[c] : 0) + w->mass * r->solid->in.body_force[c]);
        w->largest_impulse = fmax(w->largest_impulse, fabs(w->fluid[c]));
    }
}

double momentum_check(struct run *r) {
    struct momentum_watch *w = &r->watch.momentum;
    double sum[SUMS], impulse[3];
    if (!w->begun) return 0;
    memcpy(impulse, w->impulse, sizeof impulse);
    measure(r->solid, sum);
    par_sum_array(impulse, 3);
    w->off = 0;
    for (int c = 0; c < r->solid->dim; c++) {
        w->largest_impulse = fmax(w->largest_impulse, fabs(impulse[c]));
        w->off = fmax(w->off, fabs(sum[c] - w->first[c] - impulse[c] - w->fluid[c]));
    }
    w->sizes = fmax(w->sizes, sum[SIZES]); /* damping may bring all to rest */
    w->exchanged = fmax(w->largest_impulse, LEAST * w->sizes);
    return w->exchanged > 0 ? w->off / w->exchanged : 0;
}
