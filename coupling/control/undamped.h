/* Finds elastic stages with the load by probes whose bonds nothing damps. */
#pragma once
#include "coupling/run.h"

enum { UNDAMPED_SENTENCE = 400 };
/* With the load by probes waves that the fluid's step does not resolve get the fluid's answer in the wrong phase, and
 * grow (docs/design/coupling.md); from 20 times the fluid's density on a ball stayed bounded. Returns 1 and writes a
 * sentence if the present stage has no damping_relative and the solid is less than 30 times as dense as the fluid. The
 * sentence gives a damping that is a quarter of the critical one of the fastest wave. step_begin_stage comes first, and
 * must come again before a step. Collective. */
int undamped_of(struct run *r, char sentence[UNDAMPED_SENTENCE]);
