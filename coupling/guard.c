/* Keeps the last good state of a run in memory and restores it. */
#include "base/clock.h"
#include "base/ensure.h"
#include "base/memory.h"
#include "coupling/forcing_guess.h"
#include "coupling/guard.h"
#include "solid/keep.h"
#include "solid/refine/refine.h"

#include <stdlib.h>
#include <string.h>

enum { FIELDS = 4, CARRIED = FIELDS + 3, ARRAYS };

/* The position of a run in time, and the data on the present stage's steps. */
struct place {
    double t, dt, load[3], driving, solid_stable, approach;
    long step, stage_step, moved;
    int stage, substeps;
    enum solid_bound solid_bound;
};

struct guard {
    double *copy[ARRAYS];
    size_t count[ARRAYS];
    double (*demand)[3];      /* [n] guess of the implicit forcing; NULL: none */
    struct solid_keep *solid; /* NULL: the solid does not change */
    struct place at;
    int kept;
    long refined; /* number of refinements when the arrays were made */
};

/* The arrays to keep: the fluid's fields with their ghosts, the solid's velocity one step ago, the force of the bodies'
 * carried mass; NULL and 0 for those that the run does not have. */
static void arrays_of(const struct run *r, double *array[ARRAYS], size_t count[ARRAYS]) {
    memset(array, 0, ARRAYS * sizeof *array);
    memset(count, 0, ARRAYS * sizeof *count);
    if (r->fluid) {
        const struct fluid_state *q = fluid_state_of(r->fluid);
        double *const fluid[FIELDS] = {q->u, q->v, q->w, q->p};
        for (int f = 0; f < FIELDS; f++) array[f] = fluid[f], count[f] = fluid_grid_of(r->fluid)->size;
    }
    for (int c = 0; c < 3 && r->v_last[c]; c++) {
        array[FIELDS + c] = r->v_last[c];
        count[FIELDS + c] = (size_t)r->solid->n;
    }
    if (r->carried) array[CARRIED] = r->carried[0], count[CARRIED] = 3 * (size_t)r->solid->in.bodies;
}

struct guard *guard_new(const struct run *r) {
    struct guard *g = calloc(1, sizeof *g);
    double *array[ARRAYS];
    ENSURE(g, "no memory for %zu bytes", sizeof *g);
    arrays_of(r, array, g->count);
    for (int k = 0; k < ARRAYS; k++)
        if (array[k]) g->copy[k] = memory_new(MEMORY_OUTPUT, g->count[k] + 1, sizeof(double));
    if (forcing_guess_is_part_of(r)) g->demand = memory_new(MEMORY_OUTPUT, (size_t)r->solid->n + 1, sizeof *g->demand);
    if (!r->needs.bonds) return g;
    g->refined = solid_refine_events(r->solid);
    g->solid = solid_keep_new(r->solid, r->surface, r->needs.breakage);
    return g;
}

void guard_free(struct guard *g) {
    if (!g) return;
    for (int k = 0; k < ARRAYS; k++) memory_free(g->copy[k]);
    memory_free(g->demand);
    solid_keep_free(g->solid);
    free(g);
}

int guard_fits(const struct guard *g, const struct run *r) {
    return !r->needs.bonds || g->refined == solid_refine_events(r->solid);
}

void guard_keep(struct guard *g, struct run *r) {
    double *array[ARRAYS];
    size_t count[ARRAYS];
    clock_begin(CLOCK_OUTPUT);
    arrays_of(r, array, count);
    for (int k = 0; k < ARRAYS; k++)
        if (array[k]) memcpy(g->copy[k], array[k], count[k] * sizeof(double));
    if (g->solid) solid_keep_take(g->solid, r->solid, r->surface);
    if (g->demand) forcing_guess_take(r, g->demand);
    g->at = (struct place){.t = r->t,
                           .dt = r->dt,
                           .driving = r->fluid ? fluid_state_of(r->fluid)->driving : 0,
                           .solid_stable = r->solid_stable,
                           .approach = r->adapt.approach,
                           .step = r->step,
                           .stage_step = r->stage_step,
                           .moved = r->moved,
                           .stage = r->stage,
                           .substeps = r->substeps,
                           .solid_bound = r->solid_bound};
    memcpy(g->at.load, r->load, sizeof g->at.load);
    g->kept = 1;
    clock_end(CLOCK_OUTPUT);
}

long guard_restore(struct guard *g, struct run *r) {
    const struct place *at = &g->at;
    double *array[ARRAYS];
    size_t count[ARRAYS];
    if (!g->kept || !guard_fits(g, r)) return -1;
    clock_begin(CLOCK_OUTPUT);
    arrays_of(r, array, count);
    for (int k = 0; k < ARRAYS; k++)
        if (array[k]) memcpy(array[k], g->copy[k], count[k] * sizeof(double));
    if (g->solid) solid_keep_restore(g->solid, r->solid, r->surface);
    if (g->demand) forcing_guess_put(r, (const double(*)[3])g->demand);
    if (r->fluid) fluid_state_of(r->fluid)->driving = at->driving;
    r->t = at->t;
    r->dt = at->dt;
    memcpy(r->load, at->load, sizeof r->load);
    r->solid_stable = at->solid_stable;
    r->adapt.approach = at->approach;
    r->adapt.limits_of = -1;
    r->solid_bound = at->solid_bound;
    r->step = at->step;
    r->stage_step = at->stage_step;
    r->moved = at->moved;
    r->stage = at->stage;
    r->substeps = at->substeps;
    if (r->deposited > at->step) r->deposited = -1;
    clock_end(CLOCK_OUTPUT);
    return at->step;
}
