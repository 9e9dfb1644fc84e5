/* The pressures of a substep, and their load on the solid.  (docs/design/cracks.md) */
#pragma once
#include "cracks/cracks.h"

/* For struct solid_push. Collective. */
void cracks_project(struct solid *s, double dt, void *cracks);
/* After substeps: bonds that have broken become struts, and their volume is void. Collective. */
void cracks_project_end(struct cracks *c);
/* Adds the pressures' share to the solid's load, after that has been set again. Not collective. */
void cracks_project_load_again(struct cracks *c);
