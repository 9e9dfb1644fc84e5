/* Orders the nodes, and assembles stiffness and load piece by piece. */
#include "meshless/galerkin/assemble.h"
#include "base/die.h"
#include "base/ensure.h"
#include "base/memory.h"
#include "meshless/galerkin/cells.h"
#include "meshless/galerkin/field.h"
#include "meshless/galerkin/mls.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { UNION = 2 * GALERKIN_NEAR, INSIDE = MESHLESS_CELLS_CORNERS * MESHLESS_CELLS_GAUSS * MESHLESS_CELLS_GAUSS };

struct placed {
    double key[2];
    int node;
};

static int by_place(const void *a, const void *b) {
    const struct placed *p = a, *q = b;
    for (int c = 0; c < 2; c++)
        if (p->key[c] != q->key[c]) return p->key[c] < q->key[c] ? -1 : 1;
    return p->node - q->node;
}

/* The nodes that a piece's points see, with their mean gradients. */
struct gathered {
    int n, *slot; /* slot [nodes]: place in node, or -1 */
    int node[UNION];
    double load[UNION];        /* integral of phi */
    double mean[UNION][2];     /* by quadrature inside */
    double target[UNION][2];   /* by the edges */
    double phi_pull[UNION][2]; /* load of given tractions */
};

static int slot_of(struct gathered *t, int node) {
    if (t->slot[node] < 0) {
        ENSURE(t->n < UNION, "a cell sees more than %d nodes", UNION);
        const int k = t->n++;
        t->slot[node] = k;
        t->node[k] = node;
        t->load[k] = t->mean[k][0] = t->mean[k][1] = t->target[k][0] = t->target[k][1] = 0;
        t->phi_pull[k][0] = t->phi_pull[k][1] = 0;
    }
    return t->slot[node];
}

static void gathered_clear(struct gathered *t) {
    for (int k = 0; k < t->n; k++) t->slot[t->node[k]] = -1;
    t->n = 0;
}

static void gather_edges(const struct galerkin *g, int piece, struct gathered *t) {
    struct galerkin_place at[MESHLESS_CELLS_GAUSS];
    struct galerkin_shape shape;
    double weight[MESHLESS_CELLS_GAUSS], normal[2];
    const double area = meshless_cells_area(g, piece);
    for (int k = 0; k < g->cells.piece[piece].corners; k++) {
        const int n = meshless_cells_edge(g, piece, k, at, weight, normal);
        for (int q = 0; q < n; q++) {
            double pull[2] = {0, 0};
            for (int p = 0; p < g->in.pulls; p++) {
                const struct galerkin_pull *its = &g->in.pull[p];
                if (!meshless_cells_is_on(g, piece, k, its->from, its->to)) continue;
                double traction[2] = {its->traction[0], its->traction[1]};
                if (its->value) its->value(at[q].x, traction);
                for (int c = 0; c < 2; c++) pull[c] += traction[c];
            }
            meshless_mls_need(g, &at[q], &shape);
            for (int i = 0; i < shape.n; i++) {
                const int s = slot_of(t, shape.node[i]);
                for (int c = 0; c < 2; c++) {
                    t->target[s][c] += weight[q] * normal[c] * shape.phi[i] / area;
                    t->phi_pull[s][c] += weight[q] * pull[c] * shape.phi[i];
                }
            }
        }
    }
}

/* Receives weight times B^T D B of n nodes with gradients d. */
typedef void add_products(void *to, const struct galerkin *g, int n, const int *node, double (*d)[2], double weight);

/* Whether a piece is so thin that the quadrature along its edges, over its area, is not a gradient. Its own area is
 * next to nothing, so that it needs no correction. */
static int is_sliver(const struct galerkin *g, int piece, double area) {
    const struct galerkin_piece *p = &g->cells.piece[piece];
    const double(*x)[2] = (const double(*)[2])(g->cells.corner + p->first);
    double longest = 0;
    for (int k = 0; k < p->corners; k++)
        for (int l = 0; l < k; l++) longest = fmax(longest, hypot(x[k][0] - x[l][0], x[k][1] - x[l][1]));
    return area < 1e-3 * longest * longest;
}

