/* Sorts the markers that arrived at a rank by slab and row, so that a slab's sweep stays in the cache. */
/* Order of the markers that have arrived: first inner markers by slab, row and place in the row, so that the planes of
 * a slab stay in a core's own cache; then near edges, whose pieces all lie in one slab; then far edges, whose sums need
 * another slab's or another rank's values. */
#include "base/memory.h"
#include "base/par.h"
#include "base/vec_type.h"
#include "ibm/state.h"

#include <string.h>

int ibm_layout_is_inner(const struct ibm *ibm, const int cell[3]) {
    for (int d = 0; d < 3; d++)
        if (cell[d] < ibm->inner_low[d] || cell[d] >= ibm->inner_high[d]) return 0;
    return 1;
}

int ibm_layout_slab_of(const struct ibm *ibm, int plane) {
    const int slab = plane / IBM_SLAB;
    return plane < 0 ? 0 : slab < ibm->slabs ? slab : ibm->slabs - 1;
}

enum { THICK = 2 * IBM_SLAB }; /* more than the planes of the last slab */

/* Number of the row of a cell. Rows are numbered along y first, with all planes of the slab at each y: the inner loops
 * then use a few rows of each plane only. */
static int row_of(const struct ibm *ibm, const int cell[3]) {
    const int k = cell[2] - ibm->grid->lo[2], slab = ibm_layout_slab_of(ibm, k);
    return (slab * ibm->grid->m[1] + cell[1] - ibm->grid->lo[1]) * THICK + k - slab * IBM_SLAB;
}

int ibm_layout_bins(const struct ibm *b) { return b->slabs * b->grid->m[1] * THICK; }

/* The sort key of a marker. The bins are: rows of inner markers, slabs of near edges, all far edges. Far edges keep
 * their order of arrival, which is the same on all ranks that share them. */
static void place_of(const struct ibm *ibm, const double *item, struct ibm_place *p) {
    const struct fluid_grid *g = ibm->grid;
    int plane[IBM_PIECES], rank[IBM_SHARERS];
    for (int d = 0; d < 3; d++) p->cell[d] = ibm_cell(g, d, item[d]);
    p->x = p->cell[0];
    if (ibm_layout_is_inner(ibm, p->cell)) {
        p->bin = row_of(ibm, p->cell);
        return;
    }
    const int pieces = ibm_edge_planes(ibm, p->cell, plane);
    int far = ibm_share_ranks(ibm, p->cell, rank) > 1;
    for (int i = 1; i < pieces; i++) far |= plane[i] != plane[0];
    p->bin = ibm_layout_bins(ibm) + (far ? ibm->slabs : ibm_layout_slab_of(ibm, plane[0]));
    if (far) p->x = 0;
}

static void reserve_markers(struct ibm *ibm) {
    if (ibm->served <= ibm->capacity) return;
    ibm->capacity = ibm->served + ibm->served / 4 + 64;
    ibm->arrival = memory_renew(MEMORY_IBM, ibm->arrival, (size_t)ibm->capacity, sizeof *ibm->arrival);
    ibm->by_x = memory_renew(MEMORY_IBM, ibm->by_x, (size_t)ibm->capacity, sizeof *ibm->by_x);
    ibm->place = memory_renew(MEMORY_IBM, ibm->place, (size_t)ibm->capacity, sizeof *ibm->place);
    ibm->stencil = memory_renew(MEMORY_IBM, ibm->stencil, (size_t)ibm->capacity + VEC_LANES, sizeof *ibm->stencil);
    ibm->increment =
        memory_renew(MEMORY_IBM, ibm->increment, (size_t)ibm->capacity + VEC_LANES, sizeof *ibm->increment);
    ibm->received = memory_renew(MEMORY_IBM, ibm->received, (size_t)ibm->capacity, sizeof *ibm->received);
    if (ibm->slip_time > 0) {
        ibm->velocity = memory_renew(MEMORY_IBM, ibm->velocity, (size_t)ibm->capacity, sizeof *ibm->velocity);
        ibm->change = memory_renew(MEMORY_IBM, ibm->change, (size_t)ibm->capacity, sizeof *ibm->change);
    }
    for (int k = 0; k < (ibm->implicit ? IBM_VECTORS : ibm_marker_force_is_kept(ibm)); k++)
        ibm->vector[k] = memory_renew(MEMORY_IBM, ibm->vector[k], (size_t)ibm->capacity, sizeof *ibm->vector[k]);
}

