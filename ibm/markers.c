/* Sends markers to the ranks whose cells they reach, and renews their kernel weights when they move. */
#include "base/clock.h"
#include "base/par.h"
#include "ibm/cell.h"
#include "ibm/state.h"

#include <math.h>
#include <string.h>

/* The ranks that a marker's block reaches, as one number; -1: the marker is outside the domain. */
static long key_of(const struct ibm *ibm, const double item[IBM_ITEM]) {
    int cell[3];
    for (int d = 0; d < 3; d++) cell[d] = ibm_cell(ibm->grid, d, item[d]);
    if (cell[0] < 0 || cell[1] < 0 || cell[2] < 0) return -1;
    const struct ibm_touch y = ibm->touch[1][cell[1]], z = ibm->touch[2][cell[2]];
    return ((((long)z.high << 16 | z.low) << 16 | y.high) << 16) | y.low;
}

/* Makes the items to send and compares them with the last ones. differs[0]: a different rank must serve some item; [1]:
 * some number has changed. */
static void fill(struct ibm *ibm, int n, const double *const x[3], const double *const v[3], const double *volume,
                 double differs[2]) {
    const struct fluid_grid *g = ibm->grid;
    const double cell_volume = g->d[0] * g->d[1] * g->d[2];
    int other_rank = ibm_route_reserve(&ibm->route, n, IBM_ITEM), other = other_rank;
    for (int h = 0; h < n; h++) {
        double item[IBM_ITEM], *last = ibm->route.mine + (size_t)h * IBM_ITEM;
        for (int d = 0; d < 3; d++) {
            item[IBM_X + d] = ibm_cell_wrap(g, d, x[d][h]);
            item[IBM_V + d] = v[d][h];
        }
        item[IBM_VOLUME] = volume[h] / cell_volume;
        const long key = key_of(ibm, item);
        other_rank |= key != ibm->route.key[h];
        for (int i = 0; i < IBM_ITEM; i++) other |= item[i] != last[i];
        ibm->route.key[h] = key;
        memcpy(last, item, sizeof item);
    }
    differs[0] = other_rank;
    differs[1] = other | other_rank;
}

double ibm_markers_fraction(const struct ibm *ibm, int d, double x) {
    return ibm->grid->periodic[d] ? 1 : ibm_edge_fraction(ibm, d, ibm_cell_wrap(ibm->grid, d, x));
}

/* Plans a copy of the marker to each rank whose cells its block reaches. */
static void renew_plan(struct ibm *ibm) {
    struct ibm_route *route = &ibm->route;
    int copies = 0;
    for (int h = 0; h < route->n; h++) {
        const double *item = route->mine + (size_t)h * IBM_ITEM;
        int cell[3], rank[IBM_SHARERS];
        if (route->key[h] < 0) continue;
        for (int d = 0; d < 3; d++) cell[d] = ibm_cell(ibm->grid, d, item[d]);
        const int sharers = ibm_share_ranks(ibm, cell, rank);
        for (int k = 0; k < sharers; k++, copies++) route->item[copies] = h, route->dest[copies] = rank[k];
    }
    route->plan = par_exchange_renew(route->plan, copies, route->item, route->dest);
    ibm->served = par_exchange_count(route->plan);
    ibm_buffer_reserve(&route->served, &route->served_size, (size_t)ibm->served * IBM_ITEM + 1);
}

/* Index of the block of a marker that is above its cell's centre in all directions. It is different for each cell that
 * a marker served here may be in. */
static int64_t block_of(const struct fluid_grid *g, const int cell[3]) {
    return (int64_t)fluid_grid_at(g, cell[0] - g->lo[0] - 1, cell[1] - g->lo[1] - 1, cell[2] - g->lo[2] - 1);
}

/* New weights for markers that have moved. Returns 0 if a marker has left its slab, or if many have left their cells:
 * all must then be sorted again. */
static int renew_weights(struct ibm *ibm, int fresh) {
    for (int h = 0; h < ibm->inner; h++) {
        const double *item = ibm->route.served + (size_t)ibm->arrival[h] * IBM_ITEM;
        struct ibm_stencil *s = &ibm->stencil[h];
        int cell[3];
        for (int d = 0; d < 3; d++) {
            cell[d] = ibm_cell(ibm->grid, d, item[d]);
            s->t[d] = item[d] - cell[d] - 0.5;
        }
        memcpy(s->v, item + IBM_V, sizeof s->v);
        s->volume = item[IBM_VOLUME];
        const int64_t last = s->at;
        s->at = block_of(ibm->grid, cell);
        if (!fresh && s->at != last) {
            const int slab = ibm_layout_slab_of(ibm, cell[2] - ibm->grid->lo[2]);
            if (!ibm_layout_is_inner(ibm, cell) || h < ibm_slab_first(ibm, IBM_INNER, slab) ||
                h >= ibm_slab_first(ibm, IBM_INNER, slab + 1))
                return 0;
            ibm->moved++;
        }
    }
    for (int e = 0; e < ibm->edges; e++) {
        const double *item = ibm->route.served + (size_t)ibm->arrival[ibm->inner + e] * IBM_ITEM;
        struct ibm_edge *edge = &ibm->edge[e];
        int moved = fresh;
        for (int d = 0; d < 3; d++) {
            if (ibm_cell(ibm->grid, d, item[d]) != edge->cell[d]) return 0;
            moved |= edge->s[d] != item[d];
        }
        memcpy(edge->s, item, sizeof edge->s);
        memcpy(edge->v, item + IBM_V, sizeof edge->v);
        edge->volume = item[IBM_VOLUME];
        if (moved) ibm_edge_set(ibm, edge);
    }
    return ibm->moved <= ibm->inner / 4;
}

void ibm_markers_sort_again(struct ibm *ibm) { ibm->must_sort = 1; }

void ibm_markers_set(struct ibm *ibm, int n, const double *const x[3], const double *const v[3], const double *volume) {
    clock_begin(CLOCK_FORCING);
    double differs[2];
    const int before = ibm->route.n;
    if (ibm_marker_force_is_kept(ibm) && !ibm->marker_force_is_next) ibm_marker_force_collect(ibm);
    fill(ibm, n, x, v, volume, differs);
    par_max_array(differs, 2);
    if (differs[0] > 0) renew_plan(ibm);
    if (differs[0] > 0 || differs[1] > 0 || ibm->must_sort) {
        par_exchange_forward(ibm->route.plan, ibm->route.mine, ibm->route.served, IBM_ITEM * sizeof(double));
        if (differs[0] > 0 || ibm->must_sort || !renew_weights(ibm, 0)) {
            ibm_layout(ibm);
            renew_weights(ibm, 1);
            ibm->must_sort = 0;
        }
    }
    if (ibm_marker_force_is_kept(ibm)) ibm_marker_force_distribute(ibm, n == before);
    clock_end(CLOCK_FORCING);
}
