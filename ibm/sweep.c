/* Interpolates velocity at the inner markers and spreads their force increments.  (001: eqs 3.79-3.82)
 *
 * As many markers at once as a vec has lanes: lane i of a vec belongs to the i-th of them. Their weights are computed
 * for all alignments before their blocks are touched. Then each block's nine rows of a component are summed, or added
 * to, one marker after the other, with four values of a row at once. Weights along x belong to the lanes; weights along
 * y and z to the rows, for which they lie in memory.
 *
 * The four values begin at an even index, so that fewer of them cross a boundary of 32 bytes:
 *
 *        block at an even index    |x x x .|        at an odd index    |. x x x| */
#include "base/vec_shuffle.h"
#include "ibm/state.h"

#include <math.h>

enum { GROUP = VEC_LANES };
enum { AHEAD = 4 }; /* row that is prefetched, counted from a block's first: markers are sorted along y */
static const int of_stencil[8] = {0, 1, 2, 3, 4, 5, 6, 7};

/* Weights of the markers, by alignment. A component lies at faces along its own direction. */
struct group {
    vec x[2][3]; /* [alignment][weight] */
    double y[2][3][GROUP], z[2][3][GROUP];
    vec_mask odd[2];      /* [alignment along x] blocks that begin at an odd index */
    int64_t at[3][GROUP]; /* even index at or before the first of the 3 x 3 x 3 values of each component */
};

/* As ibm_kernel_weights. */
static inline void weigh(vec t, vec w[3]) {
    const vec middle = (1 + vec_sqrt(1 - 3 * t * t)) * (1.0 / 3), rest = 0.5 - 0.5 * middle, lean = 0.5 * t;
    w[0] = rest - lean;
    w[1] = middle;
    w[2] = rest + lean;
}

/* Of the markers s, s + 1, ... s + n - 1; lanes beyond repeat the last one. */
static inline void group_set(const struct ibm_stencil *s, int n, const ptrdiff_t stride[3], struct group *g) {
    int which[GROUP];
    vec place[4];
    for (int i = 0; i < GROUP; i++) which[i] = i < n ? i : n - 1;
    vec_shuffle_gather4(s->t, sizeof *s / sizeof(double), which, place);
    const vec_mask at = (vec_mask)place[3];
    for (int d = 0; d < 3; d++) {
        const vec t = place[d];
        const vec_mask low = t < 0, half = (vec_mask)vec_set(0.5), minus_half = (vec_mask)vec_set(-0.5);
        vec w[2][3];
        weigh(t, w[IBM_CENTRE]);
        weigh(t + (vec)((low & half) | (~low & minus_half)), w[IBM_FACE]); /* as ibm_kernel_face */
        for (int a = 0; a < 2; a++)
            for (int i = 0; i < 3; i++) {
                if (d == 0) g->x[a][i] = w[a][i];
                if (d == 1) vec_store(g->y[a][i], w[a][i]);
                if (d == 2) vec_store(g->z[a][i], w[a][i]);
            }
        const vec_mask first = at - (low & stride[d]), even = first & ~(int64_t)1;
        memcpy(g->at[d], &even, sizeof even);
        if (d < 2) g->odd[d == 0 ? IBM_FACE : IBM_CENTRE] = -(first & 1); /* strides of y and z are even */
    }
}

/* velocity[c] <- U of the markers. */
static inline void group_read(const struct group *g, int n, double *const u[3], const ptrdiff_t stride[3],
                              vec velocity[3]) {
    double sum[3][GROUP][4];
    for (int i = 0; i < n; i++)
        for (int c = 0; c < 3; c++) {
            const double(*y)[GROUP] = g->y[c == 1], (*z)[GROUP] = g->z[c == 2];
            const double *at = u[c] + g->at[c][i];
            ibm_row row = ibm_row_set(0);
            for (int k = 0; k < 3; k++, at += stride[2]) {
                __builtin_prefetch(at + AHEAD * stride[1]);
                row += ibm_row_set(z[k][i]) * ibm_kernel_rows(at, stride[1], y[0][i], y[1][i], y[2][i]);
            }
            ibm_row_store(sum[c][i], row);
        }
    for (int c = 0; c < 3; c++) {
        vec column[4];
        vec_shuffle_gather4(sum[c][0], 4, of_stencil, column);
        const vec *x = g->x[c == 0];
        const vec_mask odd = g->odd[c == 0];
        velocity[c] = vec_choose(odd, column[1], column[0]) * x[0] + vec_choose(odd, column[2], column[1]) * x[1] +
                      vec_choose(odd, column[3], column[2]) * x[2];
    }
}

