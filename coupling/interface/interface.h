/* Markers and probes at the solid's interface. */
#pragma once
#include "coupling/run.h"

/* Sets markers and probes from the surface's present state. Not collective. */
void interface_markers_update(struct run *r);
void interface_markers_free(struct run *r);
/* Tractions at the interface and their sum, from the present fields (for samples in stages whose step has no probe).
 * Collective. */
void interface_probe(struct run *r);
