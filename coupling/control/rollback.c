/* Saves the last good state of a run in memory and restores it. */
#include "base/clock.h"
#include "base/ensure.h"
#include "coupling/control/rollback.h"
#include "coupling/run_state.h"
#include "cracks/state_table.h"
#include "base/files/state_copy.h"
#include "fluid/state_table.h"
#include "solid/snapshot.h"
#include "solid/refine/refine.h"

#include <stdlib.h>

struct rollback {
    struct state_copy *run;
    struct state_copy *fluid;     /* NULL: there is none */
    struct solid_snapshot *solid; /* NULL: the solid does not change */
    struct state_copy *cracks;    /* NULL: cracks carry no fluid */
    int is_saved;
    long refined; /* number of refinements when the arrays were made */
};

struct rollback *rollback_new(const struct run *r) {
    struct rollback *b = calloc(1, sizeof *b);
    ENSURE(b, "no memory for %zu bytes", sizeof *b);
    const struct state_part run = run_state_part((struct run *)r);
    b->run = state_copy_new(&run, NULL);
    if (r->fluid) {
        const struct state_part fluid = fluid_state_table_part(r->fluid);
        b->fluid = state_copy_new(&fluid, NULL);
    }
    if (!r->needs.bonds) return b;
    b->refined = solid_refine_events(r->solid);
    b->solid = solid_snapshot_new(r->solid, r->surface, r->needs.breakage);
    if (r->cracks) {
        const struct state_part cracks = cracks_state_table_part(r->cracks);
        b->cracks = state_copy_new(&cracks, NULL);
    }
    return b;
}

void rollback_free(struct rollback *b) {
    if (!b) return;
    state_copy_free(b->run, NULL);
    state_copy_free(b->fluid, NULL);
    solid_snapshot_free(b->solid);
    state_copy_free(b->cracks, NULL);
    free(b);
}

int rollback_fits(const struct rollback *b, const struct run *r) {
    return !r->needs.bonds || b->refined == solid_refine_events(r->solid);
}

void rollback_save(struct rollback *b, struct run *r) {
    const struct state_part run = run_state_part(r);
    clock_begin(CLOCK_KEEPING);
    if (b->fluid) {
        const struct state_part fluid = fluid_state_table_part(r->fluid);
        state_copy_take(b->fluid, &fluid, NULL);
    }
    if (b->solid) solid_snapshot_take(b->solid, r->solid, r->surface);
    if (b->cracks) {
        const struct state_part cracks = cracks_state_table_part(r->cracks);
        state_copy_take(b->cracks, &cracks, NULL);
    }
    state_copy_take(b->run, &run, NULL);
    b->is_saved = 1;
    clock_end(CLOCK_KEEPING);
}

/* The markers' force, of the run, comes back when the solid has. */
long rollback_restore(struct rollback *b, struct run *r) {
    const struct state_part run = run_state_part(r);
    if (!b->is_saved || !rollback_fits(b, r)) return -1;
    clock_begin(CLOCK_KEEPING);
    if (b->fluid) {
        const struct state_part fluid = fluid_state_table_part(r->fluid);
        state_copy_restore(b->fluid, &fluid, NULL);
    }
    if (b->solid) solid_snapshot_restore(b->solid, r->solid, r->surface);
    if (b->cracks) {
        const struct state_part cracks = cracks_state_table_part(r->cracks);
        state_copy_restore(b->cracks, &cracks, NULL);
    }
    state_copy_restore(b->run, &run, NULL);
    /* work that belongs to another state */
    r->control.limits_step = -1;
    if (r->deposited > r->step) r->deposited = -1;
    clock_end(CLOCK_KEEPING);
    return r->step;
}
