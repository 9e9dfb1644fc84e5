/* The table of the state of the cracks' fluid, for checkpoints and for the state kept in memory.
 * (docs/design/state.md) */
#pragma once
#include "cracks/cracks.h"
#include "base/files/state_item.h"

extern const struct state_item cracks_state_table[];

struct state_part cracks_state_table_part(struct cracks *c); /* Not collective. */
