/* Bond forces on a row of eight particles of a plate's lattice (solid/bonds/list_rows.h), a vec of them at a time: the
 * kernel. For solid/ only. */
#pragma once
#include "solid/bonds/list_rows.h"
#include "solid/force/sweep_family.h"

/* The numbers of a row's particles first .. first + VEC_LANES - 1. */
static inline vec solid_sweep_rows_load(const double *values, const struct solid_list_row *row, int first) {
    double lane[VEC_LANES];
    for (int k = 0; k < VEC_LANES; k++) lane[k] = values[row->particle[first + k]];
    return vec_load(lane);
}

/* The sums of solid_sweep_family_of, to the bit, lane k for the row's particle first + k; of use where that is
 * whole. */
static inline __attribute__((always_inline)) struct solid_sweep_family
solid_sweep_rows_of(const struct solid_list *list, const struct solid_list_row *row, int first, double viscous,
                    const int damped) {
    const struct solid_list_rows *rows = list->rows;
    const int site = row->site + first;
    const vec zero = vec_set(0), rate = vec_set((rows->w + rows->w) * viscous),
              factor = vec_set(damped ? solid_list_headroom(list, row->particle[0]) : rows->digit),
              shift = solid_sweep_rows_load(list->power, row, first) * factor;
    struct solid_sweep_family sums = {{zero, zero, zero}, zero, zero, zero, zero};
    const double *const d[2] = {rows->d[0] + site, rows->d[1] + site};
    const double *const v[2] = {damped ? rows->v[0] + site : NULL, damped ? rows->v[1] + site : NULL};
    const vec here[2] = {vec_load(d[0]), vec_load(d[1])};
    vec speed[2];
    for (int c = 0; c < 2 && damped; c++) speed[c] = vec_load(v[c]);
    for (const struct solid_list_rows_bond *bond = rows->bond, *end = bond + rows->family; bond < end; bond++) {
        struct solid_sweep_bonds b = {.inverse = vec_set(bond->inverse), .k = vec_set(bond->stiffness)};
        for (int c = 0; c < 2; c++) {
            b.xi[c] = vec_set(bond->xi[c]);
            b.eta[c] = vec_load(d[c] + bond->shift) - here[c];
            if (damped) b.dv[c] = vec_load(v[c] + bond->shift) - speed[c];
        }
        if (damped) b.scale = vec_set(bond->per_length) * rate;
        solid_sweep_family_add(&sums, &b, VEC_ALL, shift, 2, 0, damped, 0);
    }
    return sums;
}
