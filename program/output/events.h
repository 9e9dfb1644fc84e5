/* events.csv: the bonds that broke, in clusters by step and place.  (docs/run-folder.md) */
#pragma once
#include "coupling/run.h"

struct events; /* opaque */

/* NULL if the scene does not ask for the file. Before a checkpoint is read. Not collective. */
struct events *events_new(struct run *r);
/* Begins the file (resume_step < 0), or cuts it back to that step. Collective. */
void events_open(struct events *e, struct run *r, const char *folder, long resume_step);
/* Appends the events of the bonds that have broken since the last call. To be called before a checkpoint is written,
 * because the state has no list of them. e may be NULL. Collective. */
void events_write(struct events *e, struct run *r);
void events_free(struct events *e);
