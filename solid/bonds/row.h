/* A lattice's rows of eight sites, for measures: eight families at once. For solid/ only. */
#pragma once
#include "base/vec.h"
#include "solid/bonds/lattice.h"

/* One row: displacements and V_h/V0 of its lanes, and its bonds. */
struct solid_row {
    const struct solid_lattice *t; /* borrowed */
    const uint8_t *lambda;         /* [offsets of the stencil] bit k: lane k's bond is intact */
    const uint16_t *bond, *end;    /* the offsets at which some lane has a bond in its unbroken family, ascending */
    int cell, bulk;                /* bulk: alpha = 1 for all bonds */
    vec d[3], w;
};

/* Copies the present displacements to the dense box. Ghosts must be current. */
static inline void solid_row_begin(const struct solid *s, const struct solid_lattice *lattice) {
    for (int c = 0; c < 3; c++) {
        for (int r = 0; r < lattice->rows; r++)
            vec_store(lattice->d[c] + solid_lattice_place(lattice, lattice->row_cell[r]),
                      vec_spread(lattice->row_owned[r], s->d[c] + lattice->row_first[r]));
        for (int i = 0; i < lattice->away; i++) lattice->d[c][lattice->copy_at[i]] = s->d[c][lattice->copy_local[i]];
    }
}

static inline struct solid_row solid_row_of(const struct solid_lattice *lattice, int r) {
    struct solid_row row = {.t = lattice, .cell = lattice->row_cell[r], .bulk = lattice->row_bulk[r]};
    row.lambda = lattice->lambda + (size_t)r * (size_t)lattice->stencil->n;
    row.bond = lattice->active + lattice->row_active[r];
    row.end = lattice->active + lattice->row_active[r + 1];
    for (int c = 0; c < 3; c++) row.d[c] = vec_load(lattice->d[c] + solid_lattice_place(lattice, row.cell));
    row.w = vec_load(solid_lattice_w(lattice, row.cell));
    return row;
}

/* eta = d_l - d_h of the row's bonds at offset o, m. */
static inline void solid_row_eta(const struct solid_row *row, int o, vec eta[3]) {
    const long at = solid_lattice_place(row->t, row->cell + row->t->offset[o].shift);
    for (int c = 0; c < 3; c++) eta[c] = vec_load(row->t->d[c] + at) - row->d[c];
}

/* (|zeta|^2 - |xi|^2)/|xi|^2 = (2 xi.eta + eta.eta)/|xi|^2 */
static inline vec solid_row_eps(const struct solid_row *row, int o, const vec eta[3]) {
    const struct solid_lattice_offset *bond = &row->t->offset[o];
    vec q = eta[0] * (eta[0] + 2 * bond->xi[0]);
    for (int c = 1; c < 3; c++) q += eta[c] * (eta[c] + 2 * bond->xi[c]);
    return q * bond->inv_length2;
}

static inline vec solid_row_alpha(const struct solid_row *row, int o) {
    if (row->bulk) return vec_set(1);
    return 2 / (row->w + vec_load(solid_lattice_w(row->t, row->cell + row->t->offset[o].shift)));
}

/* Writes the values of the lanes that are owned particles, in order: to[i * stride] for the i-th. */
static inline void solid_row_put(const struct solid_lattice *lattice, int r, vec value, double *to, int stride) {
    for (int k = 0; k < VEC_LANES; k++)
        if (lattice->row_owned[r] >> k & 1) {
            *to = value[k];
            to += stride;
        }
}
