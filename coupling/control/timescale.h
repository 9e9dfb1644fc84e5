/* Compares the time scales of fluid and solid. */
#pragma once
#include "coupling/run.h"

enum { TIMESCALE_SENTENCE = 480 };
/* Whether the present stage takes so many substeps in a step that it is costly (1000) or hopeless (10000), or whether
 * bonds may break in so long a fluid's step that 5 % too many do; the sentence says how many, and from which
 * time scales they follow. step_begin_stage comes first. Collective. */
int timescale_of(struct run *r, char sentence[TIMESCALE_SENTENCE]);
/* Number of substeps of the present stage in a step; of an automatic step, at the fluid's limits that are foreseen. 0:
 * the solid does not move, or is found by relaxation. Collective. */
double timescale_substeps(struct run *r);
/* What the step of the present stage costs where bonds may break in a fluid: its length, s; the bonds that break too
 * many, %; how much too short the time is until 1 % of them are broken, %; the step that leaves 2 %, s. 0: the step has
 * no such cost. step_begin_stage comes first. Collective. */
int timescale_breaking(const struct run *r, double *step, double *excess, double *early, double *advised);
/* The bonds that break too many, %, with a fluid's step of so many stable steps of the solid. */
double timescale_excess(double step);
/* How much too short the time is from the stage's start until 1 % of the bonds are broken, %. */
double timescale_early(double step);
