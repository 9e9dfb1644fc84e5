/* Field arrays of a lattice that is swept in double: filled before a sweep, read after it. */
#include "solid/bonds/row.h"
#include "solid/force/fields.h"

#include <string.h>

static void spread(const struct solid_lattice *lattice, int from, int to, double *const field[3],
                   double *const box[3]) {
    for (int r = from; r < to; r++) {
        const unsigned owned = lattice->row_owned[r];
        const int first = lattice->row_first[r];
        const long at = solid_lattice_place(lattice, lattice->row_cell[r]), ahead = solid_fields_ahead(lattice, r);
        for (int c = 0; c < 3; c++) {
            __builtin_prefetch(box[c] + ahead, 1);
            solid_row_expand(owned, field[c] + first, box[c] + at);
        }
    }
}

static double rows(const struct solid *s, const struct solid_lattice *lattice, int from, int to, int damped) {
    spread(lattice, from, to, s->d, lattice->d);
    if (damped) spread(lattice, from, to, s->v, lattice->v);
    return 0;
}

static double copies(const struct solid *s, const struct solid_lattice *lattice, int from, int to, int damped) {
    for (int i = from; i < to; i++) {
        const int at = lattice->copy_at[i], local = lattice->copy_local[i];
        for (int c = 0; c < 3; c++) lattice->d[c][at] = s->d[c][local];
        for (int c = 0; c < 3 && damped; c++) lattice->v[c][at] = s->v[c][local];
    }
    return 0;
}

static void end(const struct solid *s, const struct solid_lattice *lattice, int from, int to) {
    for (int r = from; r < to; r++) {
        const unsigned owned = lattice->row_owned[r];
        const int first = lattice->row_first[r];
        const long at = solid_lattice_place(lattice, lattice->row_cell[r]), ahead = solid_fields_ahead(lattice, r);
        for (int c = 0; c < 3; c++) {
            __builtin_prefetch(lattice->f[c] + ahead, 1);
            solid_row_compress(owned, lattice->f[c] + at, s->a[c] + first);
            memset(lattice->f[c] + at, 0, SOLID_ROW * sizeof *lattice->f[c]);
        }
    }
}

const struct solid_fields solid_fields_double = {rows, copies, end};
