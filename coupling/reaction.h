/* Load by reaction: what the forcing takes from the fluid is given to the solid, within the stage. */
#pragma once

struct run;
struct reaction; /* opaque */

struct reaction *reaction_new(struct run *r); /* NULL: the scene asks for another load. Collective. */
void reaction_free(struct reaction *k);
/* The largest slip time of the scene's forcing with feedback, s: a fraction of the time in which momentum diffuses over
 * a cell, and of the time in which the flow crosses one. It does not depend on the step. Not collective. */
double reaction_slip_time(const struct run *r);
/* A step of fluid and solid. The markers stand at X^n. A part of the step (coupling/step.c). Collective. */
void reaction_step(struct run *r);
/* Sets r->load to the force on a solid at rest. Collective. */
void reaction_measure(struct run *r);
/* Power on the solid of what the inner fluid gives back, mean over the last step, W. Collective. */
double reaction_inner_power(const struct run *r);
/* Sum of the weights w_r of the stages. */
double reaction_weights(const struct run *r);
/* The substeps of each fluid stage out of `substeps` >= 3: in proportion to gamma_r, at least one each. */
void reaction_split(int substeps, int of_stage[3]);
