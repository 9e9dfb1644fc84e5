/* Compares the time scales of fluid and solid. */
#pragma once
#include "coupling/run.h"

enum { TIMESCALE_SENTENCE = 480 };
/* Whether the present stage takes so many substeps in a step that it is costly (1000) or hopeless (10000), or whether
 * bonds may break in a fluid's step of 4.5 stable ones of the solid or more; the sentence says how many, and from which
 * time scales they follow. step_begin_stage comes first. Collective. */
int timescale_of(struct run *r, char sentence[TIMESCALE_SENTENCE]);
/* Number of substeps of the present stage in a step; of an automatic step, at the fluid's limits that are foreseen. 0:
 * the solid does not move, or is found by relaxation. Collective. */
double timescale_substeps(struct run *r);
