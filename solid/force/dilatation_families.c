/* Constants of each family: the weight of a full one, and the excess modulus. */
#include "solid/force/dilatation_families.h"
#include "physics/micromodulus.h"
#include "solid/bonds/lattice.h"
#include "solid/bonds/list.h"
#include "solid/law/material.h"

#include <math.h>

/* The sum of K |xi| V over a full family, N/m2. */
static double full_of_lattice(const struct solid *s, const struct solid_lattice *lattice,
                              const struct solid_material *material) {
    const double c0 = solid_material_micromodulus(material, s->in.spacing);
    double sum = 0;
    for (int o = 0; o < lattice->stencil->n; o++)
        sum += c0 * lattice->stencil->offset[o].weight * lattice->stencil->offset[o].length;
    return sum;
}

/* The size of a cell rounded to 1, 1/2, 1/4, ... */
static double side_of(const struct solid_end *h) { return ldexp(1, (int)rint(log2(h->size))); }

/* The same in a list, of cells of this side. */
static double full_of_list(const struct solid_list *list, double side, double horizon) {
    const struct solid_bond_law *law = &list->law;
    const int reach = (int)(horizon / side + 1), deep = law->dim == 3 ? reach : 0;
    double cell = list->unit, c = law->c, sum = 0;
    for (int k = 0; k < law->dim; k++) cell *= side;
    for (int k = 0; k <= law->dim; k++) c *= law->horizon / horizon; /* c0 is proportional to delta^-(dim + 1) */
    for (int z = -deep; z <= deep; z++)
        for (int y = -reach; y <= reach; y++)
            for (int x = -reach; x <= reach; x++) {
                const double xi[3] = {x * side, y * side, z * side},
                             length = sqrt((xi[0] * xi[0] + xi[1] * xi[1]) + xi[2] * xi[2]);
                if (length == 0 || !solid_pair_holds(law, xi, horizon, side)) continue;
                sum += c * law->micromodulus->profile(length / horizon) * cell *
                       solid_pair_gamma(law, xi, horizon, side) * length * list->spacing;
            }
    return sum;
}

/* The bulk modulus of a full family's bonds: under a strain theta/n in every direction their energy is 1/4 sum K
 * |xi| V (theta/n)^2 = 1/2 k_b theta^2. */
static double of_bonds(double full, int dim) { return full / (2 * dim * dim); }

void solid_dilatation_families(const struct solid *s, int b, double *full, double *excess) {
    const struct solid_family *f = s->family;
    const struct solid_list *list = f->list[b];
    double weight = 0, side = 0, horizon = 0;
    for (int h = f->first[b]; h < f->first[b + 1]; h++) {
        const struct solid_material *material = &s->in.material[solid_particle_material(s, h)];
        const struct solid_end *end = list ? &list->particle[h - list->first] : NULL;
        if (f->lattice[b] && (h == f->first[b] || s->material)) weight = full_of_lattice(s, f->lattice[b], material);
        if (end && (side_of(end) != side || end->horizon != horizon)) {
            side = side_of(end);
            horizon = end->horizon;
            weight = full_of_list(list, side, horizon);
        }
        full[h] = weight;
        excess[h] = 0;
        if (material->ratio_excess != 0)
            excess[h] = solid_material_dilatation(s->in.model, material).bulk_modulus - of_bonds(weight, s->dim);
    }
}
