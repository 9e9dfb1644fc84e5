/* Reactions of constraints and total forces of loads, as means over a step. For solid/ and for the coupling.
 *
 * The reaction is the force of the support on its held particles: the opposite of what bonds, contact, loads, body
 * force and damping give them. It is summed up by the integrator's own quadrature, so that over a step the momentum of
 * the other particles changes by exactly its impulse and that of the loads. The inertia of driven particles is not in
 * it. */
#pragma once
#include "solid/state.h"

struct solid_reactions; /* opaque: s->reactions */

/* s->reactions; the solid then sums up reactions in each of its sweeps. Not collective. */
void solid_reactions_new(struct solid *s);
void solid_reactions_free(struct solid_reactions *r);

/* All below do nothing if s->reactions is NULL; only solid_reactions_measure is collective. */

/* At the start of a step, or of its repetition: forgets the impulses. */
void solid_reactions_begin(struct solid *s);
/* In a sweep: takes the held particles' forces from s->a, before constraints set it to 0. */
void solid_reactions_find(struct solid *s);
/* Adds `now` times the forces of the last sweep and `then` times those of the sweep before, s. */
void solid_reactions_add(struct solid *s, double now, double then);
/* Adds the reaction to an impulse on particle h that is not in the sweeps' forces, N s; s->reactions must not be NULL.
 */
void solid_reactions_add_impulse(struct solid *s, int h, const double impulse[3]);
/* Takes account of a push (solid/step/push.h), which changes the force on particle h by `change`, N, after the last
 * sweep. The reaction of that sweep changes by -change, and its impulse by -change dt/2. */
void solid_reactions_push(struct solid *s, int h, const double change[3], double dt);

/* Adds the impulses over the last step of constraints, loads, indenters, walls and absolute damping, this rank's share,
 * N s. */
void solid_reactions_impulse(const struct solid *s, double impulse[3]);

/* Of a constraint, a load or an indenter. */
struct solid_reaction {
    long particles;         /* in the region; of an indenter those inside it now */
    double force[3];        /* on the solid, mean over the last step, N; NAN: no step yet */
    double displacement[3]; /* mean over the particles' volume, m; of an indenter its own */
};
/* Constraints first, then loads, then indenters: reaction [constraints + loads + indenters]. Where regions overlap, the
 * last one has a particle's reaction in a direction. Collective. */
void solid_reactions_measure(struct solid *s, struct solid_reaction *reaction);
