/* A symmetric matrix whose off-diagonal entries are not positive, M_ij = -w_ij, on the cells of this rank or on
 * aggregates of them. On cells the weights follow from coefficients on faces; on aggregates they are stored by rows. */
#pragma once
#include "base/par_ghost.h"
#include <stddef.h>
#include <stdint.h>
#include <string.h>

enum { STOKES_LEVEL_ROW = 6 }; /* entries of a row of cells */

struct stokes_level {
    int n, ghosts;
    long *first;             /* [ranks + 1] global numbers of each rank's rows */
    struct par_ghost *ghost; /* of the columns of other ranks */
    /* on cells, borrowed, with first and ghost: w of cell i and its high neighbour along c is phi[i][c] scale[c] */
    const int (*next)[6];
    const uint16_t (*phi)[3]; /* [n + ghosts + 1] upper halves of floats: exact to 0.4 % */
    float scale[3];
    /* on aggregates, owned */
    int *start, *column; /* [n + 1], [start[n]]; n .. n + ghosts - 1: ghosts */
    float *weight;       /* [start[n]] */
    float *inverse;      /* [n] 1/diagonal; 0: no unknown */
    float *extra;        /* [n] diagonal less the row's weights; NULL: 0 */
    int *coarse;         /* [n] the aggregate that it belongs to; -1: none. NULL on the last level */
};

static inline float stokes_level_phi(uint16_t upper) {
    const uint32_t bits = (uint32_t)upper << 16;
    float value;
    memcpy(&value, &bits, sizeof value);
    return value;
}
static inline uint16_t stokes_level_upper(float value) {
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    return (uint16_t)(bits >> 16);
}

/* A row's entries: their number, columns and weights, in the given arrays or in the level. */
struct stokes_level_row {
    int n, own_column[STOKES_LEVEL_ROW];
    float own_weight[STOKES_LEVEL_ROW];
    const int *column;
    const float *weight;
};
static inline void stokes_level_row_of(const struct stokes_level *l, int i, struct stokes_level_row *row) {
    if (!l->next) {
        row->n = l->start[i + 1] - l->start[i];
        row->column = l->column + l->start[i];
        row->weight = l->weight + l->start[i];
        return;
    }
    row->n = 0;
    for (int q = 0; q < STOKES_LEVEL_ROW; q++) {
        const int to = l->next[i][q];
        const float w = stokes_level_phi(l->phi[q % 2 ? i : to][q / 2]) * l->scale[q / 2];
        if (!(w > 0) || to == i) continue;
        row->own_column[row->n] = to;
        row->own_weight[row->n++] = w;
    }
    row->column = row->own_column;
    row->weight = row->own_weight;
}

/* Entries of a vector: own rows, ghosts, and one 0. */
static inline size_t stokes_level_size(const struct stokes_level *l) { return (size_t)l->n + (size_t)l->ghosts + 1; }
void stokes_level_fill(const struct stokes_level *l, float *x); /* the ghosts. Collective. */

/* The arrays alone; x [size] reads ghosts. Not collective. */
/* One Gauss-Seidel sweep over the own rows, upwards or downwards. */
void stokes_level_sweep(const struct stokes_level *l, int up, const float *b, float *x);
/* y = M x, 0 where there is no unknown; by differences of x, which is nearly constant where M is nearly singular. */
void stokes_level_product(const struct stokes_level *l, const float *x, float *y);
/* The sums x.M x and y.M x over the own rows. */
void stokes_level_energies(const struct stokes_level *l, const float *x, const float *y, double sum[2]);
/* The sums of b - M x over the rows of each aggregate.  to [aggregates] */
void stokes_level_restrict(const struct stokes_level *l, const float *b, const float *x, int aggregates, float *to);
