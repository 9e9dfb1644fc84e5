/* A step of the fluid with the solid immersed. */
#pragma once

struct run;

/* Parts of the step; the markers are set, at X^n with V^n. Collective. */
void forced_fluid_step(struct run *r);
void forced_fluid_step_implicit(struct run *r); /* with implicit diffusion */
