/* Interpolates particle values of a plate onto a regular grid. */
#include "postproc/data/grid.h"
#include "base/memory.h"

#include <math.h>
#include <string.h>

enum { LEVELS = 7, MARGIN = 1 };

static size_t at(const struct postproc_grid *g, int i, int j) { return (size_t)j * (size_t)g->n[0] + (size_t)i; }

struct postproc_grid *postproc_grid_empty(int n0, int n1, const double origin[2], double h) {
    struct postproc_grid *g = memory_new(MEMORY_OUTPUT, 1, sizeof *g);
    *g = (struct postproc_grid){.n = {n0, n1}, .origin = {origin[0], origin[1]}, .h = h};
    const size_t nodes = (size_t)n0 * (size_t)n1;
    g->value = memory_new(MEMORY_OUTPUT, nodes + 1, sizeof *g->value);
    for (size_t k = 0; k < nodes; k++) g->value[k] = NAN;
    return g;
}

void postproc_grid_free(struct postproc_grid *g) {
    if (!g) return;
    MEMORY_FREE(g->value, g);
}

double postproc_grid_value(const struct postproc_grid *g, int i, int j) {
    return i < 0 || j < 0 || i >= g->n[0] || j >= g->n[1] ? NAN : g->value[at(g, i, j)];
}

double postproc_grid_at(const struct postproc_grid *g, const double x[2]) {
    double f[2], value = 0;
    int node[2];
    for (int c = 0; c < 2; c++) {
        const double q = (x[c] - g->origin[c]) / g->h;
        if (!(q > -1 && q < g->n[c])) return NAN;
        node[c] = (int)floor(q);
        f[c] = q - node[c];
    }
    for (int b = 0; b < 2; b++)
        for (int a = 0; a < 2; a++) {
            const double weight = (a ? f[0] : 1 - f[0]) * (b ? f[1] : 1 - f[1]);
            if (weight > 1e-12) value += weight * postproc_grid_value(g, node[0] + a, node[1] + b);
        }
    return value;
}

/* How many times the spacing must be halved until all particles lie on nodes; 0 if it never does. */
static int halvings(const struct postproc_grid_input *in) {
    for (int level = 0; level < LEVELS; level++) {
        const double h = in->spacing / (1 << level);
        long i = 0;
        for (int on = 1; on && i < in->n; i += on)
            for (int c = 0; c < 2; c++) {
                const double q = (in->x[i][c] - in->first[c]) / h;
                on &= fabs(q - rint(q)) < 0.02;
            }
        if (i == in->n) return level;
    }
    return 0;
}

/* Sets the nodes that have particles to the mean of the nearest ones. */
static void put_particles(struct postproc_grid *g, const struct postproc_grid_input *in) {
    int *count = memory_new(MEMORY_OUTPUT, (size_t)g->n[0] * (size_t)g->n[1], sizeof *count);
    for (long k = 0; k < in->n; k++) {
        const int i = (int)lround((in->x[k][0] - g->origin[0]) / g->h);
        const int j = (int)lround((in->x[k][1] - g->origin[1]) / g->h);
        const size_t node = at(g, i, j);
        const double value = in->value[(size_t)k * (size_t)in->stride];
        g->value[node] = count[node] ? g->value[node] + (value - g->value[node]) / (count[node] + 1) : value;
        count[node]++;
    }
    memory_free(count);
}

/* Fills the nodes between those of a lattice of spacing 2 s: midpoints of edges and of squares whose corners all have
 * values. */
static void halve(struct postproc_grid *g, int s) {
    static const int corner[3][4][2] = {
        {{-1, 0}, {1, 0}, {-1, 0}, {1, 0}}, {{0, -1}, {0, 1}, {0, -1}, {0, 1}}, {{-1, -1}, {1, -1}, {-1, 1}, {1, 1}}};
    for (int j = MARGIN; j < g->n[1]; j += s)
        for (int i = MARGIN; i < g->n[0]; i += s) {
            const int odd = ((i - MARGIN) / s & 1) + 2 * ((j - MARGIN) / s & 1);
            if (odd == 0 || !isnan(g->value[at(g, i, j)])) continue;
            double sum = 0;
            for (int k = 0; k < 4; k++)
                sum += postproc_grid_value(g, i + s * corner[odd - 1][k][0], j + s * corner[odd - 1][k][1]);
            g->value[at(g, i, j)] = sum / 4;
        }
}

