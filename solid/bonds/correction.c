/* Surface correction: computes w of every particle, of which alpha_hl = 2/(w_h + w_l). */
#include "solid/bonds/correction.h"
#include "base/memory.h"
#include "base/par_ghost.h"
#include "physics/micromodulus.h"
#include "solid/bonds/family.h"
#include "solid/bonds/lattice.h"
#include "solid/bonds/list.h"

#include <math.h>
#include <stdlib.h>

/* The directions e: of the stresses that are tried. A set for each dimension, closed under the lattice's symmetries. */
enum { IN_PLANE = 8, IN_SPACE = 13, MOST = IN_SPACE };
static const int in_plane[IN_PLANE][3] = {{1, 0, 0}, {0, 1, 0}, {1, 1, 0},  {1, -1, 0},
                                          {2, 1, 0}, {1, 2, 0}, {2, -1, 0}, {1, -2, 0}};
static const int in_space[IN_SPACE][3] = {{1, 0, 0},  {0, 1, 0},  {0, 0, 1}, {1, 1, 0},  {1, -1, 0},
                                          {1, 0, 1},  {1, 0, -1}, {0, 1, 1}, {0, 1, -1}, {1, 1, 1},
                                          {1, 1, -1}, {1, -1, 1}, {-1, 1, 1}};

/* The power that moves stiffness outwards, chosen by the bending stiffness of bars, plates and strips. */
static const double OUTWARD = 2.1;

static int directions(int dim) { return dim == 2 ? IN_PLANE : IN_SPACE; }

/* s^2 of a bond under a unit strain along direction k with free contraction across; nu = 1/4, in a plane 1/3. */
static double square_of_stretch(const double xi[3], int dim, int k) {
    const int *e = dim == 2 ? in_plane[k] : in_space[k];
    const double nu = dim == 2 ? 1. / 3 : 1. / 4, xi2 = (xi[0] * xi[0] + xi[1] * xi[1]) + xi[2] * xi[2],
                 along = (xi[0] * e[0] + xi[1] * e[1]) + xi[2] * e[2], e2 = e[0] * e[0] + e[1] * e[1] + e[2] * e[2],
                 s = (1 + nu) * (along * along / (e2 * xi2)) - nu;
    return s * s;
}

static double largest_ratio(const double *energy, const double *full, int n) {
    double most = 0;
    for (int k = 0; k < n; k++) most = fmax(most, energy[k] / full[k]);
    return most;
}

/* Psi of each direction for bonds of a lattice: [offset][MOST], and in `full` of the full family. */
static double (*lattice_energies(const struct solid_stencil *stencil, double *full))[MOST] {
    double(*energy)[MOST] = memory_new(MEMORY_SOLID, (size_t)stencil->n, sizeof *energy);
    for (int o = 0; o < stencil->n; o++)
        for (int k = 0; k < MOST; k++) {
            const struct solid_offset *bond = &stencil->offset[o];
            energy[o][k] = bond->weight * bond->length * square_of_stretch(bond->xi, 3, k);
            full[k] += energy[o][k];
        }
    return energy;
}

static void lattice_phi(const struct solid *s, const struct solid_lattice *lattice, double *phi) {
    const struct solid_stencil *stencil = lattice->stencil;
    double full[MOST] = {0}, (*energy)[MOST] = lattice_energies(stencil, full);
    for (int i = 0; i < lattice->n; i++) {
        const int h = lattice->first + i;
        double sum[MOST] = {0};
        phi[h] = 1;
        if (s->family_volume[h] == 0 || s->family_volume[h] == stencil->full_volume) continue;
        for (int o = 0; o < stencil->n; o++)
            for (int k = 0; lattice->local[lattice->cell[i] + lattice->offset[o].shift] >= 0 && k < MOST; k++)
                sum[k] += energy[o][k];
        phi[h] = largest_ratio(sum, full, MOST);
    }
    memory_free(energy);
}

/* <phi> - phi of the i-th particle. */
static double lattice_mean(const struct solid_lattice *lattice, int i, const double *phi) {
    double sum = 0;
    for (int o = 0; o < lattice->stencil->n; o++) {
        const int l = lattice->local[lattice->cell[i] + lattice->offset[o].shift];
        if (l >= 0) sum += lattice->stencil->offset[o].weight * (phi[l] - phi[lattice->first + i]);
    }
    return sum / lattice->stencil->full_volume;
}

/* Gamma V of a bond, spacings^dim, rounded so that sums of it are exact in any order: mirror images of a plate get the
 * same bits. */
static double volume_of(const struct solid_bond_law *law, const double xi[3], double horizon, double size,
                        double volume) {
    if (!solid_pair_holds(law, xi, horizon, size)) return 0;
    return solid_pair_rounded(law, horizon, solid_pair_gamma(law, xi, horizon, size) * volume);
}

/* Adds c |xi| s^2 Gamma V, over c0 delta, of a bond for each direction; rounded as well. */
static void add_energies(const struct solid_bond_law *law, const double xi[3], double horizon, double volume,
                         double *sum) {
    const double part = sqrt((xi[0] * xi[0] + xi[1] * xi[1]) + xi[2] * xi[2]) / horizon;
    const double weight = law->micromodulus->profile(part) * part * volume;
    for (int k = 0; k < directions(law->dim); k++)
        sum[k] += solid_pair_rounded(law, horizon, weight * square_of_stretch(xi, law->dim, k));
}

