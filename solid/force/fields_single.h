/* The field arrays of a lattice that is swept in mixed precision: what a sweep copies to them and from them. For solid/
 * only. */
#pragma once
#include "solid/bonds/lattice.h"
#include "solid/state.h"

/* Whether the displacements of the owned particles, or of the ghosts, may be rounded (segment_single.h). Pure. */
int solid_fields_single_are_near(const struct solid *s, const struct solid_lattice *lattice, int ghosts);
/* Copies displacements and, if damped, velocities, and clears the accelerations: of owned particles in rows from ..
 * to-1; of their periodic images; of ghosts. Not collective. */
void solid_fields_single_begin(const struct solid *s, const struct solid_lattice *lattice, int from, int to,
                               int damped);
void solid_fields_single_images(const struct solid *s, const struct solid_lattice *lattice, int damped);
void solid_fields_single_ghosts(const struct solid *s, const struct solid_lattice *lattice, int damped);
/* The accelerations of rows from .. to-1 to s->a. Not collective. */
void solid_fields_single_end(const struct solid *s, const struct solid_lattice *lattice, int from, int to);
