/* Markers whose kernel reaches over the boundary of this rank's cells: pieces, weights, sums.  (001: eqs 3.79-3.82) */
/* An edge is a marker whose block reaches over a side of this rank's cells. Its block is divided at the borders to
 * other ranks and at periodic sides, and folded at the domain's other sides. */
#include "ibm/state.h"

#include <math.h>
#include <string.h>

/* One direction of a block before it is divided, for each component, in cells of the whole domain. */
struct line {
    int first[3];
    double read[3][3], write[3][3];
    double constant[3];
};

/* A side gives the normal velocity on its faces: it is a wall, a slip side, an inflow. Not an outflow, whose faces move
 * with the fluid. */
static int is_given(const struct fluid_mirror *normal) { return normal->inner < 0; }

/* Values beyond a side are read as the boundary condition continues them. Force is not spread beyond a side, and to the
 * faces on the side only if these are free, that is if the pressure is given there. What belongs beyond is folded back
 * as of a marker's mirror image, so a force along a side is given to the fluid as a whole: the pressure that a plug
 * bears is the same in each cell of its face, up to the wall.
 *
 * Across a side whose normal velocity is given, the faces on it and beyond are neither read nor written. Of a marker
 * whose kernel reaches over them only the fraction p, the sum of the weights that are left, is within: it demands p V
 * of what it reads there, and the solid gets p of its force, as the fluid does. Where the fluid within moves with the
 * marker nothing is demanded, however near the side is, and reading and spreading are adjoint. If the side's own
 * velocity were read, the faces within would have to be faster than the body, up to six times.
 *
 *     centres, low:   [-1] | 0  1          [-1] = inner [0] + constant
 *     faces, low:     [-2] -1  0           [-2] = face [-1] + inner [0] + constant,  -1 the side's own
 * and the same mirrored at the high side. No block reaches farther.
 *
 * A marker whose block reaches beyond a no-slip wall belongs to a body that stands on the wall: no fluid that is
 * resolved flows between them. So along the wall velocities are read with the weights that spread the force, and the
 * wall's own velocity is not. With the wall's, a body that moves along it found its velocity only between the wall and
 * a first cell that was faster than the body: a block drawn along a wall pumped fluid below itself. As reading and
 * spreading are adjoint, the forcing with feedback takes no energy from nowhere there. */
static void fold(const struct ibm *ibm, int d, int c, struct line *l) {
    const int n = ibm->grid->n[d], on_face = c == d, low = on_face ? -1 : 0, high = n - 1;
    double w[3];
    memcpy(w, l->read[c], sizeof w);
    for (int i = 0; i < 3; i++) {
        const int at = l->first[c] + i, beyond = at < low || at > high, side = at > high, in = side ? -1 : 1;
        const struct fluid_mirror *m = &ibm->mirror[c][d][at >= high];
        const int is_across = on_face && (beyond || at == low || at == high);
        if (beyond || (is_across && !m->is_free)) l->write[c][i] = 0;
        if (beyond || (is_across && is_given(m))) l->read[c][i] = 0;
        if (!beyond || (is_across && is_given(m))) continue;
        if (!on_face && ibm->is_wall[d][side]) {
            l->read[c][i + in] += w[i];
            l->write[c][i + in] += w[i];
            continue;
        }
        l->constant[c] += w[i] * m->constant;
        if (on_face) l->read[c][i + in] += w[i] * m->face;
        l->read[c][i + (on_face ? 2 : 1) * in] += w[i] * m->inner;
        if (!on_face || (m->is_free && m->inner > 0)) l->write[c][i + (on_face ? 2 : 1) * in] += w[i] * fabs(m->inner);
    }
}

static void line_set(const struct ibm *ibm, int d, int cell, double s, struct line *l) {
    const double t = s - cell - 0.5;
    for (int c = 0; c < 3; c++) {
        ibm_kernel_weights(c == d ? ibm_kernel_face(t) : t, l->read[c]);
        l->first[c] = cell - 1 - (c == d && t < 0);
        memcpy(l->write[c], l->read[c], sizeof l->write[c]);
        l->constant[c] = 0;
        if (!ibm->grid->periodic[d]) fold(ibm, d, c, l);
    }
}

