/* Says that contact will not do what a scene expects of it: bodies that burst at rest, or pass through one another. */
#pragma once

struct run;

/* Sentences on the bodies as they are at the start. Returns how many. Collective. */
enum { COLLIDE_MAX = 2, COLLIDE_SENTENCE = 400 };
int collide_of(struct run *r, char sentence[COLLIDE_MAX][COLLIDE_SENTENCE]);
