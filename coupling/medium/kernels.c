/* Kernels of the medium: deposition of a cube into cells, sums over the box, flood fill of one rank. */
#include "coupling/medium/kernels.h"
#include "ibm/ibm.h"

#include <math.h>

/* Overlap of [low, high] with cell i, in cells. */
static inline double overlap(double low, double high, int i) {
    return (high < i + 1.0 ? high : i + 1.0) - (low > i ? low : i);
}

enum { LINE = 8 }; /* doubles of a cache line */

static inline int larger(int a, int b) { return a > b ? a : b; }
static inline int smaller(int a, int b) { return a < b ? a : b; }

/*      i   i+1
 *    +---+---+
 *    | ##|#  |   ## the cube's share of each
 *    +---+---+     */
void medium_kernels_deposit(const double low[3], const double high[3], const int first[3], const int last[3],
                            ptrdiff_t row, ptrdiff_t plane, double *f) {
    int from[3], to[3], is_pair = 1;
    double part[3][2];
    for (int c = 0; c < 3; c++) { /* most cubes have two cells along each direction, the second one perhaps nothing */
        const double cell = floor(low[c]), middle = cell + 1, beyond = high[c] - middle;
        from[c] = (int)cell;
        is_pair &= (beyond <= 1) & (from[c] >= first[c]) & (from[c] + 2 <= last[c]);
        part[c][0] = (high[c] < middle ? high[c] : middle) - low[c];
        part[c][1] = beyond > 0 ? beyond : 0;
    }
    if (is_pair) {
        double *at = f + from[2] * plane + from[1] * row + from[0];
        for (int k = 0; k < 2; k++)
            for (int j = 0; j < 2; j++) {
                const double zy = part[2][k] * part[1][j];
                at[k * plane + j * row] += zy * part[0][0];
                at[k * plane + j * row + 1] += zy * part[0][1];
            }
        return;
    }
    for (int c = 0; c < 3; c++) {
        from[c] = larger(from[c], first[c]);
        to[c] = smaller((int)ceil(high[c]), last[c]);
    }
    for (int k = from[2]; k < to[2]; k++) {
        const double z = overlap(low[2], high[2], k);
        for (int j = from[1]; j < to[1]; j++) {
            const double zy = z * overlap(low[1], high[1], j);
            double *at = f + k * plane + j * row;
            for (int i = from[0]; i < to[0]; i++) at[i] += zy * overlap(low[0], high[0], i);
        }
    }
}

enum { SPREAD = 2 * MEDIUM_SPREAD_REACH + 1 }; /* cells along a direction */

/* Local indices and weights of the cells about s along direction c: the mean of the kernel over the cube's side, by
 * three points. */
static void spread_line(const struct fluid_grid *g, int c, double s, double side, int at[SPREAD],
                        double weight[SPREAD]) {
    const int cell = (int)floor(s);
    const double offset = fmin(side / 3, 1);
    for (int i = 0; i < SPREAD; i++) {
        int to = cell - MEDIUM_SPREAD_REACH + i;
        weight[i] = 0;
        for (int q = -1; q <= 1; q++) weight[i] += ibm_kernel(s + q * offset - to - 0.5) / 3;
        if (!g->periodic[c] && to < 0) to = -1 - to;
        if (!g->periodic[c] && to >= g->n[c]) to = 2 * g->n[c] - 1 - to;
        at[i] = to - g->lo[c];
    }
}

void medium_kernels_spread(const struct fluid_grid *g, const double s[3], const double side[3], double *f) {
    int at[3][SPREAD];
    double weight[3][SPREAD];
    for (int c = 0; c < 3; c++) spread_line(g, c, s[c], side[c], at[c], weight[c]);
    for (int k = 0; k < SPREAD; k++)
        for (int j = 0; j < SPREAD; j++) {
            const double zy = side[2] * weight[2][k] * side[1] * weight[1][j];
            double *row = f + at[2][k] * g->plane + at[1][j] * g->row;
            for (int i = 0; i < SPREAD && zy > 0; i++) row[at[0][i]] += zy * side[0] * weight[0][i];
        }
}

/* The cells of a row that the box holds, or has a part of. */
static void span_of(const double *weight, int m, int *from, int *to) {
    int low = 0, high = m;
    while (low < high && weight[low] == 0) low++;
    while (high > low && weight[high - 1] == 0) high--;
    *from = low;
    *to = high;
}

