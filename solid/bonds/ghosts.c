/* Copies displacements and velocities from owners to ghosts on other ranks. */
#include "solid/bonds/ghosts.h"
#include "base/par_ghost.h"

void solid_ghosts_begin(struct solid *s) {
    double *field[6];
    for (int c = 0; c < s->dim; c++) {
        field[c] = s->d[c];
        field[s->dim + c] = s->v[c];
    }
    par_ghost_begin(s->ghost, s->stage.damping_relative > 0 ? 2 * s->dim : s->dim, field, s->n);
}

void solid_ghosts_update(struct solid *s) {
    solid_ghosts_begin(s);
    par_ghost_end(s->ghost);
}
