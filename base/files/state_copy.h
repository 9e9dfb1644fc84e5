/* A snapshot of a table's state in memory: takes and restores its STATE_SNAPSHOT items. Each is copied, ghosts
 * included, or handled by its own functions. */
#pragma once
#include "base/files/state_item.h"

struct state_copy; /* opaque; owned by the caller */

/* snapshot: passed to the items' own functions. Nothing is copied yet. The arrays must keep their sizes. */
struct state_copy *state_copy_new(const struct state_part *part, void *snapshot);
void state_copy_free(struct state_copy *copy, void *snapshot);
/* Copies the items in the table's order, those marked `last` at the end. Collective if an item's function is. */
void state_copy_take(struct state_copy *copy, const struct state_part *part, void *snapshot);
void state_copy_restore(struct state_copy *copy, const struct state_part *part, void *snapshot);
/* The copy of an item, component 0. Borrowed. */
const void *state_copy_of(const struct state_copy *copy, const char *name);
