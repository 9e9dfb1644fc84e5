/* crack.csv: the crack of the solid during the run.  (docs/run-folder.md) */
#pragma once
#include "coupling/run.h"

struct crack; /* opaque */

/* Stores the solid's initial cracks: to be called before a checkpoint is read. NULL if the scene does not ask for a
 * crack, or if the solid has no bonds. Collective. */
struct crack *crack_series_new(struct run *r);
/* Begins the file (resume_step < 0), or cuts it back to that step and reads the tips' earlier positions from it.
 * Collective. */
void crack_series_open(struct crack *c, struct run *r, const char *folder, long resume_step);
int crack_series_is_due(const struct crack *c, long step); /* c may be NULL. Not collective. */
void crack_series_sample(struct crack *c, struct run *r);  /* Measures and appends a row. Collective. */
void crack_series_free(struct crack *c);
