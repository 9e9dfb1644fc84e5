/* The force that markers keep from step to step, by particle: part of a checkpoint, and of the state saved in memory.
 * With the load by reaction it is the force itself, with implicit diffusion the first guess of its iteration. */
#pragma once
#include "coupling/run.h"

/* 1: the run's markers keep a force. Not collective. */
int marker_force_is_kept(const struct run *r);
/* Reads the force into all [n][3] of the solid's particles, m/s2; 0 if a particle has no marker, or none yet.
 * Collective. */
void marker_force_by_particle(struct run *r, double (*all)[3]);
/* Gives the force back to the markers: at once if the solid is at rest, else when the markers have been set again.
 * Collective. */
void marker_force_from_particles(struct run *r, const double (*all)[3]);
/* Stores the force by particle, before the interface changes. A particle without bonds keeps no force: its marker
 * stands for a drag. Collective. */
void marker_force_hold(struct run *r);
/* Before ibm_markers_set: gives a stored force to the markers that will be set. Not collective. */
void marker_force_assign(struct run *r);