/* u += strength delta, strength [n][3] */
static inline void group_write(const struct group *g, int n, double *const u[3], const ptrdiff_t stride[3],
                               const double (*strength)[3]) {
    double along[2][GROUP][4]; /* [alignment] weights along x of the four values */
    for (int a = 0; a < 2; a++) {
        const vec none = vec_set(0), *x = g->x[a];
        const vec_mask odd = g->odd[a];
        vec_shuffle_store4(along[a][0], (const vec[4]){vec_choose(odd, none, x[0]), vec_choose(odd, x[0], x[1]),
                                                       vec_choose(odd, x[1], x[2]), vec_choose(odd, x[2], none)});
    }
    for (int i = 0; i < n; i++)
        for (int c = 0; c < 3; c++) {
            const double(*y)[GROUP] = g->y[c == 1], (*z)[GROUP] = g->z[c == 2];
            const ibm_row x = ibm_row_load(along[c == 0][i]) * ibm_row_set(strength[i][c]);
            double *at = u[c] + g->at[c][i];
            for (int k = 0; k < 3; k++, at += stride[2]) {
                const ibm_row slice = x * ibm_row_set(z[k][i]);
                for (int j = 0; j < 3; j++) {
                    double *row = at + j * stride[1];
                    ibm_row_store(row, ibm_row_load(row) + slice * ibm_row_set(y[j][i]));
                }
            }
        }
}

/* The increments of n markers, and what is kept of them. */
static inline void put(const vec value[3], int n, enum ibm_record record, double (*increment)[3],
                       double (*received)[3]) {
    double all[3 * GROUP];
    vec_shuffle_store3(all, value);
    memcpy(increment, all, (size_t)n * sizeof *increment);
    for (int i = 0; i < n && record != IBM_EVALUATE; i++)
        for (int c = 0; c < 3; c++) received[i][c] = all[3 * i + c] + (record == IBM_OVERWRITE ? 0 : received[i][c]);
}

void ibm_sweep_gather(struct ibm *ibm, double *const u[3], int first, int last, enum ibm_record record,
                      struct ibm_tally *t) {
    const ptrdiff_t stride[3] = {1, ibm->grid->row, ibm->grid->plane};
    double(*const increment)[3] = ibm->increment, (*const received)[3] = ibm->received;
    vec impulse[3] = {vec_set(0), vec_set(0), vec_set(0)}, squares = vec_set(0);
    for (int h = first; h < last; h += GROUP) {
        const struct ibm_stencil *s = &ibm->stencil[h];
        const int n = last - h < GROUP ? last - h : GROUP;
        struct group g;
        vec value[3], v[4];
        group_set(s, n, stride, &g);
        group_read(&g, n, u, stride, value);
        vec_shuffle_gather4(s->v, sizeof *s / sizeof(double), of_stencil, v); /* and the volumes */
        for (int c = 0; c < 3; c++) {
            const vec lack = vec_where((1u << n) - 1, v[c] - value[c]);
            value[c] = lack * v[3];
            impulse[c] += value[c];
            squares += lack * lack;
        }
        put(value, n == GROUP ? GROUP : n, record, increment + h, received + h);
    }
    for (int c = 0; c < 3; c++) t->impulse[c] += vec_sum(impulse[c]);
    t->squares += vec_sum(squares);
}

void ibm_sweep_read(const struct ibm *ibm, double *const u[3], int first, int last, double (*velocity)[3]) {
    const ptrdiff_t stride[3] = {1, ibm->grid->row, ibm->grid->plane};
    for (int h = first; h < last; h += GROUP) {
        const int n = last - h < GROUP ? last - h : GROUP;
        struct group g;
        vec value[3];
        group_set(&ibm->stencil[h], n, stride, &g);
        group_read(&g, n, u, stride, value);
        put(value, n, IBM_EVALUATE, velocity + h, NULL);
    }
}

/* Whether the increments of n markers are all zero, as for inner fluid near a body's surface
 * (coupling/load/inner_fluid.c). */
static inline int is_nothing(const double (*strength)[3], int n) {
    double most = 0;
    for (int i = 0; i < n; i++) most += fabs(strength[i][0]) + fabs(strength[i][1]) + fabs(strength[i][2]);
    return most == 0;
}

void ibm_sweep_scatter(const struct ibm *ibm, double *const u[3], int first, int last) {
    const ptrdiff_t stride[3] = {1, ibm->grid->row, ibm->grid->plane};
    for (int h = first; h < last; h += GROUP) {
        const int n = last - h < GROUP ? last - h : GROUP;
        struct group g;
        if (is_nothing((const double(*)[3])(ibm->increment + h), n)) continue;
        group_set(&ibm->stencil[h], n, stride, &g);
        group_write(&g, n, u, stride, (const double(*)[3])(ibm->increment + h));
    }
}
