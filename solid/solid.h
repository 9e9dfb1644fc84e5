/* A solid, from its input to its end. */
#pragma once
#include "solid/state.h"

struct solid *solid_new(const struct solid_input *in); /* Collective. Dies (exit 2) on an empty or impossible body. */
void solid_free(struct solid *s);
/* For a solid that stays rigid, once its surface is known: keeps the particles, gives back what bonds and motion need.
 * Not collective. */
void solid_forget_bonds(struct solid *s);
