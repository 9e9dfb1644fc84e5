/* The strongly coupled step: fluid, probe and solid again and again from the state at t_n, until the interface's
 * velocity that the fluid is given for t_{n+1} is the one that the solid answers with.  (Kuettler and Wall 2008) */
#pragma once

struct run;
struct strong; /* opaque */

/* NULL unless the scene asks for it and something immersed is elastic. Collective. */
struct strong *strong_new(struct run *r);
void strong_free(struct strong *k);
/* Forgets what earlier steps have taught, as a run does that is resumed from here. Not collective. */
void strong_forget(struct strong *k);
/* What sets the markers from the interface, and what takes the fluid through a step; before a stage's first. Not
 * collective. */
void strong_parts(struct strong *k, void (*markers)(struct run *r), void (*fluid)(struct run *r));
/* A part of the step. Collective. */
void strong_step(struct run *r);

/* Since the run began, or was resumed. */
struct strong_count {
    long steps, iterations, most, unconverged;
};
struct strong_count strong_count_of(const struct strong *k);
