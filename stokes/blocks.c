/* Blocks of cells, and the cycle over them. */
#include "stokes/blocks.h"
#include "base/memory.h"
#include "base/par.h"
#include "stokes/kernels.h"

#include <math.h>
#include <string.h>

#define LONG 1.5 /* over the shortest edge: such an edge is left as it is */
enum { LEVELS = 24, FEW = 8 /* blocks: the last level */, PIECE = 64 };
enum { FULL = 7 /* on this level four to the power of eight faces may join two blocks: more than 16 bits hold */ };

/* Blocks of one size; the last entry of an array, [n], is 0. */
struct level {
    int n, (*next)[6];       /* n: none */
    uint16_t (*joins)[3][3]; /* [axis][c] of a block and its high neighbour along an axis: pairs of faces */
    float unit[3];           /* [axis] the weight of a join, 1/m2 */
    float (*inverse)[3];     /* 1/diagonal; 0: no face of the component is open */
    float (*b)[3], (*e)[3];
};

struct stokes_blocks {
    const struct stokes_cells *cells;
    const struct stokes_faces *faces;
    float inverse[3][256]; /* 1/diagonal of faces; 0 on sides of given pressure too, which are left to themselves */
    int levels;
    struct level level[LEVELS];
    int *block[LEVELS]; /* [n of the level before, first of cells] the block that it belongs to */
};

/* The blocks of a list of cells or blocks in the order of layers, whose places become the blocks'. join: how many along
 * each axis make one. Returns how many there are. */
static int gather(int n, int (*at)[3], const int size[3], const int join[3], int *block) {
    const int wide = size[0] / join[0] + 1, deep = size[1] / join[1] + 1;
    int *of_layer = memory_new(MEMORY_FLUID, (size_t)wide * (size_t)deep + 1, sizeof *of_layer), blocks = 0;
    int layer = -1;
    for (int i = 0; i < n; i++) {
        const int to[3] = {at[i][0] / join[0], at[i][1] / join[1], at[i][2] / join[2]};
        if (to[2] != layer) memset(of_layer, -1, (size_t)wide * (size_t)deep * sizeof *of_layer);
        layer = to[2];
        int *place = &of_layer[to[1] * wide + to[0]];
        if (*place < 0) {
            memcpy(at[blocks], to, sizeof to);
            *place = blocks++;
        }
        block[i] = *place;
    }
    memory_free(of_layer);
    return blocks;
}

static void level_new(struct level *l, int n) {
    const size_t size = (size_t)n + 1;
    l->n = n;
    l->next = memory_new(MEMORY_FLUID, size, sizeof *l->next);
    l->joins = memory_new(MEMORY_FLUID, size, sizeof *l->joins);
    l->inverse = memory_new(MEMORY_FLUID, size, sizeof *l->inverse);
    l->b = memory_new(MEMORY_FLUID, size, sizeof *l->b);
    l->e = memory_new(MEMORY_FLUID, size, sizeof *l->e);
    for (int a = 0; a < n; a++)
        for (int q = 0; q < 6; q++) l->next[a][q] = n;
}

/* Adds the joins of two members of blocks a and b, its high neighbour along the axis; the diagonal is in `inverse`
 * until all are there. shift: a power of two by which they are counted. */
static void add(struct level *l, int a, int b, int axis, int c, int joins, int shift) {
    if (a == b) {
        l->inverse[a][c] -= 2 * l->unit[axis] * (float)joins / (float)(1 << shift);
        return;
    }
    l->next[a][2 * axis + 1] = b;
    l->next[b][2 * axis] = a;
    l->joins[a][axis][c] = (uint16_t)(l->joins[a][axis][c] + (joins >> shift));
}

static void soften(struct level *l) {
    for (int axis = 0; axis < 3; axis++) l->unit[axis] /= STOKES_BLOCKS_SOFTER;
    for (int a = 0; a < l->n; a++)
        for (int c = 0; c < 3; c++)
            l->inverse[a][c] = l->inverse[a][c] > 0 ? STOKES_BLOCKS_SOFTER / l->inverse[a][c] : 0;
}

