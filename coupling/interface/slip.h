/* The slip time: slip of a steady flow at the walls over the forcing's force, m/s over m/s2. */
#pragma once

struct run;

/* Of the forcing with feedback, s. It does not depend on the step. Collective. */
double slip_time_of(struct run *r);
/* Of the forcing with implicit diffusion, s: the same for a solid that is rigid in every stage. For one that moves it
 * is the mean stage of the longest explicit step; the load by reaction forces such a solid with feedback. Collective.
 */
double slip_time_of_implicit(struct run *r);