double ibm_edge_fraction(const struct ibm *ibm, int d, double s) {
    double fraction = 1;
    for (int side = 0; side < 2 && !ibm->grid->periodic[d]; side++) {
        const double to = side ? ibm->grid->n[d] - s : s;
        if (is_given(&ibm->mirror[d][d][side]) && to < IBM_KERNEL_REACH)
            fraction -= ibm_kernel(to) + ibm_kernel(to + 1);
    }
    return fraction;
}

/* The weights of the cells of this rank, with the block moved by `image` cells, and the cell where they start. The
 * three values lie inside this rank's cells, if it has at least three. */
static int cut(const struct fluid_grid *g, int d, int c, int image, int first, const double from[3], double to[3]) {
    const int low = c == d && !g->periodic[d] && g->lo[d] == 0 ? -1 : 0, local = first - g->lo[d] + image;
    int start = local;
    if (start > g->m[d] - 3) start = g->m[d] - 3;
    if (start < low) start = low;
    to[0] = to[1] = to[2] = 0;
    for (int i = 0; i < 3; i++)
        if (local + i >= low && local + i < g->m[d]) to[local + i - start] = from[i];
    return start;
}

static void block_set(const struct fluid_grid *g, const struct line line[3], const int image[3], int write,
                      struct ibm_block *block) {
    for (int c = 0; c < 3; c++) {
        double *to[3] = {block->x[c], block->y[c], block->z[c]};
        int start[3];
        for (int d = 0; d < 3; d++)
            start[d] = cut(g, d, c, image[d], line[d].first[c], write ? line[d].write[c] : line[d].read[c], to[d]);
        block->x[c][3] = 0;
        block->at[c] = (ptrdiff_t)fluid_grid_at(g, start[0], start[1], start[2]);
    }
}

/* The periodic images of a marker's block that reach this rank's cells, as shifts in cells along a direction. Returns
 * their number. */
static int images(const struct fluid_grid *g, int d, int cell, int image[3]) {
    int count = 0;
    for (int k = -g->periodic[d]; k <= g->periodic[d]; k++) {
        const int at = cell + k * g->n[d] - g->lo[d];
        if (at + IBM_BEHIND >= 0 && at - IBM_BEFORE < g->m[d]) image[count++] = k * g->n[d];
    }
    return count;
}

/* All combinations of the images along the three directions. */
static int all_images(const struct fluid_grid *g, const int cell[3], int image[IBM_PIECES][3]) {
    int along[3][3], count[3], pieces = 0;
    for (int d = 0; d < 3; d++) count[d] = images(g, d, cell[d], along[d]);
    for (int k = 0; k < count[2]; k++)
        for (int j = 0; j < count[1]; j++)
            for (int i = 0; i < count[0] && pieces < IBM_PIECES; i++, pieces++) {
                image[pieces][0] = along[0][i];
                image[pieces][1] = along[1][j];
                image[pieces][2] = along[2][k];
            }
    return pieces;
}

int ibm_edge_planes(const struct ibm *ibm, const int cell[3], int plane[IBM_PIECES]) {
    int image[IBM_PIECES][3];
    const int pieces = all_images(ibm->grid, cell, image);
    for (int p = 0; p < pieces; p++) plane[p] = cell[2] + image[p][2] - ibm->grid->lo[2];
    return pieces;
}

