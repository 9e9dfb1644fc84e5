/* Particles that are not as far apart as cells are wide. */
#pragma once

enum { RATIO_SENTENCE = 512 };
struct run;

/* Whether the distance of particles in a fluid is so far from a cell that the flow around their bodies is off by 5 % or
 * more: the sentence then says by how much, and is left alone else. Not collective. */
int ratio_of(const struct run *r, char sentence[RATIO_SENTENCE]);
