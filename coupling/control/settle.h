/* A stage that waits until the solid is at rest: the frequency of the slowest motion, and the damping that is critical
 * for it. */
#pragma once

struct run;

/* State (coupling/run_state.c). */
struct settle {
    double frequency; /* omega of the present deformation, rad/s; 0: the solid is not deformed yet */
    double damping;   /* k_a of a stage whose damping is automatic, 1/s */
};

/* At the start of a stage, or when a run is resumed within it, once the rates are known: shortens the stable step by
 * what the damping needs, and sets the present damping. Not collective. */
void settle_begin(struct run *r);
/* A part of the step: every few steps finds the frequency and sets the damping. Collective. */
void settle_damp(struct run *r);