static void sweep_piece(const struct galerkin *g, int piece, struct gathered *t, add_products *add, void *to) {
    static struct galerkin_place at[INSIDE];
    static double weight[INSIDE];
    struct galerkin_shape shape;
    const double area = meshless_cells_area(g, piece);
    const int n = meshless_cells_inside(g, piece, at, weight);
    gathered_clear(t);
    gather_edges(g, piece, t);
    for (int q = 0; q < n; q++) {
        meshless_mls_need(g, &at[q], &shape);
        for (int i = 0; i < shape.n; i++) {
            const int s = slot_of(t, shape.node[i]);
            t->load[s] += weight[q] * shape.phi[i];
            for (int c = 0; c < 2; c++) t->mean[s][c] += weight[q] * shape.d[i][c] / area;
        }
        add(to, g, shape.n, shape.node, shape.d, weight[q]);
    }
    if (is_sliver(g, piece, area)) return;
    /* sum of w (B + T - M)^T D (B + T - M), where M is the mean of B and T is that of the edges */
    add(to, g, t->n, t->node, t->mean, -area);
    add(to, g, t->n, t->node, t->target, area);
}

static void products(const struct galerkin *g, const double a[2], const double b[2], double weight, double k[2][2]) {
    const double(*e)[3] = g->elastic;
    const double w = weight * g->in.thickness;
    k[0][0] = w * (e[0][0] * a[0] * b[0] + e[2][2] * a[1] * b[1]);
    k[0][1] = w * (e[0][1] * a[0] * b[1] + e[2][2] * a[1] * b[0]);
    k[1][0] = w * (e[0][1] * a[1] * b[0] + e[2][2] * a[0] * b[1]);
    k[1][1] = w * (e[1][1] * a[1] * b[1] + e[2][2] * a[0] * b[0]);
}

static void into_band(void *to, const struct galerkin *g, int n, const int *node, double (*d)[2], double weight) {
    double *band = to;
    const size_t high = (size_t)g->half_band + 1;
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            const int row = 2 * g->rank[node[i]], column = 2 * g->rank[node[j]];
            if (row < column) continue;
            double k[2][2];
            products(g, d[i], d[j], weight, k);
            for (int c = 0; c < 2; c++)
                for (int r = 0; r < 2; r++)
                    if (row + r >= column + c)
                        band[(size_t)(column + c) * high + (size_t)(row + r - column - c)] += k[r][c];
        }
}

struct product {
    const double *u;
    double *y;
};
static void into_product(void *to, const struct galerkin *g, int n, const int *node, double (*d)[2], double weight) {
    const struct product *p = to;
    double grad[2][2] = {{0}}, stress[3];
    for (int i = 0; i < n; i++)
        for (int c = 0; c < 2; c++)
            for (int k = 0; k < 2; k++) grad[c][k] += p->u[2 * node[i] + c] * d[i][k];
    meshless_field_stress(g, grad, stress);
    const double w = weight * g->in.thickness;
    for (int i = 0; i < n; i++) {
        p->y[2 * node[i]] += w * (stress[0] * d[i][0] + stress[2] * d[i][1]);
        p->y[2 * node[i] + 1] += w * (stress[2] * d[i][0] + stress[1] * d[i][1]);
    }
}

/* Widens the band to the couplings of a piece. */
static void into_width(void *to, const struct galerkin *g, int n, const int *node, double (*d)[2], double weight) {
    int *width = to, low = g->in.nodes, high = 0;
    (void)d, (void)weight;
    for (int i = 0; i < n; i++) {
        if (g->rank[node[i]] < low) low = g->rank[node[i]];
        if (g->rank[node[i]] > high) high = g->rank[node[i]];
    }
    if (n > 0 && 2 * (high - low) + 1 > *width) *width = 2 * (high - low) + 1;
}

static struct gathered *gathered_new(const struct galerkin *g) {
    struct gathered *t = memory_new(MEMORY_SOLID, 1, sizeof *t);
    t->slot = memory_new(MEMORY_SOLID, (size_t)g->in.nodes, sizeof *t->slot);
    for (int i = 0; i < g->in.nodes; i++) t->slot[i] = -1;
    return t;
}

static void gathered_free(struct gathered *t) { MEMORY_FREE(t->slot, t); }

