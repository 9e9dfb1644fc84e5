/* Breaks bonds by limits of the stretch that follow the other bonds of the step before. */
#include "solid/force/sweep_limit.h"
#include "base/par_ghost.h"
#include "solid/bonds/lattice.h"
#include "solid/bonds/list.h"

#include <math.h>
#include <string.h>

/* One particle's bonds in either store: their numbers are first .. end-1. */
struct bonds {
    struct solid_lattice *lattice; /* NULL: */
    struct solid_list *list;
    int h;
    long first, end;
};

static struct bonds bonds_of(const struct solid *s, int body, int h) {
    struct bonds of = {s->family->lattice[body], s->family->list[body], h, 0, 0};
    if (of.lattice) {
        of.end = of.lattice->stencil->n;
    } else {
        of.first = of.list->start[h - of.list->first];
        of.end = of.list->end[h - of.list->first];
    }
    return of;
}

/* The other end of an intact bond and xi, m; -1: there is no such bond. */
static int other_end(const struct bonds *of, long j, double xi[3]) {
    const struct solid_lattice *t = of->lattice;
    if (!t) {
        if (!solid_list_is_swept(of->list, j)) return -1;
        solid_list_xi(of->list, j, xi);
        return solid_list_other(of->list, j);
    }
    const int cell = t->cell[of->h - t->first];
    const size_t row = (size_t)t->row_of[cell / SOLID_ROW] * (size_t)t->stencil->n;
    if (!(t->lambda[row + (size_t)j] >> cell % SOLID_ROW & 1)) return -1;
    memcpy(xi, t->stencil->offset[j].xi, sizeof t->stencil->offset[j].xi);
    return t->local[cell + t->offset[j].shift];
}

/* Both ends get the same value to the bit: all signs are opposite, nothing else differs. */
static __attribute__((noinline)) double stretch_of(const struct solid *s, int h, int l, const double xi[3]) {
    double q = 0, xi2 = 0;
    for (int c = 0; c < s->dim; c++) {
        const double eta = s->d[c][l] - s->d[c][h];
        q += eta * (xi[c] + (xi[c] + eta));
        xi2 += xi[c] * xi[c];
    }
    const double eps = q / xi2;
    return eps / (1 + sqrt(1 + eps));
}

static int is_beyond(const struct solid *s, int h, int l, double stretch) {
    return stretch > fmin(s->limit[h], s->limit[l]) && !((s->flag[h] | s->flag[l]) & SOLID_UNBREAKABLE);
}

/* Of this end's half of the bond, over the square of the stretch, J. */
static double energy_of(const struct solid *s, const struct bonds *of, long j) {
    const struct solid_lattice *t = of->lattice;
    if (!t) {
        double xi[3];
        const double length = solid_list_steps(of->list, j, xi);
        return 0.25 * of->list->law.density * fabs(of->list->stiffness[j]) * length * (length * of->list->spacing) *
               s->volume[of->h];
    }
    const int cell = t->cell[of->h - t->first];
    const double alpha = 2 / (*solid_lattice_w(t, cell) + *solid_lattice_w(t, cell + t->offset[j].shift));
    const struct solid_offset *offset = &t->stencil->offset[j];
    return 0.25 * t->law.c0 * alpha * offset->length * offset->weight * s->volume[of->h];
}

/* Breaks the bond on this side; the particle at the other end does the same. */
static void cut(struct solid *s, const struct bonds *of, long j, double stretch, const struct solid_limit *limit) {
    const double energy = energy_of(s, of, j);
    s->e_fracture += energy * stretch * stretch;
    s->crack_area += energy * limit->s00 * limit->s00 / limit->fracture_energy;
    if (of->lattice)
        solid_lattice_cut(of->lattice, of->h, (int)j);
    else
        solid_list_set(of->list, j, 0);
    s->flag[of->h] |= SOLID_BROKEN;
    s->broke = 1;
}

/* Returns the least stretch of the particle's bonds, those that break included. */
static double judge(struct solid *s, int body, int h, const struct solid_limit *limit) {
    const struct bonds of = bonds_of(s, body, h);
    double least = INFINITY;
    for (long j = of.first; j < of.end; j++) {
        double xi[3];
        const int l = other_end(&of, j, xi);
        if (l < 0) continue;
        const double stretch = stretch_of(s, h, l, xi);
        least = fmin(least, stretch);
        if (is_beyond(s, h, l, stretch)) cut(s, &of, j, stretch, limit);
    }
    return least;
}

void solid_sweep_limit(struct solid *s) {
    const struct solid_family *f = s->family;
    double *const limits[] = {s->limit};
    par_ghost_update(s->ghost, 1, limits, s->n);
    for (int b = 0; b < f->bodies; b++) {
        const struct solid_limit *limit = &s->in.limit[s->in.body[b].material];
        for (int h = f->first[b]; h < f->first[b + 1]; h++) {
            const double least = limit->s00 > 0 ? judge(s, b, h, limit) : INFINITY;
            s->limit_next[h] = least < INFINITY ? limit->s00 - limit->alpha * least : INFINITY;
        }
    }
    memcpy(s->limit, s->limit_next, (size_t)s->n * sizeof *s->limit);
}
