/* Field arrays of a lattice that is swept in mixed precision: filled before a sweep, read after it. */
#include "base/vecf.h"
#include "solid/force/fields.h"

#include <math.h>

static void velocities(const struct solid *s, const struct solid_lattice *lattice, int from, int to) {
    for (int r = from; r < to; r++) {
        const unsigned owned = lattice->row_owned[r];
        const int first = lattice->row_first[r];
        const long at = solid_lattice_place(lattice, lattice->row_cell[r]), ahead = solid_fields_ahead(lattice, r);
        for (int c = 0; c < 3; c++) {
            __builtin_prefetch(lattice->v_single[c] + ahead, 1);
            vecf_store(lattice->v_single[c] + at, vecf_of(vec_spread(owned, s->v[c] + first)));
        }
    }
}

static double rows(const struct solid *s, const struct solid_lattice *lattice, int from, int to, int damped) {
    vec most = vec_set(0);
    for (int r = from; r < to; r++) {
        const unsigned owned = lattice->row_owned[r];
        const int first = lattice->row_first[r];
        const long at = solid_lattice_place(lattice, lattice->row_cell[r]), ahead = solid_fields_ahead(lattice, r);
        for (int c = 0; c < 3; c++) {
            const vec d = vec_spread(owned, s->d[c] + first);
            __builtin_prefetch(lattice->d_single[c] + ahead, 1);
            most = vec_absmax(most, d);
            if (!lattice->is_near) vec_store(lattice->d[c] + at, d);
            vecf_store(lattice->d_single[c] + at, vecf_of(d));
        }
    }
    if (damped) velocities(s, lattice, from, to);
    return vec_highest(most);
}

static double copies(const struct solid *s, const struct solid_lattice *lattice, int from, int to, int damped) {
    double most = 0;
    for (int i = from; i < to; i++) {
        const int at = lattice->copy_at[i], local = lattice->copy_local[i];
        for (int c = 0; c < 3; c++) {
            most = fmax(most, fabs(s->d[c][local]));
            if (!lattice->is_near) lattice->d[c][at] = s->d[c][local];
            lattice->d_single[c][at] = (float)s->d[c][local];
        }
        for (int c = 0; c < 3 && damped; c++) lattice->v_single[c][at] = (float)s->v[c][local];
    }
    return most;
}

static void end(const struct solid *s, const struct solid_lattice *lattice, int from, int to) {
    for (int r = from; r < to; r++) {
        const unsigned owned = lattice->row_owned[r];
        const int first = lattice->row_first[r];
        const long at = solid_lattice_place(lattice, lattice->row_cell[r]), ahead = solid_fields_ahead(lattice, r);
        for (int c = 0; c < 3; c++) {
            __builtin_prefetch(lattice->f_single[c] + ahead, 1);
            vec_press(owned, vec_load_floats(lattice->f_single[c] + at), s->a[c] + first);
            vecf_store(lattice->f_single[c] + at, vecf_set(0));
        }
    }
}

const struct solid_fields solid_fields_single = {rows, copies, end};