void meshless_assemble_order(struct galerkin *g) {
    const int nodes = g->in.nodes;
    struct placed *list = memory_new(MEMORY_SOLID, (size_t)nodes, sizeof *list);
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (int i = 0; i < nodes; i++)
        for (int c = 0; c < 2; c++) {
            low[c] = fmin(low[c], g->in.node[i][c]);
            high[c] = fmax(high[c], g->in.node[i][c]);
        }
    const int longer = high[1] - low[1] > high[0] - low[0];
    for (int i = 0; i < nodes; i++) list[i] = (struct placed){{g->in.node[i][longer], g->in.node[i][!longer]}, i};
    qsort(list, (size_t)nodes, sizeof *list, by_place);
    g->rank = memory_new(MEMORY_SOLID, (size_t)nodes, sizeof *g->rank);
    g->node_of = memory_new(MEMORY_SOLID, (size_t)nodes, sizeof *g->node_of);
    for (int k = 0; k < nodes; k++) {
        g->rank[list[k].node] = k;
        g->node_of[k] = list[k].node;
    }
    for (int k = 0; k + 1 < nodes; k++) /* neighbours in the order are enough only for equal places */
        if (list[k].key[0] == list[k + 1].key[0] && list[k].key[1] == list[k + 1].key[1])
            die_all(EXIT_CODE_SCENE, "nodes %d and %d are both at (%.9g, %.9g): leave one of them out", list[k].node,
                    list[k + 1].node, g->in.node[list[k].node][0], g->in.node[list[k].node][1]);
    memory_free(list);
    struct gathered *t = gathered_new(g);
    g->half_band = 1;
    unsigned char *seen = memory_new(MEMORY_SOLID, (size_t)nodes, 1);
    for (int p = 0; p < g->cells.pieces; p++) {
        sweep_piece(g, p, t, into_width, &g->half_band);
        for (int k = 0; k < t->n; k++) seen[t->node[k]] |= t->load[k] != 0;
    }
    for (int i = 0; i < nodes; i++)
        if (!seen[i])
            die_all(EXIT_CODE_SCENE,
                    "node %d at (%.6g, %.6g) is in no quadrature point's support: take more cells (solid.element_free."
                    "cells), a larger support, or leave the node out",
                    i, g->in.node[i][0], g->in.node[i][1]);
    memory_free(seen);
    gathered_free(t);
    for (int r = 0; r < g->rows.rows; r++) {
        int least = 2 * nodes, most = 0;
        for (int k = g->rows.first[r]; k < g->rows.first[r + 1]; k++) {
            const int place = meshless_assemble_place(g, g->rows.unknown[k]);
            if (place < least) least = place;
            if (place > most) most = place;
        }
        if (most - least > g->half_band) g->half_band = most - least;
    }
}

void meshless_assemble(const struct galerkin *g, double penalty, double *band, double *load) {
    const size_t high = (size_t)g->half_band + 1;
    struct gathered *t = gathered_new(g);
    memset(band, 0, (size_t)(2 * g->in.nodes) * high * sizeof *band);
    memset(load, 0, (size_t)(2 * g->in.nodes) * sizeof *load);
    for (int p = 0; p < g->cells.pieces; p++) {
        sweep_piece(g, p, t, into_band, band);
        for (int k = 0; k < t->n; k++)
            for (int c = 0; c < 2; c++)
                load[2 * g->rank[t->node[k]] + c] +=
                    g->in.thickness * (t->phi_pull[k][c] + g->in.body_force[c] * t->load[k]);
    }
    gathered_free(t);
    for (int r = 0; r < g->rows.rows; r++)
        for (int k = g->rows.first[r]; k < g->rows.first[r + 1]; k++)
            for (int l = g->rows.first[r]; l < g->rows.first[r + 1]; l++) {
                const int i = meshless_assemble_place(g, g->rows.unknown[k]);
                const int j = meshless_assemble_place(g, g->rows.unknown[l]);
                if (i >= j) band[(size_t)j * high + (size_t)(i - j)] += penalty * g->rows.value[k] * g->rows.value[l];
            }
}

void meshless_assemble_apply(const struct galerkin *g, const double *u, double *y) {
    struct gathered *t = gathered_new(g);
    struct product product = {u, y};
    memset(y, 0, (size_t)(2 * g->in.nodes) * sizeof *y);
    for (int p = 0; p < g->cells.pieces; p++) sweep_piece(g, p, t, into_product, &product);
    gathered_free(t);
}
