/* probes.csv: single particles of the solid during the run.  (docs/run-folder.md) */
#pragma once
#include "coupling/run.h"

struct probes; /* opaque */

/* NULL if the scene asks for none, or if the solid has no bonds. Dies (exit 2) on a place without a particle near it.
 * Collective. */
struct probes *probes_new(struct run *r);
/* Begins the file (resume_step < 0), or cuts it back to that step. Collective. */
void probes_open(struct probes *p, struct run *r, const char *folder, long resume_step);
int probes_are_due(const struct probes *p, long step); /* p may be NULL. Not collective. */
void probes_sample(struct probes *p, struct run *r);   /* Appends one row for each place. Collective. */
void probes_free(struct probes *p);
