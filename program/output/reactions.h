/* reactions.csv: force and displacement of every constraint and load.  (docs/run-folder.md) */
#pragma once
#include "coupling/run.h"

struct reactions; /* opaque */

/* NULL if the elastic solid has neither constraints nor loads, or if the scene does not want the file. Not
 * collective. */
struct reactions *reactions_new(struct run *r);
/* Begins the file (resume_step < 0), or cuts it back to that step. Collective. */
void reactions_open(struct reactions *a, struct run *r, const char *folder, long resume_step);
/* Appends a row for each constraint and load, if the last step has moved the solid. a may be NULL. Collective. */
void reactions_sample(struct reactions *a, struct run *r);
void reactions_free(struct reactions *a);
