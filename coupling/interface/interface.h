/* The solid's interface in the fluid, as a part of the step. */
#pragma once

struct run;

/* Sets markers and probes from the surface's present state. Not collective. */
void interface_update(struct run *r);
/* A part of the step: the same, and gives the markers to the forcing. Collective. */
void interface_begin_step(struct run *r);
