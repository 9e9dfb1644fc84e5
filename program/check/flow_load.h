/* frana check: the force that a flow will about have on the solid, before any step. */
#pragma once
#include "coupling/run.h"

enum { FLOW_LOAD_SENTENCE = 160 };
struct flow_load {
    double per_volume[3];              /* on the solid in the domain, N/m3 */
    double force;                      /* on all of it, N; 0: there is none that can be foreseen */
    double pressure;                   /* over the area of the solid as the flow sees it, Pa */
    char sentence[FLOW_LOAD_SENTENCE]; /* from what it follows */
};
/* The greater of two: what drives the flow along a direction (pressures of its two sides, a gradient, a body force)
 * times the domain's section, which the solid takes at most; the drag at the scene's velocity, as of grains
 * (physics/packed_drag.h) or of a blunt body in what is left of the section. Collective. */
struct flow_load flow_load_of(const struct run *r);
