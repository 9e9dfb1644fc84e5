/* fragments.csv: the pieces of the solid, when they came off, how they move.  (docs/run-folder.md) */
#pragma once
#include "coupling/run.h"

struct fragments; /* opaque */

/* NULL if no bond can break, or if the scene does not want the file. Before a checkpoint is read. Not collective. */
struct fragments *fragments_new(struct run *r);
/* Begins the file with the pieces there are (resume_step < 0), or cuts it back to that step. Collective. */
void fragments_open(struct fragments *f, struct run *r, const char *folder, long resume_step);
/* Appends a row for each piece that has come off since the last sample; all: for every piece. f may be NULL.
 * Collective. */
void fragments_sample(struct fragments *f, struct run *r, int all);
/* What the last look found, which still holds unless bonds have broken since; -1: there was no look, f may be NULL. */
struct fragments_found {
    double pieces, largest; /* number of pieces; particles of the largest */
};
const struct fragments_found *fragments_last(const struct fragments *f);
void fragments_free(struct fragments *f);
