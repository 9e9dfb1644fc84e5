/* Keeps the last good state of a run in memory and restores it. */
#include "base/clock.h"
#include "base/ensure.h"
#include "coupling/control/rollback.h"
#include "coupling/run_state.h"
#include "cracks/state_table.h"
#include "base/files/state_copy.h"
#include "fluid/state_table.h"
#include "solid/keep.h"
#include "solid/refine/refine.h"

#include <stdlib.h>

struct guard {
    struct state_copy *run;
    struct state_copy *fluid;  /* NULL: there is none */
    struct solid_keep *solid;  /* NULL: the solid does not change */
    struct state_copy *cracks; /* NULL: cracks carry no fluid */
    struct cracks_keep *wet;   /* of that copy */
    double (*demand)[3];       /* [n] the forcing's starting guess (forcing_guess_kept); NULL: it has none */
    int kept;
    long refined; /* number of refinements when the arrays were made */
};

struct guard *guard_new(const struct run *r) {
    struct guard *g = calloc(1, sizeof *g);
    ENSURE(g, "no memory for %zu bytes", sizeof *g);
    const struct state_part run = run_state_part((struct run *)r);
    g->run = state_copy_new(&run, &g->demand);
    if (r->fluid) {
        const struct state_part fluid = fluid_state_table_part(r->fluid);
        g->fluid = state_copy_new(&fluid, g);
    }
    if (!r->needs.bonds) return g;
    g->refined = solid_refine_events(r->solid);
    g->solid = solid_keep_new(r->solid, r->surface, r->needs.breakage);
    if (r->cracks) {
        const struct state_part cracks = cracks_state_table_part(r->cracks);
        g->cracks = state_copy_new(&cracks, &g->wet);
    }
    return g;
}

void guard_free(struct guard *g) {
    if (!g) return;
    state_copy_free(g->run, &g->demand);
    state_copy_free(g->fluid, g);
    solid_keep_free(g->solid);
    state_copy_free(g->cracks, &g->wet);
    free(g);
}

int guard_fits(const struct guard *g, const struct run *r) {
    return !r->needs.bonds || g->refined == solid_refine_events(r->solid);
}

void guard_keep(struct guard *g, struct run *r) {
    const struct state_part run = run_state_part(r);
    clock_begin(CLOCK_KEEPING);
    if (g->fluid) {
        const struct state_part fluid = fluid_state_table_part(r->fluid);
        state_copy_take(g->fluid, &fluid, g);
    }
    if (g->solid) solid_keep_take(g->solid, r->solid, r->surface);
    if (g->cracks) {
        const struct state_part cracks = cracks_state_table_part(r->cracks);
        state_copy_take(g->cracks, &cracks, &g->wet);
    }
    state_copy_take(g->run, &run, &g->demand);
    g->kept = 1;
    clock_end(CLOCK_KEEPING);
}

/* The forcing's guess, of the run, comes back when the solid has. */
long guard_restore(struct guard *g, struct run *r) {
    const struct state_part run = run_state_part(r);
    if (!g->kept || !guard_fits(g, r)) return -1;
    clock_begin(CLOCK_KEEPING);
    if (g->fluid) {
        const struct state_part fluid = fluid_state_table_part(r->fluid);
        state_copy_restore(g->fluid, &fluid, g);
    }
    if (g->solid) solid_keep_restore(g->solid, r->solid, r->surface);
    if (g->cracks) {
        const struct state_part cracks = cracks_state_table_part(r->cracks);
        state_copy_restore(g->cracks, &cracks, &g->wet);
    }
    state_copy_restore(g->run, &run, &g->demand);
    /* work that belongs to another state */
    r->adapt.limits_of = -1;
    if (r->deposited > r->step) r->deposited = -1;
    clock_end(CLOCK_KEEPING);
    return r->step;
}
