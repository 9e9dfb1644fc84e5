/* The last good state, kept in memory. */
#pragma once
#include "coupling/run.h"

/* A copy of the run's state in memory, known to be good; an unstable run ends with it. Its content is given by the
 * tables of state (coupling/run_state.c). */
struct guard; /* opaque */
struct guard *guard_new(const struct run *r);
void guard_free(struct guard *g);
void guard_keep(struct guard *g, struct run *r); /* Collective. */
/* 0: the solid has been refined since the guard was made, so a new guard is needed. Not collective. */
int guard_fits(const struct guard *g, const struct run *r);
/* Restores the kept state. Returns its step, or -1 if none was kept, or none that fits the present particles.
 * Collective. */
long guard_restore(struct guard *g, struct run *r);
