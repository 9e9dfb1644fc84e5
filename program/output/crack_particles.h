/* crack_particles.csv: when which particle of a plate was first damaged. */
#pragma once
#include "solid/measure/crack.h"

struct crack_particles; /* opaque */

/* damaged: all particles that are damaged now; a resumed run continues the file and knows from it which of them have a
 * row. Collective. */
struct crack_particles *crack_particles_new(const char *folder, const struct solid_crack_particles *damaged,
                                            double spacing, long resume_step);
/* Writes a row for each damaged particle that has none. Collective. */
void crack_particles_sample(struct crack_particles *k, const struct solid_crack_particles *damaged, long step,
                            double t);
void crack_particles_free(struct crack_particles *k);
