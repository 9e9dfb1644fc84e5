/* Particles of a file that lie beyond the domain's sides. */
#pragma once
#include "solid/state.h"

enum { OUTSIDE_SENTENCE = 320 };
/* Writes one sentence if the body is one of points and some lie outside the domain; returns whether. Not collective. */
int outside_of(const struct solid *s, int body, int has_fluid, char sentence[OUTSIDE_SENTENCE]);