double medium_kernels_sum_solid(const int m[3], ptrdiff_t row, ptrdiff_t plane, const double *const weight[3],
                                const double *fraction) {
    int from, to;
    double sum = 0;
    span_of(weight[0], m[0], &from, &to);
    for (int k = 0; k < m[2]; k++)
        for (int j = 0; j < m[1]; j++) {
            const double zy = weight[2][k] * weight[1][j];
            if (zy == 0) continue;
            const double *f = fraction + k * plane + j * row;
            double solid = 0;
#pragma omp simd reduction(+ : solid)
            for (int i = from; i < to; i++) solid += weight[0][i] * f[i];
            sum += zy * solid;
        }
    return sum;
}

struct medium_sums medium_kernels_sum_flow(const int m[3], ptrdiff_t row, ptrdiff_t plane,
                                           const double *const weight[3], const double *fraction, const double *u,
                                           const double *v, const double *w) {
    double us = 0, vs = 0, ws = 0, pore_us = 0, pore_vs = 0, pore_ws = 0, speeds = 0, solid = 0;
    int from, to;
    span_of(weight[0], m[0], &from, &to);
    for (int k = 0; k < m[2]; k++)
        for (int j = 0; j < m[1]; j++) {
            const double zy = weight[2][k] * weight[1][j];
            if (zy == 0) continue;
            const ptrdiff_t at = k * plane + j * row;
            for (ptrdiff_t a = at + row + from; a < at + row + to; a += LINE) { /* a part of a row ends too soon for the
                                                                                 * processor to foresee the next one */
                __builtin_prefetch(u + a);
                __builtin_prefetch(v + a);
                __builtin_prefetch(w + a);
                __builtin_prefetch(fraction + a);
            }
#pragma omp simd reduction(+ : us, vs, ws, pore_us, pore_vs, pore_ws, speeds, solid)
            for (int i = from; i < to; i++) {
                const ptrdiff_t a = at + i;
                const double W = zy * weight[0][i];
                const double uc = 0.5 * (u[a - 1] + u[a]);
                const double vc = 0.5 * (v[a - row] + v[a]);
                const double wc = 0.5 * (w[a - plane] + w[a]);
                const double pore = medium_kernels_is_pore(fraction[a]) ? W : 0;
                solid += W * fraction[a];
                us += W * uc, vs += W * vc, ws += W * wc;
                pore_us += pore * uc, pore_vs += pore * vc, pore_ws += pore * wc;
                speeds += pore * sqrt(uc * uc + vc * vc + wc * wc);
            }
        }
    return (struct medium_sums){
        .solid = solid, .u = {us, vs, ws}, .pore_u = {pore_us, pore_vs, pore_ws}, .pore_speed = speeds};
}

int medium_kernels_compare(int m, double zy, const double *restrict weight, const double *restrict fraction,
                           uint8_t *restrict cell) {
    int differ = 0;
#pragma omp simd reduction(| : differ)
    for (int i = 0; i < m; i++) {
        const int pore = (zy * weight[i] > 0) & medium_kernels_is_pore(fraction[i]), was = cell[i] != MEDIUM_WALL;
        differ |= pore != was;
        cell[i] = pore == was ? cell[i] : pore ? MEDIUM_PORE : MEDIUM_WALL;
    }
    return differ;
}

double medium_kernels_open(int m, const double *weight, const double *fraction, const uint8_t *cell) {
    double open = 0;
#pragma omp simd reduction(+ : open)
    for (int i = 0; i < m; i++) open += cell[i] == MEDIUM_BOTH ? weight[i] * (1 - fraction[i]) : 0;
    return open;
}

long medium_kernels_flood(const int m[3], uint8_t level, int n, int *stack, uint8_t *cell) {
    const int row = m[0] + 2, plane = row * (m[1] + 2);
    const int neighbour[6] = {-1, 1, -row, row, -plane, plane};
    long reached = 0;
    while (n > 0) {
        const int at = stack[--n];
        for (int b = 0; b < 6; b++) {
            const int to = at + neighbour[b];
            if (cell[to] != level - 1) continue;
            cell[to] = level;
            stack[n++] = to;
            reached++;
        }
    }
    return reached;
}
