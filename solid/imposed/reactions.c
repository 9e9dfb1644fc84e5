/* Sums up the reactions of constraints over a step, and measures where constraints and loads have moved. */
#include "solid/imposed/reactions.h"
#include "base/memory.h"
#include "base/par.h"
#include "solid/imposed/constraint.h"
#include "solid/imposed/damping.h"
#include "solid/imposed/external_loads.h"
#include "solid/imposed/indenter.h"
#include "solid/imposed/walls.h"

#include <math.h>
#include <string.h>

struct solid_reactions {
    long particles; /* of all ranks, when the list was made; -1: not yet */
    int held;
    int *h;               /* [held] owned particles that are held in a direction, ascending */
    int (*constraint)[3]; /* [held] constraint that holds it in each direction, -1: none */
    double (*now)[3];     /* [constraints + indenters] forces of the last sweep, this rank's share, N */
    double (*then)[3];
    double (*impulse)[3]; /* [constraints + indenters] so far in the step, N s */
    double *factor;       /* [loads] integral of the load's factor so far in the step, s */
    double time;          /* length of the step so far, s */
};

static int pushers(const struct solid *s) { return s->in.constraints + s->in.indenters; }

void solid_reactions_new(struct solid *s) {
    struct solid_reactions *r = memory_new(MEMORY_SOLID, 1, sizeof *r);
    const size_t n = (size_t)pushers(s) + 1;
    r->particles = -1;
    r->now = memory_new(MEMORY_SOLID, n, sizeof *r->now);
    r->then = memory_new(MEMORY_SOLID, n, sizeof *r->then);
    r->impulse = memory_new(MEMORY_SOLID, n, sizeof *r->impulse);
    r->factor = memory_new(MEMORY_SOLID, (size_t)s->in.loads + 1, sizeof *r->factor);
    s->reactions = r;
}

void solid_reactions_free(struct solid_reactions *r) {
    if (!r) return;
    MEMORY_FREE(r->h, r->constraint, r->now, r->then, r->impulse, r->factor, r);
}

static int is_held(const struct solid *s, int h) {
    return (s->flag[h] & (SOLID_HELD_X | SOLID_HELD_Y | SOLID_HELD_Z)) != 0;
}

/* The list of held particles; made again after a refinement. */
static void list_make(struct solid *s) {
    struct solid_reactions *r = s->reactions;
    if (r->particles == s->n_global) return;
    MEMORY_FREE(r->h, r->constraint);
    r->held = 0;
    for (int h = 0; h < s->n; h++) r->held += is_held(s, h);
    r->h = memory_new(MEMORY_SOLID, (size_t)r->held + 1, sizeof *r->h);
    r->constraint = memory_new(MEMORY_SOLID, (size_t)r->held + 1, sizeof *r->constraint);
    for (int h = 0, i = 0; h < s->n; h++) {
        if (!is_held(s, h)) continue;
        r->h[i] = h;
        for (int c = 0; c < 3; c++) r->constraint[i][c] = -1;
        for (int q = 0; q < s->in.constraints; q++) {
            const struct solid_constraint *k = &s->in.constraint[q];
            if (!solid_constraint_inside(s, h, k->low, k->high, &k->turn)) continue;
            for (int c = 0; c < s->dim; c++)
                if (k->direction[c]) r->constraint[i][c] = q;
        }
        i++;
    }
    r->particles = s->n_global;
}

void solid_reactions_begin(struct solid *s) {
    struct solid_reactions *r = s->reactions;
    solid_walls_impulse_begin(s);
    solid_damping_impulse_begin(s);
    if (!r) return;
    list_make(s);
    memset(r->impulse, 0, (size_t)pushers(s) * sizeof *r->impulse);
    memset(r->factor, 0, (size_t)s->in.loads * sizeof *r->factor);
    r->time = 0;
}

void solid_reactions_find(struct solid *s) {
    struct solid_reactions *r = s->reactions;
    if (!r) return;
    double(*const before)[3] = r->then;
    list_make(s);
    r->then = r->now;
    r->now = before;
    memset(r->now, 0, (size_t)s->in.constraints * sizeof *r->now);
    for (int i = 0; i < r->held; i++) {
        const int h = r->h[i];
        const double mass = solid_density(s, h) * s->volume[h];
        for (int c = 0; c < s->dim; c++)
            if (r->constraint[i][c] >= 0) r->now[r->constraint[i][c]][c] -= mass * s->a[c][h];
    }
    for (int k = 0; k < s->in.indenters; k++)
        memcpy(r->now[s->in.constraints + k], s->indent->force[k], sizeof *r->now);
}

