/* intensity.csv of a plate with bonds: J and stress-intensity factors of its cracks' tips.  (docs/run-folder.md) */
#pragma once
#include "coupling/run.h"

struct intensity; /* opaque */

/* NULL if the scene asks for none, or if the solid has no bonds. Dies (exit 2) if no end of a crack is inside the body,
 * and on a radius whose circle does not fit. Collective. */
struct intensity *intensity_new(struct run *r);
/* Begins the file (resume_step < 0), or cuts it back to that step. Not collective. */
void intensity_open(struct intensity *a, const char *folder, long resume_step);
int intensity_is_due(const struct intensity *a, long step); /* a may be NULL. Not collective. */
void intensity_sample(struct intensity *a, struct run *r);  /* Appends a row for each tip and radius. Collective. */
void intensity_free(struct intensity *a);
