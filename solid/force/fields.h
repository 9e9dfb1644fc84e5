/* The field arrays of a lattice: what a sweep copies to them and from them, in double or in mixed precision. For solid/
 * only. */
#pragma once
#include "solid/bonds/lattice.h"
#include "solid/state.h"

/* rows and copies copy displacements and, if damped, velocities, and return the largest size of a component of a
 * displacement, m. In double this is 0, because nothing depends on it. In mixed precision displacements are copied in
 * double only if lattice->is_near is 0. Not collective. */
struct solid_fields {
    /* of owned particles in rows from .. to-1 */
    double (*rows)(const struct solid *s, const struct solid_lattice *lattice, int from, int to, int damped);
    /* of copies from .. to-1: ghosts, images */
    double (*copies)(const struct solid *s, const struct solid_lattice *lattice, int from, int to, int damped);
    /* The accelerations of rows from .. to-1 to s->a; clears them for the next sweep. Those of copies are never read.
     */
    void (*end)(const struct solid *s, const struct solid_lattice *lattice, int from, int to);
};

extern const struct solid_fields solid_fields_double, solid_fields_single;

static inline const struct solid_fields *solid_fields_of(const struct solid_lattice *lattice) {
    return lattice->w_single ? &solid_fields_single : &solid_fields_double;
}

/* The index in the field arrays of a row some rows after row r, which is fetched while that one is copied. */
static inline long solid_fields_ahead(const struct solid_lattice *lattice, int r) {
    enum { AHEAD = 8 };
    return solid_lattice_place(lattice, lattice->row_cell[r + AHEAD < lattice->rows ? r + AHEAD : r]);
}
