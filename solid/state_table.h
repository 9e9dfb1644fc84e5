/* The table of the solid's state. */
#pragma once
#include "solid/snapshot_items.h"

extern const struct state_item solid_state_table[];
/* Of a solid with its bonds. owner: stays the caller's, and is needed as long as the part. Not collective. */
struct state_part solid_state_table_part(struct solid_state_owner *owner);
void solid_state_table_size(const struct solid *s, struct state_size *size); /* Not collective. */
