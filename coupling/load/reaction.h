/* Load by reaction: what the forcing takes from the fluid is given to the solid, within the stage. */
#pragma once

struct run;
struct reaction; /* opaque */

struct reaction *reaction_new(struct run *r); /* NULL: the scene asks for another load. Collective. */
void reaction_free(struct reaction *k);
/* A step of fluid and solid. The markers stand at X^n. A part of the step (coupling/step.c). Collective. */
void reaction_step(struct run *r);
/* Sets r->load to the force on a solid at rest. Collective. */
void reaction_measure(struct run *r);
/* Power on the solid of what the inner fluid gives back, mean over the last step, W. Collective. */
double reaction_inner_power(const struct run *r);
/* Sum of the weights w_r of the stages. Not collective. */
double reaction_weights(const struct run *r);
