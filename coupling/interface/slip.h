/* The slip time: slip of a steady flow at the walls over the forcing's force, m/s over m/s2. */
#pragma once

struct run;

/* Of the forcing with feedback and of that with implicit diffusion, s. It does not depend on the step. Collective. */
double slip_time_of(struct run *r);
