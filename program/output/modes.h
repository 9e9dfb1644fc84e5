/* modes.csv: azimuthal modes of the damage in rings about an axis.  (docs/run-folder.md) */
#pragma once
#include "coupling/run.h"

struct modes; /* opaque */

/* NULL if the scene asks for none, or if the solid has no bonds. Dies (exit 2) on a ring without particles.
 * Collective. */
struct modes *modes_new(struct run *r);
/* Begins the file (resume_step < 0), or cuts it back to that step. Collective. */
void modes_open(struct modes *m, const char *folder, long resume_step);
int modes_are_due(const struct modes *m, long step); /* m may be NULL. Not collective. */
void modes_sample(struct modes *m, struct run *r);   /* Appends a row for each ring and mode. Collective. */
void modes_free(struct modes *m);
