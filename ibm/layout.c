/* Sorts the markers that arrived at a rank by slab and row, so that a slab's sweep stays in the cache. */
/* Order of the markers that have arrived: first inner markers by slab, row and place in the row, so that the planes of
 * a slab stay in a core's own cache; then near edges, whose pieces all lie in one slab; then far edges, whose sums need
 * another slab's or another rank's values. */
#include "base/memory.h"
#include "base/par.h"
#include "ibm/state.h"

#include <string.h>

int ibm_layout_is_inner(const struct ibm *b, const int cell[3]) {
    for (int d = 0; d < 3; d++)
        if (cell[d] < b->inner_low[d] || cell[d] >= b->inner_high[d]) return 0;
    return 1;
}

int ibm_layout_slab_of(const struct ibm *b, int plane) {
    const int slab = plane / IBM_SLAB;
    return plane < 0 ? 0 : slab < b->slabs ? slab : b->slabs - 1;
}

enum { THICK = 2 * IBM_SLAB }; /* more than the planes of the last slab */

/* Number of the row of a cell. Rows are numbered along y first, with all planes of the slab at each y: the inner loops
 * then use a few rows of each plane only. */
static int row_of(const struct ibm *b, const int cell[3]) {
    const int k = cell[2] - b->grid->lo[2], slab = ibm_layout_slab_of(b, k);
    return (slab * b->grid->m[1] + cell[1] - b->grid->lo[1]) * THICK + k - slab * IBM_SLAB;
}

int ibm_layout_bins(const struct ibm *b) { return b->slabs * b->grid->m[1] * THICK; }

/* The sort key of a marker. The bins are: rows of inner markers, slabs of near edges, all far edges. Far edges keep
 * their order of arrival, which is the same on all ranks that share them. */
static void place_of(const struct ibm *b, const double *item, struct ibm_place *p) {
    const struct fluid_grid *g = b->grid;
    int plane[IBM_PIECES], rank[IBM_SHARERS];
    for (int d = 0; d < 3; d++) p->cell[d] = ibm_cell(g, d, item[d]);
    p->x = p->cell[0];
    if (ibm_layout_is_inner(b, p->cell)) {
        p->bin = row_of(b, p->cell);
        return;
    }
    const int pieces = ibm_edge_planes(b, p->cell, plane);
    int far = ibm_share_ranks(b, p->cell, rank) > 1;
    for (int i = 1; i < pieces; i++) far |= plane[i] != plane[0];
    p->bin = ibm_layout_bins(b) + (far ? b->slabs : ibm_layout_slab_of(b, plane[0]));
    if (far) p->x = 0;
}

static void reserve_markers(struct ibm *b) {
    if (b->served <= b->capacity) return;
    b->capacity = b->served + b->served / 4 + 64;
    b->arrival = memory_renew(MEMORY_IBM, b->arrival, (size_t)b->capacity, sizeof *b->arrival);
    b->by_x = memory_renew(MEMORY_IBM, b->by_x, (size_t)b->capacity, sizeof *b->by_x);
    b->place = memory_renew(MEMORY_IBM, b->place, (size_t)b->capacity, sizeof *b->place);
    b->stencil = memory_renew(MEMORY_IBM, b->stencil, (size_t)b->capacity, sizeof *b->stencil);
    b->increment = memory_renew(MEMORY_IBM, b->increment, (size_t)b->capacity, sizeof *b->increment);
    b->received = memory_renew(MEMORY_IBM, b->received, (size_t)b->capacity, sizeof *b->received);
    for (int k = 0; b->implicit && k < IBM_VECTORS; k++)
        b->vector[k] = memory_renew(MEMORY_IBM, b->vector[k], (size_t)b->capacity, sizeof *b->vector[k]);
}

static void reserve_edges(struct ibm *b) {
    if (b->edges > b->edge_capacity) {
        b->edge_capacity = b->edges + b->edges / 4 + 64;
        b->edge = memory_renew(MEMORY_IBM, b->edge, (size_t)b->edge_capacity, sizeof *b->edge);
        b->swap_edge = memory_renew(MEMORY_IBM, b->swap_edge, (size_t)((IBM_SHARERS - 1) * b->edge_capacity),
                                    sizeof *b->swap_edge);
        b->sent = memory_renew(MEMORY_IBM, b->sent, (size_t)((IBM_SHARERS - 1) * b->edge_capacity), sizeof *b->sent);
        b->sum = memory_renew(MEMORY_IBM, b->sum, (size_t)(IBM_SHARERS * b->edge_capacity), sizeof *b->sum);
    }
    if (b->pieces > b->piece_capacity) {
        b->piece_capacity = b->pieces + b->pieces / 4 + 64;
        b->piece = memory_renew(MEMORY_IBM, b->piece, (size_t)b->piece_capacity, sizeof *b->piece);
    }
}

/* order [n] <- from [n] (NULL: 0, 1, ..) sorted by rising key; equal keys keep their order. start [keys + 1] <- first
 * index of each key. */
