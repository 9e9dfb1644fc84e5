/* Says that the scene's cracks leave particles without a bond. */
#pragma once

struct run;

enum { LOOSE_SENTENCE = 320 };
/* Writes one sentence if there are some at the start. Returns whether there are. Collective. */
int loose_of(const struct run *r, char sentence[LOOSE_SENTENCE]);
