/* Warns of loads, imposed motions and injections that change in steps in which they do not act. */
#pragma once

struct run;

enum { RAMP_SENTENCE = 448 };
/* Before the first step in which the solid moves, of injections before the first in which fluid flows in cracks: what
 * has begun to change before, and therefore acts at once. At the end of a run (ends): what still changes afterwards,
 * and has not reached its largest factor, or its last one where it only rises or only falls. Both for the first load,
 * constraint or injection of which it is so. Returns whether there is one. Not collective. */
int ramp_of(const struct run *r, int ends, char sentence[RAMP_SENTENCE]);
/* At the end of a stage from whose start times count: what has then not reached its largest factor, or the end of
 * a ramp. The same, before the run, by the stage's given step. Not collective. */
int ramp_of_stage(const struct run *r, double begin, double end, char sentence[RAMP_SENTENCE]);