void ibm_edge_set(struct ibm *ibm, struct ibm_edge *e) {
    struct line line[3];
    int image[IBM_PIECES][3];
    const int pieces = all_images(ibm->grid, e->cell, image);
    for (int d = 0; d < 3; d++) line_set(ibm, d, e->cell[d], e->s[d], &line[d]);
    for (int c = 0; c < 3; c++) {
        e->constant[c] = 0;
        e->share[c] = 1;
        for (int d = 0; d < 3; d++) { /* x is folded first, then y, then z */
            const double *r = line[d].read[c], *w = line[d].write[c];
            e->constant[c] = e->constant[c] * (r[0] + r[1] + r[2]) + line[d].constant[c];
            e->share[c] *= w[0] + w[1] + w[2];
        }
    }
    for (int p = 0; p < pieces; p++) {
        struct ibm_piece *piece = &ibm->piece[e->piece[p]];
        block_set(ibm->grid, line, image[p], 0, &piece->read);
        block_set(ibm->grid, line, image[p], 1, &piece->write);
    }
}

void ibm_edge_sum(struct ibm *ibm, double *const u[3], int first_piece, int last_piece) {
    const ptrdiff_t row = ibm->grid->row, plane = ibm->grid->plane;
    for (int p = first_piece; p < last_piece; p++) {
        const struct ibm_block *block = &ibm->piece[p].read;
        double *sum = ibm->sum[ibm->piece[p].edge];
        for (int c = 0; c < 3; c++)
            sum[c] += ibm_kernel_gather(u[c] + block->at[c], row, plane, block->x[c], block->y[c], block->z[c]);
    }
}

void ibm_edge_sum_spread(struct ibm *ibm, double *const u[3]) {
    const ptrdiff_t row = ibm->grid->row, plane = ibm->grid->plane;
    for (int p = 0; p < ibm->pieces; p++) {
        const struct ibm_block *block = &ibm->piece[p].write;
        double *sum = ibm->sum[ibm->piece[p].edge];
        for (int c = 0; c < 3; c++)
            sum[c] += ibm_kernel_gather(u[c] + block->at[c], row, plane, block->x[c], block->y[c], block->z[c]);
    }
}

void ibm_edge_finish(struct ibm *ibm, int first, int last, enum ibm_record record, struct ibm_tally *t) {
    for (int e = first; e < last; e++) {
        const struct ibm_edge *edge = &ibm->edge[e];
        double *increment = ibm->increment[ibm->inner + e];
        for (int c = 0; c < 3; c++) {
            double velocity = edge->constant[c];
            for (int k = 0; k < edge->summands; k++) velocity += ibm->sum[edge->summand[k]][c];
            const double lack = edge->v[c] - velocity;
            increment[c] = lack * edge->volume;
            if (!edge->mine) continue;
            t->impulse[c] += increment[c] * edge->share[c];
            t->squares += lack * lack;
        }
        ibm_record(ibm->received[ibm->inner + e], increment, record);
    }
    for (int e = first; e < last; e++)
        for (int c = 0; c < 3; c++) ibm->sum[e][c] = 0;
}

void ibm_edge_velocity(struct ibm *ibm, int with_sides, double (*velocity)[3]) {
    for (int e = 0; e < ibm->edges; e++) {
        const struct ibm_edge *edge = &ibm->edge[e];
        for (int c = 0; c < 3; c++) {
            velocity[e][c] = with_sides ? edge->constant[c] : 0;
            for (int k = 0; k < edge->summands; k++) velocity[e][c] += ibm->sum[edge->summand[k]][c];
        }
    }
    for (int e = 0; e < ibm->edges; e++)
        for (int c = 0; c < 3; c++) ibm->sum[e][c] = 0;
}

void ibm_edge_scatter(const struct ibm *ibm, double *const u[3], int first_piece, int last_piece) {
    const ptrdiff_t row = ibm->grid->row, plane = ibm->grid->plane;
    for (int p = first_piece; p < last_piece; p++) {
        const struct ibm_block *block = &ibm->piece[p].write;
        const double *increment = ibm->increment[ibm->inner + ibm->piece[p].edge];
        for (int c = 0; c < 3; c++)
            ibm_kernel_scatter(u[c] + block->at[c], row, plane, block->x[c], block->y[c], block->z[c], increment[c]);
    }
}
