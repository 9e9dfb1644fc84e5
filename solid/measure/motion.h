/* Mass, momentum, kinetic energy, mean displacement and forces of each body; computed only for output. */
#pragma once
#include "solid/state.h"

struct solid_motion {
    double mass, kinetic;   /* kg, J */
    double momentum[3];     /* N s */
    double displacement[3]; /* mean over the mass, m */
    double load[3];         /* external forces of the last substep: the loads and the body force, N */
    double contact[3];      /* of the other bodies on this one by contact, at the present places, N */
};

/* motion: [s->in.bodies], whole solid. Updates the ghosts. Collective. */
void solid_motion_measure(struct solid *s, struct solid_motion *motion);
/* Angular momentum of the whole solid about a point, N m s; of a plate along z alone. Particles stand where they have
 * moved to, beyond periodic sides as well. Collective. */
void solid_motion_angular_momentum(const struct solid *s, const double about[3], double out[3]);
