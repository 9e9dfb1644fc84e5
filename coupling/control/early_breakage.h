/* Whether bonds begin to break before the solid is at rest, and how far its load is from breaking the first one. */
#pragma once

struct run;

enum { EARLY_BREAKAGE_SENTENCE = 400 };
/* At the start of a stage in which bonds may break, after others: the solid still moves, or it moves for the first time
 * in a flow, so that its load acts at once. Returns whether there is something to say. Collective. */
int early_breakage_of(struct run *r, char sentence[EARLY_BREAKAGE_SENTENCE]);
/* The last two samples of the flow's load on the solid. All 0: none yet. */
struct early_breakage_load {
    double t[2], force[2][3]; /* s, N */
    int samples;              /* 0, 1 or 2 */
};
void early_breakage_load_add(struct early_breakage_load *u, double t, const double force[3]);
/* At the start of a stage in which bonds begin to be allowed to break in a flow: the load still changes, by so much per
 * time that it would change by more than a twentieth of itself within the stage. every: steps between two samples.
 * Returns whether there is something to say. */
int early_breakage_flow_of(const struct run *r, const struct early_breakage_load *u, long every,
                           char sentence[EARLY_BREAKAGE_SENTENCE]);
/* At the end of a stage that moved a solid of which no bond has broken: the largest stretch of a bond over the critical
 * one of the weakest material, which it returns; 0: nothing has been stretched, bonds do not break, have begun to, or
 * soften. *critical: the critical stretch; *modulus: E of that material, Pa. Collective. */
double early_breakage_strained(struct run *r, double *critical, double *modulus);
