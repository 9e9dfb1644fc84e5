/* The table of the state of the cracks' fluid, for checkpoints and for the state kept in memory.
 * (docs/design/state.md) */
#pragma once
#include "cracks/cracks.h"
#include "base/files/state_item.h"

struct cracks_snapshot; /* opaque; the `keep` of the table's functions: the address of a pointer to it, NULL at first */

extern const struct state_item cracks_state_table[];

struct state_part cracks_state_table_part(struct cracks *c); /* Not collective. */
