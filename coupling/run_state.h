/* The table of a run's own state, and the list of all tables of a run: the content of a checkpoint. */
#pragma once
#include "coupling/run.h"
#include "base/files/state_list.h"
#include "solid/state_table.h"

extern const struct state_item run_state_table[];

struct run_state {
    int parts;
    struct state_part part[4]; /* [parts] the run, the fluid, the solid, the cracks' fluid, as the scene has them */
    struct state_list list;
    struct solid_state_owner solid;
};

/* The result points into itself and to the run: it must not be copied. Not collective. */
void run_state_of(struct run *r, struct run_state *state);
struct state_part run_state_part(struct run *r); /* the run's own. Not collective. */
