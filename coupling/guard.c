/* The last good state in memory.  (coupling/checkpoint.h) */
#include "base/memory.h"
#include "coupling/checkpoint.h"
#include "solid/family.h"
#include "solid/surface_state.h"

#include <stdlib.h>
#include <string.h>

enum { ARRAYS = 12 };

struct checkpoint_guard {
    double *copy[ARRAYS];
    size_t count[ARRAYS];
    uint8_t *bits, *flag;
    double *surface; /* what solid_surface_save gives */
    double t, driving;
    long step, stage_step;
    int stage, kept;
};

/* The arrays of doubles that make up the state, and their lengths; 0 where there is none. */
static void arrays_of(const struct run *r, double *array[ARRAYS], size_t count[ARRAYS]) {
    memset(array, 0, ARRAYS * sizeof *array);
    memset(count, 0, ARRAYS * sizeof *count);
    if (r->fluid) {
        const struct fluid_state *q = fluid_state_of(r->fluid);
        double *const fluid[4] = {q->u, q->v, q->w, q->p};
        for (int f = 0; f < 4; f++) array[f] = fluid[f], count[f] = fluid_grid_of(r->fluid)->size;
    }
    if (r->needs.bonds)
        for (int c = 0; c < 3; c++) {
            array[4 + c] = r->solid->d[c], count[4 + c] = (size_t)r->solid->n;
            array[7 + c] = r->solid->v[c], count[7 + c] = (size_t)r->solid->n;
        }
}

struct checkpoint_guard *checkpoint_guard_new(const struct run *r) {
    struct checkpoint_guard *g = calloc(1, sizeof *g);
    double *array[ARRAYS];
    arrays_of(r, array, g->count);
    for (int k = 0; k < ARRAYS; k++)
        if (g->count[k]) g->copy[k] = memory_new(MEMORY_OUTPUT, g->count[k], sizeof(double));
    if (r->needs.breakage) {
        const int bytes = solid_family_bytes(r->solid), n = r->solid->n;
        g->bits = memory_new(MEMORY_OUTPUT, (size_t)n * (size_t)bytes + 1, 1);
        g->flag = memory_new(MEMORY_OUTPUT, (size_t)n + 1, 1);
        for (int h = 0; h < n; h++) solid_family_save(r->solid, h, g->bits + (size_t)h * (size_t)bytes);
    }
    if (r->needs.bonds && r->surface)
        g->surface = memory_new(MEMORY_OUTPUT, (size_t)r->solid->n * (size_t)solid_surface_state_size() + 1,
                                sizeof(double));
    return g;
}

void checkpoint_guard_free(struct checkpoint_guard *g) {
    if (!g) return;
    for (int k = 0; k < ARRAYS; k++) memory_free(g->copy[k]);
    memory_free(g->bits);
    memory_free(g->flag);
    memory_free(g->surface);
    free(g);
}

void checkpoint_guard_keep(struct checkpoint_guard *g, struct run *r) {
    double *array[ARRAYS];
    size_t count[ARRAYS];
    arrays_of(r, array, count);
    for (int k = 0; k < ARRAYS; k++)
        if (count[k]) memcpy(g->copy[k], array[k], count[k] * sizeof(double));
    const int bytes = g->bits ? solid_family_bytes(r->solid) : 0;
    for (int h = 0; g->bits && h < r->solid->n; h++)
        if (r->solid->flag[h] & SOLID_BROKEN)
            solid_family_save(r->solid, h, g->bits + (size_t)h * (size_t)bytes);
    if (g->flag) memcpy(g->flag, r->solid->flag, (size_t)r->solid->n);
    if (g->surface) solid_surface_save(r->solid, r->surface, g->surface);
    g->t = r->t;
    g->driving = r->fluid ? fluid_state_of(r->fluid)->driving : 0;
    g->step = r->step;
    g->stage = r->stage;
    g->stage_step = r->stage_step;
    g->kept = 1;
}

long checkpoint_guard_restore(struct checkpoint_guard *g, struct run *r) {
    if (!g->kept) return -1;
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
    if (g->surface) solid_surface_load(r->solid, r->surface, g->surface);
    if (r->fluid) fluid_state_of(r->fluid)->driving = g->driving;
    r->t = g->t;
    r->step = g->step;
    r->stage = g->stage;
    r->stage_step = g->stage_step;
    return g->step;
}
