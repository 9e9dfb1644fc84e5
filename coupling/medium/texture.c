/* Porosity and wetted surface of slices and sub-volumes of the medium's box. */
#include "coupling/medium/texture.h"
#include "base/memory.h"
#include "base/par.h"
#include "coupling/medium/parts.h"

#include <math.h>

int medium_texture_slices(const struct medium *m, int c) { return m->last[c] - m->first[c] + 1; }

void medium_texture_slice(const struct medium *m, int c, double *at, double *porosity) {
    const struct fluid_grid *g = m->g;
    const int n = medium_texture_slices(m, c);
    double *sum = memory_new(MEMORY_COUPLING, 2 * (size_t)n, sizeof *sum); /* volume, then solid, in cells */
    for (int k = 0; k < g->m[2]; k++)
        for (int j = 0; j < g->m[1]; j++) {
            const double zy = m->weight[2][k] * m->weight[1][j], *f = m->fraction + fluid_grid_at(g, 0, j, k);
            if (zy == 0) continue;
            for (int i = 0; i < g->m[0]; i++) {
                const int section = (c == 0 ? i : c == 1 ? j : k) + g->lo[c] - m->first[c];
                const double W = zy * m->weight[0][i];
                if (W == 0) continue;
                sum[section] += W;
                sum[n + section] += W * f[i];
            }
        }
    par_sum_array(sum, 2 * n);
    for (int q = 0; q < n; q++) {
        const double low = fmax(m->low[c], (m->first[c] + q) * g->d[c]),
                     high = fmin(m->high[c], (m->first[c] + q + 1) * g->d[c]);
        at[q] = 0.5 * (low + high);
        porosity[q] = 1 - sum[n + q] / sum[q];
    }
    memory_free(sum);
}

/* The sub-volume of a place, 0 ... parts - 1; a place outside the box is in none: -1. */
static int part_of(const struct medium *m, int c, int parts, double x) {
    const double s = (x - m->low[c]) / (m->high[c] - m->low[c]);
    if (!(s >= 0 && s <= 1)) return -1;
    const int p = (int)(s * parts);
    return p < parts ? p : parts - 1;
}

/* Volume, solid volume (in cells) and wetted surface (m2) of the smallest sub-volumes: sum [3][parts of z][y][x]. A
 * cell is in the sub-volume of its middle. */
static void fill(const struct medium *m, const int parts[3], int n, const double *const x[3], const double *area,
                 double *sum) {
    const struct fluid_grid *g = m->g;
    const int all = parts[0] * parts[1] * parts[2];
    for (int k = 0; k < g->m[2]; k++)
        for (int j = 0; j < g->m[1]; j++) {
            const double zy = m->weight[2][k] * m->weight[1][j], *f = m->fraction + fluid_grid_at(g, 0, j, k);
            for (int i = 0; i < g->m[0] && zy > 0; i++) {
                const int at[3] = {i + g->lo[0], j + g->lo[1], k + g->lo[2]};
                const double W = zy * m->weight[0][i];
                int p[3];
                if (W == 0) continue;
                for (int c = 0; c < 3; c++) {
                    const double low = fmax(m->low[c], at[c] * g->d[c]), high = fmin(m->high[c], (at[c] + 1) * g->d[c]);
                    p[c] = part_of(m, c, parts[c], 0.5 * (low + high));
                }
                const int part = (p[2] * parts[1] + p[1]) * parts[0] + p[0];
                sum[part] += W;
                sum[all + part] += W * f[i];
            }
        }
    for (int h = 0; h < n; h++) {
        int p[3];
        for (int c = 0; c < 3; c++) {
            const double L = g->length[c], wrapped = g->periodic[c] ? x[c][h] - L * floor(x[c][h] / L) : x[c][h];
            p[c] = part_of(m, c, parts[c], wrapped);
        }
        if (p[0] >= 0 && p[1] >= 0 && p[2] >= 0) sum[2 * all + (p[2] * parts[1] + p[1]) * parts[0] + p[0]] += area[h];
    }
    par_sum_array(sum, 3 * all);
}

