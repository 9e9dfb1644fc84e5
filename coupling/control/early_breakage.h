/* Whether bonds begin to break before the solid is at rest, and how far its load is from breaking the first one. */
#pragma once
#include "solid/measure/reach.h"

struct run;

enum { EARLY_BREAKAGE_SENTENCE = 400 };
/* For the start of a stage in which bonds may break, if other stages came before: warns if the solid still moves, or
 * if it moves for the first time in a flow, so that its whole load acts at once. Returns whether there is a warning.
 * Collective. */
int early_breakage_of(struct run *r, char sentence[EARLY_BREAKAGE_SENTENCE]);
/* The last two samples of the flow's load on the solid. All 0: none yet. */
struct early_breakage_load {
    double t[2], force[2][3]; /* s, N */
    int samples;              /* 0, 1 or 2 */
};
void early_breakage_load_add(struct early_breakage_load *u, double t, const double force[3]);
/* For the start of the first stage in which bonds may break in a flow: warns if the load still changes, at a rate by
 * which it would change by more than a twentieth within the stage. every: steps between two samples. Returns whether
 * there is a warning. */
int early_breakage_flow_of(const struct run *r, const struct early_breakage_load *u, long every,
                           char sentence[EARLY_BREAKAGE_SENTENCE]);
/* For the end of a stage in which the solid moved or was relaxed and no bond broke: the bond that is nearest to its
 * limit; part 0: nothing has been stretched, bonds do not break, or have begun to. Collective. */
struct solid_reach early_breakage_reach(struct run *r);
