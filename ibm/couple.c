/* The couple of the forcing on the fluid. */
#include "base/par.h"
#include "ibm/state.h"

/* couple += x times force */
static void add(double couple[3], const double x[3], const double force[3]) {
    for (int c = 0; c < 3; c++) {
        const int a = (c + 1) % 3, b = (c + 2) % 3;
        couple[c] += x[a] * force[b] - x[b] * force[a];
    }
}

/* Sum of the weights of a line, and of weight times place from the domain's centre, m. */
static void line_moments(const struct fluid_grid *g, int d, int c, int start, const double weight[3], double sum[2]) {
    sum[0] = sum[1] = 0;
    for (int i = 0; i < 3; i++) {
        sum[0] += weight[i];
        sum[1] += weight[i] * ((g->lo[d] + start + i + (d == c ? 1 : 0.5)) * g->d[d] - 0.5 * g->length[d]);
    }
}

/* Of a piece of an edge, by the faces that it writes to: sides cut blocks, so the force need not act at the marker. */
static void add_piece(const struct fluid_grid *g, const struct ibm_block *block, const double force[3],
                      double couple[3]) {
    for (int c = 0; c < 3; c++) {
        const double *weight[3] = {block->x[c], block->y[c], block->z[c]};
        const ptrdiff_t from = block->at[c] - g->first + 3 * (g->plane + g->row + 1); /* at least 0: three ghosts */
        const int start[3] = {(int)(from % g->plane % g->row) - 3, (int)(from % g->plane / g->row) - 3,
                              (int)(from / g->plane) - 3};
        double line[3][2], x[3], alone[3] = {0, 0, 0};
        for (int d = 0; d < 3; d++) line_moments(g, d, c, start[d], weight[d], line[d]);
        for (int d = 0; d < 3; d++) x[d] = line[d][1] * line[(d + 1) % 3][0] * line[(d + 2) % 3][0];
        alone[c] = force[c];
        add(couple, x, alone);
    }
}

void ibm_couple_forcing(struct ibm *ibm, double dt, double couple[3]) {
    const struct fluid_grid *g = ibm->grid;
    const double scale = fluid_input_of(ibm->fluid)->density * g->d[0] * g->d[1] * g->d[2] / dt;
    for (int c = 0; c < 3; c++) couple[c] = 0;
    for (int h = 0; h < ibm->inner; h++) {
        const double *got = ibm->received[h];
        if (got[0] == 0 && got[1] == 0 && got[2] == 0) continue; /* inner fluid near a surface: most of a porous body */
        const double *item = ibm->route.served + (size_t)ibm->arrival[h] * IBM_ITEM;
        double x[3], force[3];
        for (int d = 0; d < 3; d++) {
            x[d] = item[IBM_X + d] * g->d[d] - 0.5 * g->length[d];
            force[d] = scale * got[d];
        }
        add(couple, x, force);
    }
    for (int p = 0; p < ibm->pieces; p++) {
        double force[3];
        for (int d = 0; d < 3; d++) force[d] = scale * ibm->received[ibm->inner + ibm->piece[p].edge][d];
        add_piece(g, &ibm->piece[p].write, force, couple);
    }
    par_sum_array(couple, 3);
}
