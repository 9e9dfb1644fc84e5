/* Flows of which the cells hold nothing: central differences, and no model of turbulence. */
#pragma once
#include "scene/scene.h"

struct run;
struct step_status;

/* The largest inflow velocity or driven velocity of the scene, m/s. Not collective. */
double unresolved_velocity(const struct scene_fluid *f);
/* Writes a sentence and returns 1 if the cells are too coarse for viscosity to have an effect at the velocity u, m/s;
 * else returns 0. Not collective. */
enum { UNRESOLVED_SENTENCE = 320 };
int unresolved_of(const struct run *r, double u, char sentence[UNRESOLVED_SENTENCE]);
/* After an accepted step, every so many steps and at the end of a stage: the log warns of a flow that has become so
 * fast, again when it is four times as fast, and at the end of the stage. Returns 1 if pressures or forces have made it
 * a thousand times as fast as that, so that the run is to end; status then says so. Collective. */
int unresolved_check(struct run *r, int stage_ends, struct step_status *status);
/* What such a run needs, in words; number: that of status. Not collective. */
void unresolved_explain(const struct run *r, double number, char *text, size_t size);
