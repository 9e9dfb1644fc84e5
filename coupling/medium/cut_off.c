/* Cells that no path through pore cells joins to an outlet: their part of a side, and what moving solid displaces into
 * them. */
#include "base/par.h"
#include "base/par_halo.h"
#include "coupling/medium/parts.h"

#include <math.h>
#include <string.h>

/* Sets all cells of the domain; those of the rim stay walls. */
static void set_cells(struct medium *m) {
    const struct fluid_grid *g = m->g;
    for (int k = 0; k < g->m[2]; k++)
        for (int j = 0; j < g->m[1]; j++)
            for (int i = 0; i < g->m[0]; i++)
                m->cell[medium_rimmed(g, i, j, k)] =
                    medium_kernels_is_pore(m->fraction[fluid_grid_at(g, i, j, k)]) ? MEDIUM_PORE : MEDIUM_WALL;
}

/* This rank's cells along a side, and the number of them that the flood has reached. start: the flood enters the pores
 * among them, which are put on the stack after n. */
struct along {
    int cells, reached;
};
static struct along along_side(struct medium *m, int d, int high, int start, int n) {
    const struct fluid_grid *g = m->g;
    int from[3] = {0, 0, 0}, to[3] = {g->m[0], g->m[1], g->m[2]};
    struct along sum = {0};
    if (!medium_at_end(g, d, high)) return sum;
    if (high)
        from[d] = g->m[d] - 1;
    else
        to[d] = 1;
    for (int k = from[2]; k < to[2]; k++)
        for (int j = from[1]; j < to[1]; j++)
            for (int i = from[0]; i < to[0]; i++) {
                const int at = medium_rimmed(g, i, j, k);
                sum.cells++;
                if (m->cell[at] != (start ? MEDIUM_PORE : MEDIUM_FRONT)) continue;
                if (start) m->cell[at] = MEDIUM_FRONT, m->stack[n + sum.reached] = at;
                sum.reached++;
            }
    return sum;
}

static void flood_from(struct medium *m, const int outlets[3][2], const int over[3]) {
    int n = 0;
    set_cells(m);
    for (int c = 0; c < 3; c++)
        for (int side = 0; side < 2; side++)
            if (outlets[c][side]) n += along_side(m, c, side, 1, n).reached;
    medium_connect_flood(m, MEDIUM_FRONT, n, over);
}

double medium_cut_off(struct medium *m, int d, int high, const int outlets[3][2], int across) {
    const struct fluid_grid *g = m->g;
    int over[3];
    for (int c = 0; c < 3; c++) over[c] = g->periodic[c] && (c != d || across);
    flood_from(m, outlets, over);
    const struct along side = along_side(m, d, high, 0, 0);
    const long cells = par_sum_long(side.cells), reached = par_sum_long(side.reached);
    memset(m->cell, MEDIUM_WALL, (size_t)(g->m[0] + 2) * (size_t)(g->m[1] + 2) * (size_t)(g->m[2] + 2));
    m->effective = -1;
    return 1 - (double)reached / (double)cells;
}

void medium_cut_off_mark(const struct medium *m, const double v[3], double *const velocity[3]) {
    const struct fluid_grid *g = m->g;
    for (int k = 0; k < g->m[2]; k++)
        for (int j = 0; j < g->m[1]; j++)
            for (int i = 0; i < g->m[0]; i++) {
                const size_t at = fluid_grid_at(g, i, j, k);
                for (int c = 0; c < 3 && !medium_kernels_is_pore(m->fraction[at]); c++) velocity[c][at] = v[c];
            }
    par_halo_fill(g->halos, 3, velocity, 1);
}

void medium_cut_off_begin(struct medium *m, const int outlets[3][2]) { flood_from(m, outlets, m->g->periodic); }

/* Adds the faces of cell i,j,k: the volume that moving solid beyond them displaces into the cell in a second, and its
 * magnitude. */
static void add_faces(const struct fluid_grid *g, const double *const velocity[3], int i, int j, int k, double *rate,
                      double *faces) {
    const ptrdiff_t stride[3] = {1, g->row, g->plane};
    const size_t at = fluid_grid_at(g, i, j, k);
    for (int c = 0; c < 3; c++) {
        const double area = g->d[(c + 1) % 3] * g->d[(c + 2) % 3];
        const double low = velocity[c][(ptrdiff_t)at - stride[c]], high = velocity[c][(ptrdiff_t)at + stride[c]];
        *rate += area * (low - high);
        *faces += area * (fabs(low) + fabs(high));
    }
}

int medium_cut_off_next(struct medium *m, const double *const velocity[3], struct medium_part *part) {
    const struct fluid_grid *g = m->g;
    const size_t rimmed = (size_t)(g->m[0] + 2) * (size_t)(g->m[1] + 2) * (size_t)(g->m[2] + 2);
    size_t first = rimmed;
    int n = 0;
    for (size_t at = 0; at < rimmed; at++) {
        if (m->cell[at] == MEDIUM_FRONT) m->cell[at] = MEDIUM_WALL; /* looked at already */
        if (m->cell[at] == MEDIUM_PORE && first == rimmed) first = at;
    }
    const int rank = (int)par_min(first < rimmed ? par_rank() : par_size());
    if (rank == par_size()) {
        memset(m->cell, MEDIUM_WALL, rimmed);
        m->effective = -1;
        return 0;
    }
    if (rank == par_rank()) m->cell[first] = MEDIUM_FRONT, m->stack[n++] = (int)first;
    medium_connect_flood(m, MEDIUM_FRONT, n, g->periodic);
    double sum[4] = {0}; /* volume; rate; faces; of all cells: fronts */
    for (int k = 0; k < g->m[2]; k++)
        for (int j = 0; j < g->m[1]; j++)
            for (int i = 0; i < g->m[0]; i++) {
                const size_t at = fluid_grid_at(g, i, j, k);
                double rate = 0, faces = 0;
                if (velocity[0][at] != 0 || velocity[1][at] != 0 || velocity[2][at] != 0) continue;
                add_faces(g, velocity, i, j, k, &rate, &faces);
                sum[3] += faces;
                if (m->cell[medium_rimmed(g, i, j, k)] != MEDIUM_FRONT) continue;
                sum[0] += g->d[0] * g->d[1] * g->d[2];
                sum[1] += rate;
                sum[2] += faces;
            }
    par_sum_array(sum, 4);
    *part = (struct medium_part){sum[0], sum[1], sum[2], 0.5 * sum[3]};
    return 1;
}
