/* The weights of struts by their offset on the lattice. */
#pragma once
#include "cracks/kernel.h"
#include "solid/state.h"

/* omega = omega0 Gamma, with sum omega |xi| = 2 dim cell volumes over the full family. Then a plane cut of any
 * orientation has the area of the plane, because sum omega xi xi/|xi| is isotropic by the lattice's symmetry. */
struct cracks_table {
    int dim, reach;
    int kinds;              /* of struts; behind them come as many kinds of intact bonds, if there are pores */
    double omega0;          /* m2 */
    double *omega;          /* [2 kinds] m2; of intact bonds times Biot's coefficient */
    double *length;         /* [2 kinds] |xi|, m */
    signed char (*step)[3]; /* [2 kinds] X0_l - X0_h, spacings */
    cracks_vec *half;       /* [2 kinds] omega xi/(2 |xi|), m2 */
    short *number;          /* kind of a step, -1: none; [2 reach + 1]^3 */
};

/* Of a family of the material's horizon. Collective (same input on all ranks). */
void cracks_table_new(struct cracks_table *table, const struct solid_input *in, const struct solid_material *material);
/* Adds the kinds of intact bonds: kinds + k has Biot's coefficient times the weight of k. Not collective. */
void cracks_table_add_intact(struct cracks_table *table, double biot);
void cracks_table_free(struct cracks_table *table);
/* The kind of a step in spacings. Not collective. */
int cracks_table_number(const struct cracks_table *table, const signed char step[3]);