static void add_faces(struct stokes_blocks *b) {
    struct level *l = &b->level[0];
    const double *d = b->cells->g->in.d;
    for (int axis = 0; axis < 3; axis++) l->unit[axis] = (float)(1 / (d[axis] * d[axis]));
    for (int i = 0; i < b->cells->n; i++)
        for (int c = 0; c < 3; c++) {
            const int a = b->block[0][i];
            if (!(b->inverse[c][b->faces->kind[i][c]] > 0)) continue;
            l->inverse[a][c] += b->faces->single[c][b->faces->kind[i][c]];
            for (int axis = 0; axis < 3; axis++) {
                const int to = b->cells->next[i][2 * axis + 1];
                if (to < b->cells->n && b->inverse[c][b->faces->kind[to][c]] > 0)
                    add(l, a, b->block[0][to], axis, c, 1, 0);
            }
        }
    soften(l);
}

static void add_blocks(const struct level *fine, struct level *l, const int *block, int shift) {
    for (int axis = 0; axis < 3; axis++) l->unit[axis] = fine->unit[axis] * (float)(1 << shift);
    for (int i = 0; i < fine->n; i++)
        for (int c = 0; c < 3; c++) {
            if (fine->inverse[i][c] > 0) l->inverse[block[i]][c] += 1 / fine->inverse[i][c];
            for (int axis = 0; axis < 3; axis++)
                if (fine->joins[i][axis][c] > 0)
                    add(l, block[i], block[fine->next[i][2 * axis + 1]], axis, c, fine->joins[i][axis][c], shift);
        }
    soften(l);
}

/* Joins two along each axis, of flat or long blocks only along the shorter edges, until they are about cubes. */
static void choose_axes(double edge[3], int join[3]) {
    const double least = fmin(edge[0], fmin(edge[1], edge[2]));
    for (int c = 0; c < 3; c++) {
        join[c] = edge[c] < LONG * least ? 2 : 1;
        edge[c] *= join[c];
    }
}

static void build(struct stokes_blocks *b) {
    const struct stokes_mask *m = b->cells->g->mask;
    int n = b->cells->n, (*at)[3] = memory_new(MEMORY_FLUID, (size_t)n + 1, sizeof *at);
    int size[3] = {m->n[0], m->n[1], m->n[2]}, join[3];
    double edge[3];
    memcpy(edge, b->cells->g->in.d, sizeof edge);
    if (n > 0) stokes_mask_find(m, b->cells->first[par_rank()], at[0]);
    for (int i = 1; i < n; i++) {
        memcpy(at[i], at[i - 1], sizeof *at);
        stokes_mask_next(m, at[i]);
    }
    while (b->levels < LEVELS && n > FEW) {
        const int k = b->levels++;
        b->block[k] = memory_new(MEMORY_FLUID, (size_t)n + 1, sizeof *b->block[k]);
        choose_axes(edge, join);
        level_new(&b->level[k], gather(n, at, size, join, b->block[k]));
        if (k == 0)
            add_faces(b);
        else
            add_blocks(&b->level[k - 1], &b->level[k], b->block[k], k < FULL ? 0 : 2);
        n = b->level[k].n;
        for (int c = 0; c < 3; c++) size[c] = (size[c] + join[c] - 1) / join[c];
    }
    memory_free(at);
}

struct stokes_blocks *stokes_blocks_new(const struct stokes_cells *cells, const struct stokes_faces *faces) {
    struct stokes_blocks *b = memory_new(MEMORY_FLUID, 1, sizeof *b);
    b->cells = cells;
    b->faces = faces;
    for (int c = 0; c < 3; c++)
        for (int kind = 0; kind < STOKES_FACES_KINDS / 2; kind++) b->inverse[c][kind] = faces->inverse[c][kind];
    build(b);
    return b;
}

void stokes_blocks_free(struct stokes_blocks *b) {
    if (!b) return;
    for (int k = 0; k < b->levels; k++) {
        struct level *l = &b->level[k];
        MEMORY_FREE(b->block[k], l->next, l->joins, l->inverse, l->b, l->e);
    }
    memory_free(b);
}

static inline float around(const struct level *l, int i, int c) {
    const int *q = l->next[i];
    float sum = 0;
    for (int axis = 0; axis < 3; axis++)
        sum += l->unit[axis] * ((float)l->joins[q[2 * axis]][axis][c] * l->e[q[2 * axis]][c] +
                                (float)l->joins[i][axis][c] * l->e[q[2 * axis + 1]][c]);
    return sum;
}

