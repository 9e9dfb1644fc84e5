/* crack.csv: the crack of the solid as it runs.  (docs/run-folder.md) */
#pragma once
#include "coupling/run.h"

struct crack; /* opaque */

/* Remembers the solid's initial cracks: before a checkpoint is read. NULL where the scene does not ask for a crack, or
 * has no bonds. Collective. */
struct crack *crack_series_new(struct run *r);
/* Begins the file (resume_step < 0), or cuts it back to that step and takes up the tips' way from what is in it.
 * Collective. */
void crack_series_open(struct crack *c, struct run *r, const char *folder, long resume_step);
int crack_series_is_due(const struct crack *c, long step); /* c may be NULL. Not collective. */
void crack_series_sample(struct crack *c, struct run *r);  /* Measures and appends a row. Collective. */
void crack_series_free(struct crack *c);
