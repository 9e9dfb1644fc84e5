/* Field arrays of a lattice that is swept in mixed precision: filled before a sweep, read after it. */
#include "base/vecf.h"
#include "solid/force/fields.h"

#include <math.h>
#include <string.h>

/* The numbers of a row's owned particles to its sites, in single. */
static inline void spread_single(unsigned owned, const double *from, float *to) {
    for (int k = 0; k < SOLID_ROW; k += VEC_LANES, owned >>= VEC_LANES) {
        vecf_store(to + k, vecf_of(vec_expand(owned, from)));
        from += __builtin_popcount(owned & VEC_ALL);
    }
}

static void velocities(const struct solid *s, const struct solid_lattice *lattice, int from, int to) {
    for (int r = from; r < to; r++) {
        const unsigned owned = lattice->row_owned[r];
        const int first = lattice->row_first[r];
        const long at = solid_lattice_place(lattice, lattice->row_cell[r]), ahead = solid_fields_ahead(lattice, r);
        for (int c = 0; c < 3; c++) {
            __builtin_prefetch(lattice->v_single[c] + ahead, 1);
            spread_single(owned, s->v[c] + first, lattice->v_single[c] + at);
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
            const double *own = s->d[c] + first;
            __builtin_prefetch(lattice->d_single[c] + ahead, 1);
            for (int k = 0; k < SOLID_ROW; k += VEC_LANES) {
                const vec d = vec_expand(owned >> k, own);
                own += __builtin_popcount(owned >> k & VEC_ALL);
                most = vec_absmax(most, d);
                if (!lattice->is_near) vec_store(lattice->d[c] + at + k, d);
                vecf_store(lattice->d_single[c] + at + k, vecf_of(d));
            }
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

static inline void press_single(unsigned owned, const float *from, double *to) {
    for (int k = 0; k < SOLID_ROW; k += VEC_LANES, owned >>= VEC_LANES) {
        vec_compress(owned, vec_load_floats(from + k), to);
        to += __builtin_popcount(owned & VEC_ALL);
    }
}

static void end(const struct solid *s, const struct solid_lattice *lattice, int from, int to) {
    for (int r = from; r < to; r++) {
        const unsigned owned = lattice->row_owned[r];
        const int first = lattice->row_first[r];
        const long at = solid_lattice_place(lattice, lattice->row_cell[r]), ahead = solid_fields_ahead(lattice, r);
        for (int c = 0; c < 3; c++) {
            __builtin_prefetch(lattice->f_single[c] + ahead, 1);
            press_single(owned, lattice->f_single[c] + at, s->a[c] + first);
            memset(lattice->f_single[c] + at, 0, SOLID_ROW * sizeof *lattice->f_single[c]);
        }
    }
}

const struct solid_fields solid_fields_single = {rows, copies, end};
