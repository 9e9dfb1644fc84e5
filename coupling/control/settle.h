/* A stage that waits until the solid is at rest: the frequency of the slowest motion, and the damping that is critical
 * for it. */
#pragma once

struct run;

/* State (coupling/run_state.c). */
struct settle {
    double frequency; /* omega of the present deformation, rad/s; 0: the solid is not deformed yet */
    double damping;   /* k_a of a stage whose damping is automatic, 1/s */
};

/* 1: the damping of the present stage is automatic (stages[].damping_absolute: auto). Not collective. */
int settle_is_damped(const struct run *r);
/* At the start of a stage, or when a run is resumed within it, once the rates are known: shortens the stable step by
 * what the damping needs, and sets the present damping. Not collective. */
void settle_begin(struct run *r);
/* A part of the step: every few steps finds the frequency and sets the damping. Collective. */
void settle_damp(struct run *r);

/* The Rayleigh quotient of the displacement u: omega^2 = u.K u/u.M u with u.K u = 2 strain. Each component of u is
 * taken from the mean of the particles that are held in its direction, or, if there are none, of all.  (Underwood 1983)
 */
double settle_frequency(const struct run *r, double strain); /* rad/s; strain: J. Collective. */
