/* The impulse of absolute damping over a step: momentum that goes to whatever the damping stands for. For solid/ only,
 * which adds it to what solid_reactions_impulse gives. */
#pragma once
#include "solid/state.h"

/* In a sweep, once a has been computed with damping at the present v: its force on all particles, held ones too,
 * because the reaction of a support is without it. */
void solid_damping_find(struct solid *s);
/* As solid_reactions_begin, _add and _impulse. */
void solid_damping_impulse_begin(struct solid *s);
void solid_damping_impulse_add(struct solid *s, double now, double then);
void solid_damping_impulse(const struct solid *s, double impulse[3]);
