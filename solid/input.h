/* The input of a solid: checked, and copied for as long as the solid lives. Inside the room only. */
#pragma once
#include "solid/solid.h"

/* Dies (exit 2) on numbers that make no solid. Collective (all ranks alike). */
void solid_input_check(const struct solid_input *in);
/* The input with its own copies; what a body's points, outlines, cuts and initial displacements point to stays the
 * caller's, and is forgotten once the solid is made. Not collective. */
void solid_input_copy(struct solid_input *to, const struct solid_input *from);
void solid_input_free(struct solid_input *in);
