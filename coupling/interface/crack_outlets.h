/* Mouths of cracks: where the fluid of cracks below the grid meets the resolved flow.  (docs/design/cracks.md) */
#pragma once
#include "coupling/run.h"

struct mouths *mouths_new(struct run *r); /* NULL unless cracks carry fluid and a flow is resolved. Collective. */
void mouths_free(struct mouths *m);
long mouths_count(const struct run *r); /* the interface's particles that are mouths now. Collective. */
/* A part of the step, before the fluid's: what entered the cracks in the last step leaves the flow before the mouths,
 * and as much enters where the cracks took it up, inside the body. Collective. */
void mouths_give(struct run *r);
/* In a stage in which cracks carry fluid, before the tractions become loads: finds the mouths, and turns the pressure's
 * part of their tractions to the normal of the face without the crack. Not collective. */
void mouths_find(struct run *r);
void mouths_straighten(struct run *r);
/* A part of the step, after the loads are set: finds the flow's pressure at the mouths, and adds the load of the
 * cracks' pressures again. Collective. */
void mouths_open(struct run *r);
/* After the solid's substeps: books what has entered, and switches struts where a crack is resolved. Collective. */
void mouths_settle(struct run *r);
