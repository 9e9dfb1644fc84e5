/* bodies.csv: how each body of a solid of several moves, and what contact does to it.  (docs/run-folder.md) */
#pragma once
#include "coupling/run.h"

struct bodies; /* opaque */

/* NULL: one body, or the scene does not ask. Not collective. */
struct bodies *bodies_new(const struct run *r);
/* Opens the table; a run that has just begun gets its rows of the start. resume_step < 0: a new file. Collective. */
void bodies_open(struct bodies *b, struct run *r, const char *folder, long resume_step);
/* Appends a row for each body, if the step has moved the solid. b may be NULL. Collective. */
void bodies_sample(struct bodies *b, struct run *r);
void bodies_free(struct bodies *b);
