/* Starting guess of the implicit forcing, stored per particle: part of a checkpoint, and of the state kept in
 * memory. */
#pragma once
#include "coupling/run.h"
#include "base/files/state_item.h"

/* 1: the run has such a guess. Not collective. */
int forcing_guess_is_part_of(const struct run *r);
/* Reads the guess into all [n][3] of the solid's particles, m/s2; 0 if a particle has no marker, or none yet.
 * Collective. */
void forcing_guess_take(struct run *r, double (*all)[3]);
/* Gives the guess back to the markers: at once if the solid is at rest, else when the markers have been set again.
 * Collective. */
void forcing_guess_put(struct run *r, const double (*all)[3]);
/* Stores the markers' values by particle, before the interface changes. A particle without bonds keeps no force: its
 * marker stands for a drag. Collective. */
void forcing_guess_keep(struct run *r);
/* Before ibm_markers_set: gives a stored guess to the markers that will be set. Not collective. */
void forcing_guess_hand_on(struct run *r);

/* For the table of state: its `keep` is a double (**)[3], an array that is made when it is first needed; its owner is
 * the run. */
extern const struct state_kept forcing_guess_kept;
