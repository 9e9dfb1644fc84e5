/* What the implicit forcing goes on from, by particle: part of a checkpoint, and of the state kept in memory. */
#pragma once
#include "coupling/run.h"

/* 1: the run has one. Not collective. */
int forcing_guess_is_part_of(const struct run *r);
/* all [n][3] of the solid's particles, m/s2; 0 where there is no marker, or none yet. Collective. */
void forcing_guess_take(struct run *r, double (*all)[3]);
/* Back to the markers: at once where the solid is at rest, else once they stand where they did. Collective. */
void forcing_guess_put(struct run *r, const double (*all)[3]);
/* After ibm_markers_set: hands on what has waited for them. Collective. */
void forcing_guess_hand_on(struct run *r);
