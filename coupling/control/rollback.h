/* The last good state, saved in memory. */
#pragma once
#include "coupling/run.h"

/* A copy of the run's state in memory, known to be good; an unstable run ends with it. Its content is given by the
 * tables of state (coupling/run_state.c). */
struct rollback; /* opaque */
struct rollback *rollback_new(const struct run *r);
void rollback_free(struct rollback *b);
void rollback_save(struct rollback *b, struct run *r); /* Collective. */
/* 0: the solid has been refined since it was made, so a new one is needed. Not collective. */
int rollback_fits(const struct rollback *b, const struct run *r);
/* Restores the saved state. Returns its step, or -1 if none was saved, or none that fits the present particles.
 * Collective. */
long rollback_restore(struct rollback *b, struct run *r);
