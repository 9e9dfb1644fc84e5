/* Creates and frees a solid. */
#pragma once
#include "solid/state.h"

struct solid *solid_new(const struct solid_input *in); /* Dies (exit 2) on an empty or impossible body. Collective. */
void solid_free(struct solid *s);
/* For a solid that stays rigid, once its surface is known: keeps the particles, frees the bonds and the arrays of
 * motion. Not collective. */
void solid_free_bonds(struct solid *s);
