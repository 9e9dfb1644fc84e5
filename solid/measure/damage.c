/* Damage of each particle: the broken part of its family's volume. */
#include "solid/bonds/list.h"
#include "solid/bonds/row.h"
#include "solid/measure/damage.h"

/* sum(Gamma V) of the intact bonds. */
static vec intact_of(const struct solid_row *row) {
    vec sum = vec_set(0);
    for (const uint16_t *bond = row->bond; bond < row->end; bond++)
        sum += vec_where(solid_row_lambda(row, *bond), vec_set(row->t->stencil->offset[*bond].weight));
    return sum;
}

/* phi of the row's owned particles, which are the n from h on; phi is not changed if no bond of the row is broken. */
static void of_row(const struct solid *s, const struct solid_lattice *lattice, int r, double *phi) {
    const int h = lattice->row_first[r], n = __builtin_popcount(lattice->row_owned[r]);
    int broken = 0;
    for (int i = h; i < h + n; i++) {
        broken |= s->flag[i] & SOLID_BROKEN;
        phi[i] = 0;
    }
    if (!broken) return;
    for (int first = 0; first < SOLID_ROW; first += VEC_LANES) {
        const struct solid_row row = solid_row_of(lattice, r, first);
        solid_row_put(&row, intact_of(&row), phi + h, 1);
    }
    for (int i = h; i < h + n; i++)
        phi[i] = s->flag[i] & SOLID_BROKEN && s->family_volume[i] > 0 ? 1 - phi[i] / s->family_volume[i] : 0;
}

void solid_damage_measure(const struct solid *s, double *phi) {
    for (int b = 0; b < s->family->bodies; b++) {
        const struct solid_lattice *lattice = s->family->lattice[b];
        for (int r = 0; lattice && r < lattice->rows; r++) of_row(s, lattice, r, phi);
        for (int h = s->family->first[b]; !lattice && h < s->family->first[b + 1]; h++)
            phi[h] = s->flag[h] & SOLID_BROKEN ? solid_list_damage(s->family->list[b], h) : 0;
    }
}
