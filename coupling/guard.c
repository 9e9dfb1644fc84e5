/* The last good state in memory.  (coupling/checkpoint.h) */
#include "base/clock.h"
#include "base/memory.h"
#include "coupling/checkpoint.h"
#include "solid/family.h"
#include "solid/refine.h"
#include "solid/surface_lost.h"
#include "solid/surface_state.h"

#include <stdlib.h>
#include <string.h>

enum { FIELDS = 4, VECTORS = 5, ARRAYS = FIELDS + 3 * VECTORS, SHARES = 5 };

struct checkpoint_guard {
    double *copy[ARRAYS];
    size_t count[ARRAYS];
    uint8_t *bits, *flag;
    struct solid_lost *lost;     /* which particles' bits are not those of now */
    struct solid_facing *facing; /* of the interface */
    double t, driving, share[SHARES];
    long step, stage_step;
    int stage, kept;
    long refined; /* events when the arrays were made */
};

/* The arrays of doubles that make up the state, and their lengths; 0 where there is none. */
static void arrays_of(const struct run *r, double *array[ARRAYS], size_t count[ARRAYS]) {
    memset(array, 0, ARRAYS * sizeof *array);
    memset(count, 0, ARRAYS * sizeof *count);
    if (r->fluid) {
        const struct fluid_state *q = fluid_state_of(r->fluid);
        double *const fluid[FIELDS] = {q->u, q->v, q->w, q->p};
        for (int f = 0; f < FIELDS; f++) array[f] = fluid[f], count[f] = fluid_grid_of(r->fluid)->size;
    }
    const struct solid *s = r->solid;
    for (int c = 0; r->needs.bonds && c < 3; c++) {
        double *const vector[VECTORS] = {s->d[c], s->v[c], r->v_last[c], s->load[c], s->v_old[c]};
        for (int k = 0; k < VECTORS; k++) {
            array[FIELDS + 3 * k + c] = vector[k];
            count[FIELDS + 3 * k + c] = vector[k] ? (size_t)s->n : 0;
        }
    }
}

/* Copies this rank's share of what the solid has added up into the guard (back: 0), or back. */
static void shares(struct solid *s, double share[SHARES], int back) {
    double *const at[SHARES] = {&s->e_damped, &s->e_fracture, &s->e_constraint, &s->work_load,
                                &s->power_pairwise};
    for (int k = 0; k < SHARES; k++) {
        if (back)
            *at[k] = share[k];
        else
            share[k] = *at[k];
    }
}

struct checkpoint_guard *checkpoint_guard_new(const struct run *r) {
    struct checkpoint_guard *g = calloc(1, sizeof *g);
    double *array[ARRAYS];
    arrays_of(r, array, g->count);
    for (int k = 0; k < ARRAYS; k++)
        if (g->count[k]) g->copy[k] = memory_new(MEMORY_OUTPUT, g->count[k], sizeof(double));
    if (!r->needs.bonds) return g;
    g->refined = solid_refine_events(r->solid);
    const size_t n = (size_t)r->solid->n;
    g->flag = memory_new(MEMORY_OUTPUT, n + 1, 1);
    if (r->surface) g->facing = memory_new(MEMORY_OUTPUT, n + 1, sizeof *g->facing);
    if (r->needs.breakage) {
        const size_t bytes = (size_t)solid_family_bytes(r->solid);
        g->lost = solid_lost_new(r->solid);
        g->bits = memory_new(MEMORY_OUTPUT, n * bytes + 1, 1);
        for (size_t h = 0; h < n; h++) solid_family_save(r->solid, (int)h, g->bits + h * bytes);
    }
    return g;
}

void checkpoint_guard_free(struct checkpoint_guard *g) {
    if (!g) return;
    for (int k = 0; k < ARRAYS; k++) memory_free(g->copy[k]);
    memory_free(g->bits);
    memory_free(g->flag);
    memory_free(g->facing);
    solid_lost_free(g->lost);
    free(g);
}

int checkpoint_guard_fits(const struct checkpoint_guard *g, const struct run *r) {
    return !r->needs.bonds || g->refined == solid_refine_events(r->solid);
}

static void keep_bonds(struct checkpoint_guard *g, const struct solid *s) {
    const size_t bytes = (size_t)solid_family_bytes(s);
    for (int k = 0, found = solid_lost_find(g->lost, s); k < found; k++) {
        const int h = g->lost->h[k];
        solid_family_save(s, h, g->bits + (size_t)h * bytes);
    }
}

void checkpoint_guard_keep(struct checkpoint_guard *g, struct run *r) {
    double *array[ARRAYS];
    size_t count[ARRAYS];
    clock_begin(CLOCK_OUTPUT);
    arrays_of(r, array, count);
    for (int k = 0; k < ARRAYS; k++)
        if (count[k]) memcpy(g->copy[k], array[k], count[k] * sizeof(double));
    if (g->lost) keep_bonds(g, r->solid);
    if (g->flag) memcpy(g->flag, r->solid->flag, (size_t)r->solid->n);
    if (g->facing) solid_surface_keep(r->surface, g->facing);
    if (g->flag) shares(r->solid, g->share, 0);
    g->t = r->t;
    g->driving = r->fluid ? fluid_state_of(r->fluid)->driving : 0;
    g->step = r->step;
    g->stage = r->stage;
    g->stage_step = r->stage_step;
    g->kept = 1;
    clock_end(CLOCK_OUTPUT);
}

long checkpoint_guard_restore(struct checkpoint_guard *g, struct run *r) {
    if (!g->kept || !checkpoint_guard_fits(g, r)) return -1;
    double *array[ARRAYS];
    size_t count[ARRAYS];
    arrays_of(r, array, count);
    for (int k = 0; k < ARRAYS; k++)
        if (count[k]) memcpy(array[k], g->copy[k], count[k] * sizeof(double));
    const int bytes = g->bits ? solid_family_bytes(r->solid) : 0;
    for (int h = 0; g->bits && h < r->solid->n; h++)
        if (r->solid->flag[h] & SOLID_BROKEN)
            solid_family_load(r->solid, h, g->bits + (size_t)h * (size_t)bytes);
    if (g->flag) memcpy(r->solid->flag, g->flag, (size_t)r->solid->n);
    if (g->facing) solid_surface_restore(r->solid, r->surface, g->facing);
    if (g->flag) shares(r->solid, g->share, 1);
    if (r->fluid) fluid_state_of(r->fluid)->driving = g->driving;
    r->t = g->t;
    r->step = g->step;
    r->stage = g->stage;
    r->stage_step = g->stage_step;
    return g->step;
}