/* The mean of the neighbours along the axes; without values there, of those along the diagonals. */
static double beside(const struct postproc_grid *g, int i, int j) {
    static const int step[8][2] = {{-1, 0}, {1, 0}, {0, -1}, {0, 1}, {-1, -1}, {1, -1}, {-1, 1}, {1, 1}};
    for (int diagonal = 0; diagonal < 2; diagonal++) {
        double sum = 0;
        int n = 0;
        for (int k = 4 * diagonal; k < 4 * diagonal + 4; k++) {
            const double value = postproc_grid_value(g, i + step[k][0], j + step[k][1]);
            if (isnan(value)) continue;
            sum += value;
            n++;
        }
        if (n) return sum / n;
    }
    return NAN;
}

/* Adds one row of nodes on all sides, with the values of adjacent nodes. */
static void put_rim(struct postproc_grid *g) {
    const size_t nodes = (size_t)g->n[0] * (size_t)g->n[1];
    double *wide = memory_new(MEMORY_OUTPUT, nodes, sizeof *wide);
    for (int j = 0; j < g->n[1]; j++)
        for (int i = 0; i < g->n[0]; i++) {
            const double value = g->value[at(g, i, j)];
            wide[at(g, i, j)] = isnan(value) ? beside(g, i, j) : value;
        }
    memcpy(g->value, wide, nodes * sizeof *wide);
    memory_free(wide);
}

struct postproc_grid *postproc_grid_new(const struct postproc_grid_input *in) {
    const int level = halvings(in), stride = 1 << level;
    const double h = in->spacing / stride;
    double origin[2];
    int n[2];
    for (int c = 0; c < 2; c++) { /* from a node of the coarsest lattice on, with the added row */
        double low = INFINITY, high = -INFINITY;
        for (long i = 0; i < in->n; i++) {
            low = fmin(low, in->x[i][c]);
            high = fmax(high, in->x[i][c]);
        }
        const double cells = floor((low - in->first[c]) / in->spacing + 0.02);
        origin[c] = in->first[c] + cells * in->spacing - MARGIN * h;
        n[c] = (int)lround((high - origin[c]) / h) + 1 + MARGIN;
    }
    struct postproc_grid *g = postproc_grid_empty(n[0], n[1], origin, h);
    put_particles(g, in);
    for (int s = stride / 2; s >= 1; s /= 2) halve(g, s);
    put_rim(g);
    return g;
}

struct postproc_grid *postproc_grid_turn(const struct postproc_grid *g, const double d[2]) {
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (int k = 0; k < 4; k++) {
        const double x = g->origin[0] + (k & 1 ? (g->n[0] - 1) * g->h : 0);
        const double y = g->origin[1] + (k & 2 ? (g->n[1] - 1) * g->h : 0);
        const double q[2] = {d[0] * x + d[1] * y, d[0] * y - d[1] * x};
        for (int c = 0; c < 2; c++) {
            low[c] = fmin(low[c], q[c]);
            high[c] = fmax(high[c], q[c]);
        }
    }
    const int n0 = (int)floor((high[0] - low[0]) / g->h + 1e-6) + 1;
    const int n1 = (int)floor((high[1] - low[1]) / g->h + 1e-6) + 1;
    struct postproc_grid *turned = postproc_grid_empty(n0, n1, low, g->h);
    for (int j = 0; j < n1; j++)
        for (int i = 0; i < n0; i++) {
            const double s = low[0] + i * g->h, t = low[1] + j * g->h;
            const double x[2] = {s * d[0] - t * d[1], s * d[1] + t * d[0]};
            turned->value[at(turned, i, j)] = postproc_grid_at(g, x);
        }
    return turned;
}