/* Joins sub-volumes in pairs along each direction that has more parts than wanted. */
static void join(const int from[3], const int to[3], double *sum, double *joined) {
    const int all = from[0] * from[1] * from[2], fewer = to[0] * to[1] * to[2];
    for (int q = 0; q < 3 * fewer; q++) joined[q] = 0;
    for (int k = 0; k < from[2]; k++)
        for (int j = 0; j < from[1]; j++)
            for (int i = 0; i < from[0]; i++) {
                const int at = (k * from[1] + j) * from[0] + i,
                          in = (k * to[2] / from[2] * to[1] + j * to[1] / from[1]) * to[0] + i * to[0] / from[0];
                for (int q = 0; q < 3; q++) joined[q * fewer + in] += sum[q * all + at];
            }
    for (int q = 0; q < 3 * fewer; q++) sum[q] = joined[q];
}

static void spread(int n, const double *value, double out[4]) {
    double mean = 0, square = 0, least = INFINITY, most = -INFINITY;
    for (int q = 0; q < n; q++) {
        mean += value[q] / n;
        least = fmin(least, value[q]);
        most = fmax(most, value[q]);
    }
    for (int q = 0; q < n; q++) square += (value[q] - mean) * (value[q] - mean) / n;
    out[0] = mean, out[1] = sqrt(square), out[2] = least, out[3] = most;
    for (int q = 0; q < n; q++)
        if (isnan(value[q])) out[0] = out[1] = out[2] = out[3] = NAN;
}

static struct medium_texture_size size_of(const struct medium *m, const int parts[3], const double *sum, double *work) {
    struct medium_texture_size s = {.parts = {parts[0], parts[1], parts[2]}};
    const int n = parts[0] * parts[1] * parts[2];
    const double *d = m->g->d, box = (m->high[0] - m->low[0]) * (m->high[1] - m->low[1]) * (m->high[2] - m->low[2]);
    s.edge = cbrt(box / n);
    for (int q = 0; q < n; q++) work[q] = 1 - sum[n + q] / sum[q];
    spread(n, work, s.porosity);
    for (int q = 0; q < n; q++) work[q] = sum[2 * n + q] / (sum[q] * d[0] * d[1] * d[2]);
    spread(n, work, s.specific_surface);
    for (int q = 0; q < n; q++) {
        const double phi = 1 - sum[n + q] / sum[q], S = work[q];
        work[q] = phi > 0 && S > 0 ? phi * phi * phi / (5 * S * S) : NAN;
    }
    spread(n, work, s.carman);
    return s;
}

int medium_texture_sizes(const struct medium *m, int n, const double *const x[3], const double *area,
                         struct medium_texture_size size[MEDIUM_TEXTURE_SIZES]) {
    int parts[3] = {1, 1, 1}, sizes = 1;
    for (int finer = 1; finer && sizes < MEDIUM_TEXTURE_SIZES; sizes += finer) {
        finer = 0;
        for (int c = 0; c < 3; c++)
            if ((m->high[c] - m->low[c]) / m->g->d[c] >= 2 * parts[c] * MEDIUM_TEXTURE_CELLS - MEDIUM_SNAP)
                parts[c] *= 2, finer = 1;
    }
    const size_t all = (size_t)parts[0] * (size_t)parts[1] * (size_t)parts[2];
    double *sum = memory_new(MEMORY_COUPLING, 3 * all, sizeof *sum),
           *work = memory_new(MEMORY_COUPLING, 3 * all, sizeof *work);
    fill(m, parts, n, x, area, sum);
    for (int q = 0; q < sizes; q++) {
        int next[3], most = 0;
        size[q] = size_of(m, parts, sum, work);
        for (int c = 0; c < 3; c++) most = parts[c] > most ? parts[c] : most;
        for (int c = 0; c < 3; c++) next[c] = parts[c] == most && most > 1 ? parts[c] / 2 : parts[c];
        join(parts, next, sum, work);
        for (int c = 0; c < 3; c++) parts[c] = next[c];
    }
    MEMORY_FREE(work, sum);
    return sizes;
}