static void sort(int n, const int *from, const struct ibm_place *place, int by_x, int keys, int *start, int *order) {
    for (int k = 0; k <= keys; k++) start[k] = 0;
    for (int i = 0; i < n; i++) start[(by_x ? place[i].x : place[i].bin) + 1]++;
    for (int k = 0; k < keys; k++) start[k + 1] += start[k];
    for (int i = 0; i < n; i++) {
        const int item = from ? from[i] : i;
        order[start[by_x ? place[item].x : place[item].bin]++] = item;
    }
    for (int k = keys; k > 0; k--) start[k] = start[k - 1];
    start[0] = 0;
}

static int *slab_list(struct ibm *b, enum ibm_list list) { return b->slab_at + (int)list * (b->slabs + 1); }

static void order_markers(struct ibm *b) {
    const int rows = ibm_layout_bins(b);
    for (int a = 0; a < b->served; a++) place_of(b, b->route.served + (size_t)a * IBM_ITEM, &b->place[a]);
    sort(b->served, NULL, b->place, 1, b->grid->n[0], b->bin, b->by_x);
    sort(b->served, b->by_x, b->place, 0, rows + b->slabs + 1, b->bin, b->arrival);
    b->inner = b->bin[rows];
    b->near_edges = b->bin[rows + b->slabs] - b->inner;
    b->edges = b->served - b->inner;
    for (int s = 0; s <= b->slabs; s++) {
        slab_list(b, IBM_INNER)[s] = b->bin[s * (rows / b->slabs)];
        slab_list(b, IBM_NEAR)[s] = b->bin[rows + s] - b->inner;
    }
}

/* Numbers the pieces: those of near edges one after another, those of far edges by slab. */
static void number_pieces(struct ibm *b) {
    const struct fluid_grid *g = b->grid;
    int *near = slab_list(b, IBM_NEAR_PIECES), *far = slab_list(b, IBM_FAR_PIECES), plane[IBM_PIECES];
    for (int s = 0; s <= b->slabs; s++) near[s] = far[s] = 0;
    for (int e = 0; e < b->edges; e++) {
        struct ibm_edge *edge = &b->edge[e];
        const int a = b->arrival[b->inner + e];
        memcpy(edge->cell, b->place[a].cell, sizeof edge->cell);
        edge->mine = 1;
        for (int d = 0; d < 3; d++) edge->mine &= edge->cell[d] >= g->lo[d] && edge->cell[d] < g->lo[d] + g->m[d];
        edge->pieces = ibm_edge_planes(b, edge->cell, plane);
        for (int p = 0; p < edge->pieces; p++) {
            edge->piece[p] = ibm_layout_slab_of(b, plane[p]);
            (e < b->near_edges ? near : far)[edge->piece[p] + 1]++;
        }
    }
    for (int s = 0; s < b->slabs; s++) near[s + 1] += near[s];
    far[0] = near[b->slabs];
    for (int s = 0; s < b->slabs; s++) far[s + 1] += far[s];
    b->pieces = far[b->slabs];
    int *next = b->bin; /* next number for near pieces, then for far ones */
    memcpy(next, near, (size_t)b->slabs * sizeof *next);
    memcpy(next + b->slabs, far, (size_t)b->slabs * sizeof *next);
    for (int e = 0; e < b->edges; e++)
        for (int p = 0; p < b->edge[e].pieces; p++)
            b->edge[e].piece[p] = next[b->edge[e].piece[p] + (e < b->near_edges ? 0 : b->slabs)]++;
}

/* Sets which sums go to which ranks, in an order that both ranks know, and which sums make up the velocity of each far
 * edge. */
static void plan_swaps(struct ibm *b) {
    const int size = par_size(), me = par_rank();
    int *count = b->peer, *at = b->peer + size, *peer = b->peer + 2 * size, rank[IBM_SHARERS], peers = 0;
    for (int r = 0; r < size; r++) count[r] = 0;
    for (int pass = 0; pass < 2; pass++) {
        for (int e = b->near_edges; e < b->edges; e++) {
            struct ibm_edge *edge = &b->edge[e];
            edge->summands = ibm_share_ranks(b, edge->cell, rank);
            for (int k = 0; k < edge->summands; k++) {
                if (rank[k] == me)
                    edge->summand[k] = e;
                else if (pass == 0)
                    count[rank[k]]++;
                else {
                    b->swap_edge[at[rank[k]]] = e;
                    edge->summand[k] = b->edges + at[rank[k]]++;
                }
            }
        }
        if (pass == 1) break;
        b->swapped = 0;
        for (int r = 0; r < size; r++) {
            at[r] = b->swapped;
            b->swapped += count[r];
            if (count[r] == 0) continue;
            peer[peers] = r;
            count[peers++] = count[r]; /* peers <= r: count[r] is read before it is overwritten */
        }
    }
    par_swap_set(b->swap, peers, peer, count);
}

void ibm_layout(struct ibm *b) {
    reserve_markers(b);
    order_markers(b);
    reserve_edges(b);
    number_pieces(b);
    reserve_edges(b); /* the number of pieces is known now */
    for (int e = 0; e < b->edges; e++) {
        struct ibm_edge *edge = &b->edge[e];
        for (int p = 0; p < edge->pieces; p++) b->piece[edge->piece[p]].edge = e;
        edge->summands = 1;
        edge->summand[0] = e;
        for (int c = 0; c < 3; c++) b->sum[e][c] = 0;
    }
    plan_swaps(b);
    b->moved = 0;
}
