/* A table's state kept in memory and put back: STATE_KEPT items are copied, ghosts included, or go through their own
 * functions. */
#pragma once
#include "files/state_item.h"

struct state_copy; /* opaque; owned by the caller */

/* keep: handed to the items' own functions. Nothing is kept yet. Arrays must keep their sizes. */
struct state_copy *state_copy_new(const struct state_part *part, void *keep);
void state_copy_free(struct state_copy *copy, void *keep);
/* Items in the table's order, the ones marked `last` at the end. Collective if an item's function is. */
void state_copy_take(struct state_copy *copy, const struct state_part *part, void *keep);
void state_copy_restore(struct state_copy *copy, const struct state_part *part, void *keep);
/* What has been kept of an item that is copied, component 0. Borrowed. */
const void *state_copy_of(const struct state_copy *copy, const char *name);