/* Psi of a full family of cells of one size. */
static void full_energies(const struct solid_bond_law *law, const struct solid_end *end, double *full) {
    const double side = ldexp(1, (int)rint(log2(end->size))), cell = law->dim == 3 ? side * side * side : side * side;
    const int reach = (int)(end->horizon / side + 1), deep = law->dim == 3 ? reach : 0;
    for (int k = 0; k < MOST; k++) full[k] = 0;
    for (int k = -deep; k <= deep; k++)
        for (int j = -reach; j <= reach; j++)
            for (int i = -reach; i <= reach; i++) {
                const double xi[3] = {i * side, j * side, k * side};
                if (i == 0 && j == 0 && k == 0) continue;
                const double volume = volume_of(law, xi, end->horizon, side, cell);
                if (volume > 0) add_energies(law, xi, end->horizon, volume, full);
            }
}

static void list_phi(const struct solid_list *list, double *phi) {
    struct solid_end last = {0};
    double full[MOST], volume_full = 0;
    for (int i = 0; i < list->n; i++) {
        const struct solid_end *h = &list->particle[i];
        double sum[MOST] = {0}, xi[3];
        if (h->size != last.size || h->horizon != last.horizon) {
            full_energies(&list->law, h, full);
            volume_full = solid_pair_full_volume(&list->law, h->horizon, h->size);
        }
        last = *h;
        phi[list->first + i] = 1;
        if (list->own_volume[i] == volume_full) continue;
        for (long j = list->start[i]; j < list->end[i]; j++) {
            const struct solid_end *l = &list->particle[solid_list_record(list, j)];
            solid_list_steps(list, j, xi);
            const double volume = volume_of(&list->law, xi, h->horizon, l->size, l->volume);
            if (volume > 0) add_energies(&list->law, xi, h->horizon, volume, sum);
        }
        const double ratio = largest_ratio(sum, full, directions(list->dim));
        phi[list->first + i] = ratio > 0 ? ratio : 1;
    }
}

static double list_mean(const struct solid_list *list, int i, const double *phi) {
    const struct solid_end *h = &list->particle[i];
    const double here = phi[list->first + i];
    double sum = 0, xi[3];
    int differs = 0;
    for (long j = list->start[i]; !differs && j < list->end[i]; j++) differs = phi[solid_list_other(list, j)] != here;
    if (!differs) return 0;
    for (long j = list->start[i]; j < list->end[i]; j++) {
        const int record = solid_list_record(list, j);
        const struct solid_end *l = &list->particle[record];
        solid_list_steps(list, j, xi);
        sum += solid_pair_rounded(&list->law, h->horizon,
                                  volume_of(&list->law, xi, h->horizon, l->size, l->volume) *
                                      (phi[solid_list_local(list, record)] - here));
    }
    return sum / solid_pair_full_volume(&list->law, h->horizon, h->size);
}

static void exchange(struct solid *s, double *values) { par_ghost_update(s->ghost, 1, &values, s->n); }

/* Whether the body's families are those of one lattice, so that what they lack was cut by a surface. */
static int is_regular(const struct solid *s, int b) { return !s->refine && s->in.body[b].shape != SOLID_POINTS; }

static void by_energy(struct solid *s, double *w) {
    const struct solid_family *f = s->family;
    double *phi = memory_new(MEMORY_SOLID, (size_t)(s->n + s->n_ghost) + 1, sizeof *phi);
    for (int b = 0; b < f->bodies; b++) {
        if (f->lattice[b])
            lattice_phi(s, f->lattice[b], phi);
        else
            list_phi(f->list[b], phi);
    }
    exchange(s, phi);
    for (int b = 0; b < f->bodies; b++)
        for (int h = f->first[b]; is_regular(s, b) && h < f->first[b + 1]; h++) {
            const double mean = f->lattice[b] ? lattice_mean(f->lattice[b], h - f->first[b], phi)
                                              : list_mean(f->list[b], h - f->first[b], phi),
                         sharp = phi[h] / (phi[h] + mean);
            w[h] = phi[h] * pow(sharp, OUTWARD);
        }
    memory_free(phi);
}

static void by_volume(const struct solid *s, double *w) {
    const struct solid_family *f = s->family;
    for (int b = 0; b < f->bodies; b++) {
        if (f->list[b]) solid_list_ratios(f->list[b], s->family_volume, w);
        for (int h = f->first[b]; f->lattice[b] && h < f->first[b + 1]; h++) /* 1 where no bonds are */
            w[h] = s->family_volume[h] > 0 ? s->family_volume[h] / f->lattice[b]->stencil->full_volume : 1;
    }
}

void solid_correction_of(struct solid *s, double *w) {
    for (int h = 0; h < s->n + s->n_ghost; h++) w[h] = 1;
    switch (s->in.surface_correction) {
    case SOLID_CORRECTION_NONE:
        return;
    case SOLID_CORRECTION_ENERGY:
        by_volume(s, w);
        by_energy(s, w);
        break;
    case SOLID_CORRECTION_VOLUME:
        by_volume(s, w);
        break;
    }
    exchange(s, w);
}