static void reserve_edges(struct ibm *ibm) {
    if (ibm->edges > ibm->edge_capacity) {
        ibm->edge_capacity = ibm->edges + ibm->edges / 4 + 64;
        ibm->edge = memory_renew(MEMORY_IBM, ibm->edge, (size_t)ibm->edge_capacity, sizeof *ibm->edge);
        ibm->swap_edge = memory_renew(MEMORY_IBM, ibm->swap_edge, (size_t)((IBM_SHARERS - 1) * ibm->edge_capacity),
                                      sizeof *ibm->swap_edge);
        ibm->sent =
            memory_renew(MEMORY_IBM, ibm->sent, (size_t)((IBM_SHARERS - 1) * ibm->edge_capacity), sizeof *ibm->sent);
        ibm->sum = memory_renew(MEMORY_IBM, ibm->sum, (size_t)(IBM_SHARERS * ibm->edge_capacity), sizeof *ibm->sum);
    }
    if (ibm->pieces > ibm->piece_capacity) {
        ibm->piece_capacity = ibm->pieces + ibm->pieces / 4 + 64;
        ibm->piece = memory_renew(MEMORY_IBM, ibm->piece, (size_t)ibm->piece_capacity, sizeof *ibm->piece);
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

static void order_markers(struct ibm *ibm) {
    const int rows = ibm_layout_bins(ibm);
    for (int a = 0; a < ibm->served; a++) place_of(ibm, ibm->route.served + (size_t)a * IBM_ITEM, &ibm->place[a]);
    sort(ibm->served, NULL, ibm->place, 1, ibm->grid->n[0], ibm->bin, ibm->by_x);
    sort(ibm->served, ibm->by_x, ibm->place, 0, rows + ibm->slabs + 1, ibm->bin, ibm->arrival);
    ibm->inner = ibm->bin[rows];
    ibm->near_edges = ibm->bin[rows + ibm->slabs] - ibm->inner;
    ibm->edges = ibm->served - ibm->inner;
    for (int s = 0; s <= ibm->slabs; s++) {
        slab_list(ibm, IBM_INNER)[s] = ibm->bin[s * (rows / ibm->slabs)];
        slab_list(ibm, IBM_NEAR)[s] = ibm->bin[rows + s] - ibm->inner;
    }
}

/* Numbers the pieces: those of near edges one after another, those of far edges by slab. */
static void number_pieces(struct ibm *ibm) {
    const struct fluid_grid *g = ibm->grid;
    int *near = slab_list(ibm, IBM_NEAR_PIECES), *far = slab_list(ibm, IBM_FAR_PIECES), plane[IBM_PIECES];
    for (int s = 0; s <= ibm->slabs; s++) near[s] = far[s] = 0;
    for (int e = 0; e < ibm->edges; e++) {
        struct ibm_edge *edge = &ibm->edge[e];
        const int a = ibm->arrival[ibm->inner + e];
        memcpy(edge->cell, ibm->place[a].cell, sizeof edge->cell);
        edge->mine = 1;
        for (int d = 0; d < 3; d++) edge->mine &= edge->cell[d] >= g->lo[d] && edge->cell[d] < g->lo[d] + g->m[d];
        edge->pieces = ibm_edge_planes(ibm, edge->cell, plane);
        for (int p = 0; p < edge->pieces; p++) {
            edge->piece[p] = ibm_layout_slab_of(ibm, plane[p]);
            (e < ibm->near_edges ? near : far)[edge->piece[p] + 1]++;
        }
    }
    for (int s = 0; s < ibm->slabs; s++) near[s + 1] += near[s];
    far[0] = near[ibm->slabs];
    for (int s = 0; s < ibm->slabs; s++) far[s + 1] += far[s];
    ibm->pieces = far[ibm->slabs];
    int *next = ibm->bin; /* next number for near pieces, then for far ones */
    memcpy(next, near, (size_t)ibm->slabs * sizeof *next);
    memcpy(next + ibm->slabs, far, (size_t)ibm->slabs * sizeof *next);
    for (int e = 0; e < ibm->edges; e++)
        for (int p = 0; p < ibm->edge[e].pieces; p++)
            ibm->edge[e].piece[p] = next[ibm->edge[e].piece[p] + (e < ibm->near_edges ? 0 : ibm->slabs)]++;
}

/* Sets which sums go to which ranks, in an order that both ranks know, and which sums make up the velocity of each far
 * edge. */
static void plan_swaps(struct ibm *ibm) {
    const int size = par_size(), me = par_rank();
    int *count = ibm->peer, *at = ibm->peer + size, *peer = ibm->peer + 2 * size, rank[IBM_SHARERS], peers = 0;
    for (int r = 0; r < size; r++) count[r] = 0;
    for (int pass = 0; pass < 2; pass++) {
        for (int e = ibm->near_edges; e < ibm->edges; e++) {
            struct ibm_edge *edge = &ibm->edge[e];
            edge->summands = ibm_share_ranks(ibm, edge->cell, rank);
            for (int k = 0; k < edge->summands; k++) {
                if (rank[k] == me)
                    edge->summand[k] = e;
                else if (pass == 0)
                    count[rank[k]]++;
                else {
                    ibm->swap_edge[at[rank[k]]] = e;
                    edge->summand[k] = ibm->edges + at[rank[k]]++;
                }
            }
        }
        if (pass == 1) break;
        ibm->swapped = 0;
        for (int r = 0; r < size; r++) {
            at[r] = ibm->swapped;
            ibm->swapped += count[r];
            if (count[r] == 0) continue;
            peer[peers] = r;
            count[peers++] = count[r]; /* peers <= r: count[r] is read before it is overwritten */
        }
    }
    par_swap_set(ibm->swap, peers, peer, count);
}

void ibm_layout(struct ibm *ibm) {
    reserve_markers(ibm);
    order_markers(ibm);
    reserve_edges(ibm);
    number_pieces(ibm);
    reserve_edges(ibm); /* the number of pieces is known now */
    for (int e = 0; e < ibm->edges; e++) {
        struct ibm_edge *edge = &ibm->edge[e];
        for (int p = 0; p < edge->pieces; p++) ibm->piece[edge->piece[p]].edge = e;
        edge->summands = 1;
        edge->summand[0] = e;
        for (int c = 0; c < 3; c++) ibm->sum[e][c] = 0;
    }
    plan_swaps(ibm);
    ibm->moved = 0;
}
