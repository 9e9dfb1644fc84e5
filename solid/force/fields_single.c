/* Field arrays of a lattice that is swept in mixed precision: filled before a sweep, read after it. */
#include "solid/force/fields_single.h"
#include "base/vecf.h"
#include "solid/force/segment_single.h"

#include <math.h>

static double farthest(int n, const double *d) {
    double most = 0;
    for (int i = 0; i < n; i++) most = fabs(d[i]) > most ? fabs(d[i]) : most;
    return most;
}

int solid_fields_single_are_near(const struct solid *s, const struct solid_lattice *lattice, int ghosts) {
    double most = 0;
    for (int c = 0; c < 3; c++) {
        if (!ghosts) most = fmax(most, farthest(lattice->n, s->d[c] + lattice->first));
        for (int i = 0; ghosts && i < lattice->ghosts; i++) most = fmax(most, fabs(s->d[c][lattice->copy_local[i]]));
    }
    return most <= SOLID_SINGLE_NEAR * s->in.spacing;
}

void solid_fields_single_begin(const struct solid *s, const struct solid_lattice *lattice, int from, int to,
                               int damped) {
    for (int c = 0; c < 3; c++)
        for (int r = from; r < to; r++) {
            const unsigned owned = lattice->row_owned[r];
            const int first = lattice->row_first[r];
            const long at = solid_lattice_place(lattice, lattice->row_cell[r]);
            const vec d = vec_spread(owned, s->d[c] + first);
            vec_store(lattice->d[c] + at, d);
            vecf_store(lattice->d_single[c] + at, vecf_of(d));
            vecf_store(lattice->f_single[c] + at, vecf_set(0));
            if (damped) vecf_store(lattice->v_single[c] + at, vecf_of(vec_spread(owned, s->v[c] + first)));
        }
}

static void copies(const struct solid *s, const struct solid_lattice *lattice, int from, int to, int damped) {
    for (int c = 0; c < 3; c++)
        for (int i = from; i < to; i++) {
            const int at = lattice->copy_at[i], local = lattice->copy_local[i];
            lattice->d[c][at] = s->d[c][local];
            lattice->d_single[c][at] = (float)s->d[c][local];
            if (damped) lattice->v_single[c][at] = (float)s->v[c][local];
        }
}

void solid_fields_single_images(const struct solid *s, const struct solid_lattice *lattice, int damped) {
    copies(s, lattice, lattice->ghosts, lattice->away, damped);
    for (int c = 0; c < 3; c++)
        for (int i = 0; i < lattice->away; i++) lattice->f_single[c][lattice->copy_at[i]] = 0;
}

void solid_fields_single_ghosts(const struct solid *s, const struct solid_lattice *lattice, int damped) {
    copies(s, lattice, 0, lattice->ghosts, damped);
}

void solid_fields_single_end(const struct solid *s, const struct solid_lattice *lattice, int from, int to) {
    for (int c = 0; c < 3; c++)
        for (int r = from; r < to; r++)
            vec_press(lattice->row_owned[r],
                      vec_load_floats(lattice->f_single[c] + solid_lattice_place(lattice, lattice->row_cell[r])),
                      s->a[c] + lattice->row_first[r]);
}
