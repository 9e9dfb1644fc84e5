/* Creates and frees the immersed boundary. */
#include "base/ensure.h"
#include "base/memory.h"
#include "base/par.h"
#include "base/par_piece.h"
#include "ibm/state.h"

#include <math.h>

/* For each cell along this direction: the ranks that the block of a marker there reaches. */
static struct ibm_touch *touch_new(const struct fluid_grid *g, int d) {
    const int n = g->n[d];
    struct ibm_touch *touch = memory_new(MEMORY_IBM, (size_t)n, sizeof *touch);
    for (int i = 0; i < n; i++) {
        int low = i - IBM_BEFORE, high = i + IBM_BEHIND;
        if (low < 0) low = g->periodic[d] ? low + n : 0;
        if (high >= n) high = g->periodic[d] ? high - n : n - 1;
        touch[i].low = (short)par_piece_of(g->cut[d], g->ranks[d], low);
        touch[i].high = (short)par_piece_of(g->cut[d], g->ranks[d], high);
    }
    return touch;
}

static int *owner_new(const struct fluid_grid *g, int d) {
    int *owner = memory_new(MEMORY_IBM, (size_t)g->n[d], sizeof *owner);
    for (int i = 0; i < g->n[d]; i++) owner[i] = par_piece_of(g->cut[d], g->ranks[d], i) * (d == 2 ? g->ranks[1] : 1);
    return owner;
}

struct ibm *ibm_new(struct fluid *f, int iterations) {
    ENSURE(iterations >= 0, "%d iterations of the forcing", iterations);
    struct ibm *ibm = memory_new(MEMORY_IBM, 1, sizeof *ibm);
    const struct fluid_grid *g = ibm->grid = fluid_grid_of(f);
    ibm->fluid = f;
    ibm->iterations = iterations;
    ibm->implicit = fluid_input_of(f)->implicit;
    ENSURE(g->halo >= 3, "%d ghost layers: the kernel's rows and the probe need three", g->halo);
    for (int d = 0; d < 3; d++) {
        const int high_side = !g->periodic[d] && g->lo[d] + g->m[d] == g->n[d];
        ibm->inner_low[d] = g->lo[d] + IBM_BEFORE;
        ibm->inner_high[d] = g->lo[d] + g->m[d] - IBM_BEHIND - high_side; /* the last face lies on the side */
        if (d > 0) ibm->touch[d] = touch_new(g, d), ibm->owner[d] = owner_new(g, d);
        for (int c = 0; c < 3; c++)
            for (int side = 0; side < 2; side++) ibm->mirror[c][d][side] = fluid_mirror_predicted(f, c, d, side);
        for (int side = 0; side < 2; side++)
            ibm->is_wall[d][side] = fluid_input_of(f)->side[d][side].type == FLUID_WALL;
    }
    ibm->slabs = g->m[2] / IBM_SLAB > 1 ? g->m[2] / IBM_SLAB : 1;
    ibm->slab_at = memory_new(MEMORY_IBM, IBM_LISTS * (size_t)(ibm->slabs + 1), sizeof *ibm->slab_at);
    ibm->tally = memory_new(MEMORY_IBM, (size_t)ibm->slabs + 1, sizeof *ibm->tally);
    const size_t bins = (size_t)ibm_layout_bins(ibm) + 2 * (size_t)ibm->slabs + 2;
    ibm->bin = memory_new(MEMORY_IBM, bins > (size_t)g->n[0] + 2 ? bins : (size_t)g->n[0] + 2, sizeof *ibm->bin);
    ibm->peer = memory_new(MEMORY_IBM, 3 * (size_t)par_size(), sizeof *ibm->peer);
    ibm->swap = par_swap_new();
    return ibm;
}

void ibm_free(struct ibm *ibm) {
    if (!ibm) return;
    ibm_route_free(&ibm->route);
    ibm_route_free(&ibm->probe);
    par_swap_free(ibm->swap);
    for (int k = 0; k < IBM_VECTORS; k++) memory_free(ibm->vector[k]);
    MEMORY_FREE(ibm->touch[1], ibm->touch[2], ibm->owner[1], ibm->owner[2], ibm->slab_at, ibm->bin, ibm->tally,
                ibm->peer, ibm->arrival, ibm->place, ibm->by_x, ibm->stencil, ibm->increment, ibm->received, ibm->edge,
                ibm->piece, ibm->sum, ibm->sent, ibm->swap_edge, ibm->by_marker, ibm->marker_force, ibm->velocity,
                ibm->change, ibm->away_item, ibm->work.u, ibm->work.received, ibm);
}
