/* The strongly coupled step: repeats fluid, probe and solid from the state at t_n, until the interface velocity given
 * to the fluid for t_{n+1} equals the one that the solid returns.  (Kuettler and Wall 2008) */
#pragma once

struct run;
struct strong; /* opaque */

/* NULL unless the scene asks for strong coupling and an immersed solid is elastic. Collective. */
struct strong *strong_new(struct run *r);
void strong_free(struct strong *k);
/* Forgets earlier iterations, as in a resumed run. Not collective. */
void strong_forget(struct strong *k);
/* A part of the step. Collective. */
void strong_step(struct run *r);

/* Counts since the run began or was resumed. */
struct strong_count {
    long steps, iterations, most, unconverged;
};
struct strong_count strong_count_of(const struct strong *k);
