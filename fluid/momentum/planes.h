/* The momentum pass by groups of planes, so that the Poisson solver takes u* while it is in the cache. The
 * divergence in a rank's first plane reads w* of the last plane of the rank below (or of this rank, if it is its own
 * neighbour). So each rank computes its last plane first, into separate memory, and sends its w*. */
#pragma once
#include "fluid/internal.h"
#include "fluid/momentum/momentum.h"

/* NULL where u* is needed as a whole before its divergence: u* has arrays of its own, or y is cut over ranks, or there
 * are several threads; and if planes are too large for the cache. Collective. */
struct fluid_planes *fluid_planes_new(const struct fluid *f);
void fluid_planes_free(struct fluid_planes *p);
/* Before the planes of a stage. Collective. */
void fluid_planes_begin(struct fluid *f, const struct fluid_momentum_stage *s);
int fluid_planes_open(const struct fluid *f); /* whether planes of a stage are left */
/* Planes 0, 1, .. m_z-1 in turn: u* has replaced u in plane k, with the values on the sides' faces; for plane 0 also w*
 * on the faces below it. Not collective. */
void fluid_planes_predict(struct fluid *f, int k);
