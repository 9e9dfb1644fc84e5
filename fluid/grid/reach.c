/* Finds which ghost cells of this rank lie in a given box of cells. */
#include "fluid/grid/reach.h"

#include <string.h>

/* Cells low .. high-1 of one direction. */
struct range {
    int low, high;
};

/* The smallest range of local cells, within first .. last-1, that holds all of the box's cells there. */
static struct range seen(const struct fluid_grid *g, int d, struct range box, int first, int last) {
    struct range r = {last, first};
    for (int i = first; i < last; i++) {
        int in = 0;
        for (int image = -1; image <= 1; image++) {
            const int at = i + g->lo[d] + image * g->n[d];
            in |= (image == 0 || g->periodic[d]) && at >= box.low && at < box.high;
        }
        if (in && i < r.low) r.low = i;
        if (in) r.high = i + 1;
    }
    return r;
}

struct par_halo_part fluid_reach(const struct fluid_grid *g, int layers, const int low[3], const int high[3]) {
    struct par_halo_part part = {.layers = layers};
    for (int d = 0; d < 3; d++) {
        const int n = g->n[d], m = g->m[d];
        struct range box = {low[d], high[d]};
        if (!g->periodic[d] && low[d] < 0 && high[d] < layers + 1) box.high = layers + 1;
        if (!g->periodic[d] && high[d] >= n && low[d] > n - layers - 1) box.low = n - layers - 1;
        const struct range all = seen(g, d, box, -layers, m + layers);
        part.low[d] = all.low;
        part.high[d] = all.high;
        for (int side = 0; side < 2; side++) {
            const int ghost = side ? m : -layers, own = side ? m - layers : 0;
            const struct range ghosts = seen(g, d, box, ghost, ghost + layers),
                               cells = seen(g, d, box, own, own + layers);
            part.wanted[d][side] = ghosts.low < ghosts.high;
            part.asked[d][side] = cells.low < cells.high;
        }
    }
    return part;
}
