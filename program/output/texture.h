/* slices.csv and rev.csv: the medium's porosity and surface by slice and by sub-volume, at the end of each stage.
 * (docs/run-folder.md) */
#pragma once
#include "coupling/run.h"

struct texture; /* opaque */

/* NULL if nothing is immersed, or if the scene writes no series. Begins the files (resume_step < 0), or cuts them back
 * to that step. Collective. */
struct texture *texture_new(struct run *r, const char *folder, long resume_step);
void texture_sample(struct texture *t, struct run *r); /* Appends the present state. Collective. */
void texture_free(struct texture *t);
