/* Breaks bonds by limits of the stretch that follow the other bonds of the step before. */
#include "solid/force/sweep_limit.h"
#include "base/par_ghost.h"
#include "solid/bonds/breaks.h"
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
    struct bonds bonds = {s->family->lattice[body], s->family->list[body], h, 0, 0};
    if (bonds.lattice) {
        bonds.end = bonds.lattice->stencil->n;
    } else {
        bonds.first = bonds.list->start[h - bonds.list->first];
        bonds.end = bonds.list->end[h - bonds.list->first];
    }
    return bonds;
}

/* Both ends get the same value to the bit: all signs are opposite, nothing else differs (and CMakeLists.txt forbids
 * fused operations here). */
static inline double eps_of(int dim, const double *xi, const double *eta) {
    double q = 0, xi2 = 0;
    for (int c = 0; c < dim; c++) {
        q += eta[c] * (xi[c] + (xi[c] + eta[c]));
        xi2 += xi[c] * xi[c];
    }
    return q / xi2;
}

static inline double stretch_of(double eps) { return eps / (1 + sqrt(1 + eps)); }

/* Whether bond j of a list is intact, and its eps. */
static inline int list_eps(const struct solid_list *t, const double *here, long j, const int dim, double *eps) {
    if (!solid_list_is_swept(t, j)) return 0;
    const double *there = t->record + t->at[j];
    double xi[3], eta[3];
    for (int c = 0; c < dim; c++) {
        xi[c] = t->step[(j / SOLID_LIST_BLOCK * dim + c) * SOLID_LIST_BLOCK + j % SOLID_LIST_BLOCK];
        eta[c] = there[c] - here[c];
    }
    *eps = eps_of(dim, xi, eta);
    return 1;
}

/* The same of offset o on a lattice. */
static inline int lattice_eps(const struct solid *s, const struct solid_lattice *t, int h, long o, double *eps) {
    const int cell = t->cell[h - t->first];
    const size_t row = (size_t)t->row_of[cell / SOLID_ROW] * (size_t)t->stencil->n;
    if (!(t->lambda[row + (size_t)o] >> cell % SOLID_ROW & 1)) return 0;
    const int l = t->local[cell + t->offset[o].shift];
    double eta[3];
    for (int c = 0; c < 3; c++) eta[c] = s->d[c][l] - s->d[c][h];
    *eps = eps_of(3, t->stencil->offset[o].xi, eta);
    return 1;
}

static int other_of(const struct bonds *bonds, long j) {
    const struct solid_lattice *t = bonds->lattice;
    return t ? t->local[t->cell[bonds->h - t->first] + t->offset[j].shift] : solid_list_other(bonds->list, j);
}

static int is_beyond(const struct solid *s, int h, int l, double stretch) {
    return stretch > fmin(s->stretch_limit[h], s->stretch_limit[l]) && !((s->flag[h] | s->flag[l]) & SOLID_UNBREAKABLE);
}

/* Of this end's half of the bond, over the square of the stretch, J. */
static double energy_of(const struct solid *s, const struct bonds *bonds, long j) {
    const struct solid_lattice *t = bonds->lattice;
    if (!t) {
        double xi[3];
        const double length = solid_list_steps(bonds->list, j, xi);
        return 0.25 * bonds->list->law.density * fabs(bonds->list->stiffness[j]) * length *
               (length * bonds->list->spacing) * s->volume[bonds->h];
    }
    const int cell = t->cell[bonds->h - t->first];
    const double alpha = 2 / (*solid_lattice_w(t, cell) + *solid_lattice_w(t, cell + t->offset[j].shift));
    const struct solid_offset *offset = &t->stencil->offset[j];
    return 0.25 * t->law.c0 * alpha * offset->length * offset->weight * s->volume[bonds->h];
}

static void record(struct solid *s, const struct bonds *bonds, long j, double energy, double area) {
    double xi[3];
    if (bonds->lattice)
        memcpy(xi, bonds->lattice->stencil->offset[j].xi, sizeof xi);
    else
        solid_list_xi(bonds->list, j, xi);
    solid_breaks_add(s, bonds->h, other_of(bonds, j), xi, energy, area);
}

/* Breaks the bond on this side; the particle at the other end does the same. */
static void cut(struct solid *s, const struct bonds *bonds, long j, double stretch, const struct solid_limit *limit) {
    const double energy = energy_of(s, bonds, j), area = energy * limit->s00 * limit->s00 / limit->fracture_energy;
    s->e_fracture += energy * stretch * stretch;
    s->crack_area += area;
    if (s->breaks) record(s, bonds, j, energy * stretch * stretch, area);
    if (bonds->lattice)
        solid_lattice_cut(bonds->lattice, bonds->h, (int)j);
    else
        solid_list_set(bonds->list, j, 0);
    s->flag[bonds->h] |= SOLID_BROKEN;
    s->broke = 1;
}

/* Returns the least stretch of the particle's bonds, those that break included, and breaks those beyond their limit.
 * threshold: no bond of smaller eps is beyond a limit. */
static inline __attribute__((always_inline)) double break_beyond(struct solid *s, const struct bonds *bonds,
                                                                 double threshold, const struct solid_limit *limit,
                                                                 const int dim, const int on_lattice) {
    const double *here =
        on_lattice ? NULL : bonds->list->record + (long)bonds->list->width * (bonds->h - bonds->list->first);
    double least = INFINITY, eps;
    for (long j = bonds->first; j < bonds->end; j++) {
        if (!(on_lattice ? lattice_eps(s, bonds->lattice, bonds->h, j, &eps)
                         : list_eps(bonds->list, here, j, dim, &eps)))
            continue;
        least = eps < least ? eps : least;
        if (!(eps > threshold)) continue;
        const double stretch = stretch_of(eps);
        if (is_beyond(s, bonds->h, other_of(bonds, j), stretch)) cut(s, bonds, j, stretch, limit);
    }
    return least < INFINITY ? stretch_of(least) : INFINITY;
}

static double break_beyond_any(struct solid *s, const struct bonds *bonds, double threshold,
                               const struct solid_limit *limit) {
    if (bonds->lattice) return break_beyond(s, bonds, threshold, limit, 3, 1);
    return s->dim == 2 ? break_beyond(s, bonds, threshold, limit, 2, 0)
                       : break_beyond(s, bonds, threshold, limit, 3, 0);
}

/* eps below which no bond of this rank is beyond a limit, with room for rounding errors. */
static double threshold_of(const struct solid *s) {
    double least = INFINITY;
    for (int h = 0; h < s->n + s->n_ghost; h++) least = s->stretch_limit[h] < least ? s->stretch_limit[h] : least;
    return least > -1 ? least * (2 + least) - 1e-12 : -INFINITY;
}

void solid_sweep_limit(struct solid *s) {
    const struct solid_family *f = s->family;
    double *const limits[] = {s->stretch_limit};
    par_ghost_update(s->ghost, 1, limits, s->n);
    const double threshold = threshold_of(s);
    for (int b = 0; b < f->bodies; b++) {
        const struct solid_limit *limit = &s->in.limit[s->in.body[b].material];
        for (int h = f->first[b]; h < f->first[b + 1]; h++) {
            const struct bonds bonds = bonds_of(s, b, h);
            const double least = limit->s00 > 0 ? break_beyond_any(s, &bonds, threshold, limit) : INFINITY;
            s->stretch_limit_next[h] = least < INFINITY ? limit->s00 - limit->alpha * least : INFINITY;
        }
    }
    memcpy(s->stretch_limit, s->stretch_limit_next, (size_t)s->n * sizeof *s->stretch_limit);
}