/* One Gauss-Seidel sweep over blocks. */
static void sweep(struct level *l, int up) {
    for (int k = 0; k < l->n; k++) {
        const int i = up ? k : l->n - 1 - k;
        for (int c = 0; c < 3; c++) l->e[i][c] = l->inverse[i][c] * (l->b[i][c] + around(l, i, c));
    }
}

/* The residual of a level, summed by the blocks of the next one. */
static void restrict_blocks(const struct level *l, const int *block, struct level *next) {
    memset(next->b, 0, (size_t)next->n * sizeof *next->b);
    for (int i = 0; i < l->n; i++)
        for (int c = 0; c < 3; c++)
            if (l->inverse[i][c] > 0)
                next->b[block[i]][c] += l->b[i][c] + around(l, i, c) - l->e[i][c] / l->inverse[i][c];
}

static void cycle(struct stokes_blocks *b, int k) {
    struct level *l = &b->level[k];
    memset(l->e, 0, (size_t)l->n * sizeof *l->e);
    sweep(l, 1);
    if (k + 1 < b->levels) {
        struct level *next = &b->level[k + 1];
        restrict_blocks(l, b->block[k + 1], next);
        cycle(b, k + 1);
        for (int i = 0; i < l->n; i++)
            for (int c = 0; c < 3; c++)
                if (l->inverse[i][c] > 0) l->e[i][c] += next->e[b->block[k + 1][i]][c];
    }
    sweep(l, 0);
}

/* One Gauss-Seidel sweep over faces. */
static void sweep_faces(const struct stokes_blocks *b, int up, const float (*r)[3], float (*z)[3]) {
    const double *d = b->cells->g->in.d;
    const float w[3] = {(float)(1 / (d[0] * d[0])), (float)(1 / (d[1] * d[1])), (float)(1 / (d[2] * d[2]))};
    for (int k = 0; k < b->cells->n; k++) {
        const int i = up ? k : b->cells->n - 1 - k, *q = b->cells->next[i];
        for (int c = 0; c < 3; c++) {
            const float sum =
                w[1] * (z[q[2]][c] + z[q[3]][c]) + w[2] * (z[q[4]][c] + z[q[5]][c]) + w[0] * (z[q[0]][c] + z[q[1]][c]);
            z[i][c] = b->inverse[c][b->faces->kind[i][c]] * (r[i][c] + sum);
        }
    }
}

/* The residual r - A z on faces, summed by blocks; by so many cells at once. */
static void restrict_faces(struct stokes_blocks *b, const float (*r)[3], const float (*z)[3]) {
    const struct stokes_cells *cells = b->cells;
    const int *block = b->block[0];
    struct level *l = &b->level[0];
    float product[PIECE][3];
    memset(l->b, 0, (size_t)l->n * sizeof *l->b);
    for (int first = 0; first < cells->n; first += PIECE) {
        const int end = first + PIECE < cells->n ? first + PIECE : cells->n;
        const uint8_t(*kind)[3] = (const uint8_t(*)[3])b->faces->kind;
        stokes_kernels_viscous(first, end, (const int(*)[6])cells->next, kind, (const float(*)[256])b->faces->single,
                               cells->g->in.d, z, product);
        for (int i = first; i < end; i++)
            for (int c = 0; c < 3; c++)
                if (b->inverse[c][kind[i][c]] > 0) l->b[block[i]][c] += r[i][c] - product[i - first][c];
    }
}

void stokes_blocks_cycle(struct stokes_blocks *b, const float (*r)[3], float (*z)[3]) {
    const struct stokes_cells *cells = b->cells;
    const uint8_t(*kind)[3] = (const uint8_t(*)[3])b->faces->kind;
    memset(z, 0, stokes_cells_size(cells) * sizeof *z);
    sweep_faces(b, 1, r, z);
    stokes_cells_fill(cells, sizeof *z, z);
    if (b->levels > 0) {
        restrict_faces(b, r, (const float(*)[3])z);
        cycle(b, 0);
        for (int i = 0; i < cells->n; i++)
            for (int c = 0; c < 3; c++)
                if (b->inverse[c][kind[i][c]] > 0) z[i][c] += b->level[0].e[b->block[0][i]][c];
    }
    stokes_cells_fill(cells, sizeof *z, z);
    sweep_faces(b, 0, r, z);
    for (int h = 0; h < b->faces->halves; h++) {
        const int i = b->faces->half[h].cell, c = cells->g->axis;
        z[i][c] = b->faces->inverse[c][kind[i][c]] * r[i][c];
    }
}