void solid_reactions_add(struct solid *s, double now, double then) {
    struct solid_reactions *r = s->reactions;
    solid_walls_impulse_add(s, now, then);
    solid_damping_impulse_add(s, now, then);
    if (!r) return;
    for (int q = 0; q < pushers(s); q++)
        for (int c = 0; c < s->dim; c++) r->impulse[q][c] += now * r->now[q][c] + then * r->then[q][c];
    for (int k = 0; k < s->in.loads; k++) r->factor[k] += (now + then) * solid_external_loads_factor(s, k);
    r->time += now + then;
}

/* The constraints that hold the directions of a held particle. */
static const int *constraints_of(const struct solid_reactions *r, int h) {
    int low = 0, high = r->held - 1;
    while (low < high) {
        const int middle = (low + high) / 2;
        if (r->h[middle] < h)
            low = middle + 1;
        else
            high = middle;
    }
    return r->constraint[low];
}

void solid_reactions_add_impulse(struct solid *s, int h, const double impulse[3]) {
    struct solid_reactions *r = s->reactions;
    if (!is_held(s, h)) return;
    const int *constraint = constraints_of(r, h);
    for (int c = 0; c < 3; c++)
        if (constraint[c] >= 0) r->impulse[constraint[c]][c] -= impulse[c];
}

void solid_reactions_push(struct solid *s, int h, const double change[3], double dt) {
    struct solid_reactions *r = s->reactions;
    if (!r || !is_held(s, h)) return;
    const int *constraint = constraints_of(r, h);
    for (int c = 0; c < s->dim; c++) {
        if (constraint[c] < 0) continue;
        r->now[constraint[c]][c] -= change[c];
        r->impulse[constraint[c]][c] -= 0.5 * dt * change[c];
    }
}

void solid_reactions_impulse(const struct solid *s, double impulse[3]) {
    const struct solid_reactions *r = s->reactions;
    solid_walls_impulse(s, impulse);
    solid_damping_impulse(s, impulse);
    if (!r) return;
    for (int q = 0; q < pushers(s); q++)
        for (int c = 0; c < s->dim; c++) impulse[c] += r->impulse[q][c];
    for (int k = 0; k < s->in.loads; k++) {
        const struct solid_external_loads_sum given = solid_external_loads_sum_of(s, k);
        for (int c = 0; c < s->dim; c++) impulse[c] += r->factor[k] * given.force[c];
    }
}

enum { PARTICLES, VOLUME, FORCE, DISPLACEMENT = FORCE + 3, SUMS = DISPLACEMENT + 3 };

void solid_reactions_measure(struct solid *s, struct solid_reaction *reaction) {
    struct solid_reactions *r = s->reactions;
    const int n = pushers(s) + s->in.loads, indenters = n - s->in.indenters;
    if (!r || n == 0) return;
    list_make(s);
    double(*sum)[SUMS] = memory_new(MEMORY_SOLID, (size_t)n, sizeof *sum);
    for (int q = 0; q < s->in.constraints; q++) {
        for (int c = 0; c < s->dim; c++) sum[q][FORCE + c] = r->impulse[q][c];
        for (int i = 0; i < r->held; i++) {
            const int h = r->h[i];
            if (!solid_constraint_inside(s, h, s->in.constraint[q].low, s->in.constraint[q].high,
                                         &s->in.constraint[q].turn))
                continue;
            sum[q][PARTICLES]++;
            sum[q][VOLUME] += s->volume[h];
            for (int c = 0; c < s->dim; c++) sum[q][DISPLACEMENT + c] += s->volume[h] * s->d[c][h];
        }
    }
    for (int k = 0; k < s->in.loads; k++) {
        double *to = sum[s->in.constraints + k];
        const struct solid_external_loads_sum given = solid_external_loads_sum_of(s, k);
        to[PARTICLES] = given.particles;
        to[VOLUME] = given.volume;
        for (int c = 0; c < s->dim; c++) {
            to[FORCE + c] = r->factor[k] * given.force[c];
            to[DISPLACEMENT + c] = given.moved[c];
        }
    }
    for (int k = 0; k < s->in.indenters; k++) {
        double *to = sum[indenters + k];
        to[PARTICLES] = (double)s->indent->inside[k];
        for (int c = 0; c < s->dim; c++) to[FORCE + c] = r->impulse[s->in.constraints + k][c];
    }
    par_sum_array(&sum[0][0], n * SUMS);
    for (int q = 0; q < n; q++) {
        reaction[q].particles = lrint(sum[q][PARTICLES]);
        for (int c = 0; c < 3; c++) {
            reaction[q].force[c] = r->time > 0 ? sum[q][FORCE + c] / r->time : NAN;
            reaction[q].displacement[c] = q >= indenters ? s->in.indenter[q - indenters].velocity[c] * s->t
                                                         : sum[q][DISPLACEMENT + c] / sum[q][VOLUME];
        }
    }
    memory_free(sum);
}
