/* fluid_probes.csv: the flow at points and along lines during the run.  (docs/run-folder.md) */
#pragma once
#include "coupling/run.h"

struct fluid_probes; /* opaque */

struct fluid_probes *fluid_probes_new(struct run *r); /* NULL if the scene asks for none. Not collective. */
/* Begins the file (resume_step < 0), or cuts it back to that step. Collective. */
void fluid_probes_open(struct fluid_probes *p, struct run *r, const char *folder, long resume_step);
int fluid_probes_are_due(const struct fluid_probes *p, long step); /* p may be NULL. Not collective. */
void fluid_probes_sample(struct fluid_probes *p, struct run *r);   /* Appends one row for each point. Collective. */
void fluid_probes_free(struct fluid_probes *p);
