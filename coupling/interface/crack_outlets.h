/* Outlets of cracks: where the fluid of cracks below the grid meets the resolved flow.  (docs/design/cracks.md) */
#pragma once
#include "coupling/run.h"

/* NULL unless cracks carry fluid and a flow is resolved. Collective. */
struct crack_outlets *crack_outlets_new(struct run *r);
void crack_outlets_free(struct crack_outlets *m);
long crack_outlets_count(const struct run *r); /* the interface's particles that are outlets now. Collective. */
/* A part of the step, before the fluid's: what entered the cracks in the last step leaves the flow before the outlets,
 * and as much enters where the cracks took it up, inside the body. Collective. */
void crack_outlets_set_sources(struct run *r);
/* In a stage in which cracks carry fluid, before the tractions become loads: finds the outlets, and turns the
 * pressure's part of their tractions to the normal of the face without the crack. Not collective. */
void crack_outlets_find(struct run *r);
void crack_outlets_correct_tractions(struct run *r);
/* A part of the step, after the loads are set: finds the flow's pressure at the outlets, and adds the load of the
 * cracks' pressures again. Collective. */
void crack_outlets_set_pressures(struct run *r);
/* After the solid's substeps: adds what has entered to the sums, and switches struts where a crack is resolved.
 * Collective. */
void crack_outlets_end_step(struct run *r);
