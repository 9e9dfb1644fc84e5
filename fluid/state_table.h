/* The table of the fluid's state. */
#pragma once
#include "base/files/state_item.h"
#include "fluid/fluid.h"

extern const struct state_item fluid_state_table[];
struct state_part fluid_state_table_part(struct fluid *f); /* Not collective. */
