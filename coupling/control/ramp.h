/* Warns of loads and imposed motions that change in steps in which the solid does not move. */
#pragma once

struct run;

enum { RAMP_SENTENCE = 448 };
/* Before the first step in which the solid moves: what has begun to change before, and therefore acts at once. At the
 * end of a run (ends): what still changes afterwards, and has not reached its largest factor. Both for the first load
 * or constraint of which it is so. Returns whether there is one. Not collective. */
int ramp_of(const struct run *r, int ends, char sentence[RAMP_SENTENCE]);
/* At the end of a stage from whose start times count: what has then not reached its largest factor. The same, before
 * the run, by the stage's given step. Not collective. */
int ramp_of_stage(const struct run *r, double begin, double end, char sentence[RAMP_SENTENCE]);
