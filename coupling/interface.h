/* Markers and probes at the solid's interface. */
#pragma once
#include "coupling/run.h"

/* Sets markers and probes from the surface's present state. Not collective. */
void interface_markers_update(struct run *r);
/* Time between the two velocities whose difference makes the markers' acceleration, s: the last step's length; in the
 * strong scheme, whose velocities are means, from the middle of the last step to that of the present one. */
double interface_acceleration_time(const struct run *r);
void interface_markers_free(struct run *r);
/* Tractions at the interface and their sum, from the present fields (for samples in stages whose step has no probe).
 * Collective. */
void interface_probe(struct run *r);
