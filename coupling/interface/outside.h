/* Particles of a file that lie beyond the domain's sides. */
#pragma once
#include "coupling/run.h"

/* Writes one sentence if the body is one of points and some lie outside the domain; returns whether. Not collective. */
enum { OUTSIDE_SENTENCE = 320 };
int outside_of(const struct run *r, int body, char sentence[OUTSIDE_SENTENCE]);
