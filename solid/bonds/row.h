/* A lattice's rows of eight sites: their numbers to and from the field arrays; and for measures their families, a vec
 * of them at once. For solid/ only. */
#pragma once
#include "base/vec.h"
#include "solid/bonds/lattice.h"

/* The sites first .. first + VEC_LANES - 1 of a row: displacements and V_h/V0, and their bonds. */
struct solid_row {
    const struct solid_lattice *t; /* borrowed */
    const uint8_t *lambda;         /* [offsets of the stencil] bit k: the bond of the row's site k is intact */
    const uint16_t *bond, *end;    /* the offsets at which some site has a bond in its unbroken family, ascending */
    int number, first;
    int cell, bulk; /* of the first site; bulk: alpha = 1 for all bonds */
    vec d[3], w;
};

/* The numbers of a row's owned particles, which are consecutive from `from` on, to its eight sites from `to` on; the
 * other sites get 0. */
static inline void solid_row_expand(unsigned owned, const double *from, double *to) {
    for (int k = 0; k < SOLID_ROW; k += VEC_LANES, owned >>= VEC_LANES) {
        vec_store(to + k, vec_expand(owned, from));
        from += __builtin_popcount(owned & VEC_ALL);
    }
}

/* The reverse: from a row's sites to its owned particles. */
static inline void solid_row_compress(unsigned owned, const double *from, double *to) {
    for (int k = 0; k < SOLID_ROW; k += VEC_LANES, owned >>= VEC_LANES) {
        vec_compress(owned, vec_load(from + k), to);
        to += __builtin_popcount(owned & VEC_ALL);
    }
}

/* Copies the present displacements to the dense box. Ghosts must be current. */
static inline void solid_row_begin(const struct solid *s, const struct solid_lattice *lattice) {
    for (int c = 0; c < 3; c++) {
        for (int r = 0; r < lattice->rows; r++)
            solid_row_expand(lattice->row_owned[r], s->d[c] + lattice->row_first[r],
                             lattice->d[c] + solid_lattice_place(lattice, lattice->row_cell[r]));
        for (int i = 0; i < lattice->away; i++) lattice->d[c][lattice->copy_at[i]] = s->d[c][lattice->copy_local[i]];
    }
}

/* Products of the components of each offset: xx, yy, zz, xy, yz, zx, m2. */
static inline void solid_row_squares(const struct solid_lattice *lattice, double (*square)[6]) {
    for (int o = 0; o < lattice->stencil->n; o++)
        for (int c = 0; c < 3; c++) {
            const double *xi = lattice->offset[o].xi;
            square[o][c] = xi[c] * xi[c];
            square[o][3 + c] = xi[c] * xi[(c + 1) % 3];
        }
}

static inline struct solid_row solid_row_of(const struct solid_lattice *lattice, int r, int first) {
    struct solid_row row = {
        .t = lattice, .number = r, .first = first, .cell = lattice->row_cell[r] + first, .bulk = lattice->row_bulk[r]};
    row.lambda = lattice->lambda + (size_t)r * (size_t)lattice->stencil->n;
    row.bond = lattice->active + lattice->row_active[r];
    row.end = lattice->active + lattice->row_active[r + 1];
    for (int c = 0; c < 3; c++) row.d[c] = vec_load(lattice->d[c] + solid_lattice_place(lattice, row.cell));
    row.w = vec_load(solid_lattice_w(lattice, row.cell));
    return row;
}

/* Bit k: the bond at offset o of lane k is intact. */
static inline unsigned solid_row_lambda(const struct solid_row *row, int o) { return row->lambda[o] >> row->first; }

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

/* Writes the values of the lanes that are owned particles: to[i * stride] for the i-th of the whole row. */
static inline void solid_row_put(const struct solid_row *row, vec value, double *to, int stride) {
    const unsigned owned = row->t->row_owned[row->number];
    to += __builtin_popcount(owned & ((1u << row->first) - 1)) * stride;
    for (int k = 0; k < VEC_LANES; k++)
        if (owned >> (row->first + k) & 1) {
            *to = value[k];
            to += stride;
        }
}
