/* Markers: sent to the ranks that serve them, sorted by cell, their weights kept while nothing moves. */
#include "base/clock.h"
#include "base/error.h"
#include "base/memory.h"
#include "base/par.h"
#include "ibm/kernel.h"
#include "ibm/state.h"

#include <string.h>

enum { KEPT = 7, PLACED = 4 }; /* position, velocity, volume; wrapped position in cells and volume */

struct ibm *ibm_new(struct fluid *f, int iterations) {
    ENSURE(iterations >= 0, "%d iterations of the forcing", iterations);
    struct ibm *b = memory_new(MEMORY_IBM, 1, sizeof *b);
    b->fluid = f;
    b->grid = fluid_grid_of(f);
    b->iterations = iterations;
    b->x_low = b->grid->m[0];
    b->x_high = 0;
    ENSURE(b->grid->halo >= 3, "%d ghost layers: the kernel and the probe need three", b->grid->halo);
    return b;
}

void ibm_free(struct ibm *b) {
    if (!b) return;
    ibm_route_free(&b->route);
    ibm_route_free(&b->probe);
    memory_free(b->kept);
    memory_free(b->stencil);
    memory_free(b->marker);
    for (int c = 0; c < 3; c++) {
        memory_free(b->increment[c]);
        memory_free(b->received[c]);
        memory_free(b->shell[c]);
    }
    memory_free(b);
}

/* Keeps a copy of what was given; tells whether positions or volumes [0], or velocities [1], differ from the last. */
static void keep(struct ibm *b, int n, const double *const x[3], const double *const v[3],
                 const double *volume, double differs[2]) {
    differs[0] = n != b->route.n || !b->route.plan;
    differs[1] = differs[0];
    ibm_reserve(&b->kept, &b->kept_size, (size_t)n * KEPT);
    for (int h = 0; h < n; h++) {
        const double now[KEPT] = {x[0][h], x[1][h], x[2][h], volume[h], v[0][h], v[1][h], v[2][h]};
        double *last = b->kept + (size_t)h * KEPT;
        for (int i = 0; i < KEPT; i++) {
            if (now[i] != last[i]) differs[i >= PLACED] = 1;
            last[i] = now[i];
        }
    }
}

static void reserve_markers(struct ibm *b, int n) {
    if (!b->shell[0])
        for (int c = 0; c < 3; c++) b->shell[c] = memory_new(MEMORY_IBM, b->grid->size, sizeof(double));
    b->n = n;
    if (n <= b->capacity) return;
    b->capacity = n + n / 4;
    memory_free(b->stencil);
    memory_free(b->marker);
    b->stencil = memory_new(MEMORY_IBM, (size_t)b->capacity, sizeof *b->stencil);
    b->marker = memory_new(MEMORY_IBM, (size_t)b->capacity, sizeof *b->marker);
    for (int c = 0; c < 3; c++) {
        memory_free(b->increment[c]);
        memory_free(b->received[c]);
        b->increment[c] = memory_new(MEMORY_IBM, (size_t)b->capacity, sizeof(double));
        b->received[c] = memory_new(MEMORY_IBM, (size_t)b->capacity, sizeof(double));
    }
}

/* One direction of a marker: the first of three grid points in each alignment, the weights, and the part of the weights'
 * sum that falls on points which take a force. s: position in cells from this rank's first. */
static void set_direction(const struct fluid_grid *g, int d, double s, int first[2], double *weight[2],
                          double share[2], int inside[2]) {
    const double point[2] = {0.5, 1.0}; /* position of the grid point 0 */
    for (int a = 0; a < 2; a++) {
        const double near = floor(s - point[a] + 0.5);
        ibm_kernel_weights(s - point[a] - near, weight[a]);
        first[a] = (int)near - 1;
        /* faces on the domain's sides, and all that is outside, take none */
        const int at_end = g->lo[d] + g->m[d] == g->n[d] && !g->periodic[d];
        inside[a] = first[a] >= 0 && first[a] + 2 < g->m[d] - (a == IBM_FACE && at_end);
        share[a] = 1;
        if (g->periodic[d]) continue;
        for (int i = 0; i < 3; i++) {
            const int global = g->lo[d] + first[a] + i;
            if (global < 0 || global >= g->n[d] - (a == IBM_FACE)) share[a] -= weight[a][i];
        }
    }
}

/* Offsets, weights, share and place of one marker; returns, by bits, the directions in which it is not inside. */
static int set_marker(const struct ibm *b, const double s[3], struct ibm_stencil *stencil,
                      struct ibm_marker *marker, int x[2]) {
    static const int part[3] = {IBM_X, IBM_Y, IBM_Z};
    int first[3][2], inside[3][2], outside = 0;
    double share[3][2];
    for (int d = 0; d < 3; d++) {
        double *weight[2] = {stencil->weight[IBM_CENTRE] + part[d], stencil->weight[IBM_FACE] + part[d]};
        set_direction(b->grid, d, s[d] - b->grid->lo[d], first[d], weight, share[d], inside[d]);
        if (!inside[d][0] || !inside[d][1]) outside |= 1 << d;
    }
    stencil->weight[0][3] = stencil->weight[1][3] = 0;
    for (int c = 0; c < 3; c++) {
        stencil->at[c] =
            (ptrdiff_t)fluid_grid_at(b->grid, first[0][c == 0], first[1][c == 1], first[2][c == 2]);
        marker->share[c] = share[0][c == 0] * share[1][c == 1] * share[2][c == 2];
    }
    marker->inside = !outside;
    const int low = first[0][0] < first[0][1] ? first[0][0] : first[0][1];
    const int high = first[0][0] > first[0][1] ? first[0][0] : first[0][1];
    if (low < x[0]) x[0] = low;
    if (high + 3 > x[1]) x[1] = high + 3;
    return outside;
}

/* Sends positions and volumes to the ranks that serve them, and sets the weights there. */
static void place(struct ibm *b, int n, const double *const x[3], const double *volume) {
    const struct fluid_grid *g = b->grid;
    struct ibm_route *route = &b->route;
    const int renewed = ibm_route_set(route, g, n, x);
    ibm_reserve(&route->mine, &route->mine_size, (size_t)n * PLACED);
    for (int h = 0; h < n; h++) {
        double *item = route->mine + (size_t)h * PLACED;
        for (int d = 0; d < 3; d++) item[d] = ibm_wrap(g, d, x[d][h]);
        item[3] = volume[h] / (g->d[0] * g->d[1] * g->d[2]);
    }
    reserve_markers(b, par_exchange_count(route->plan));
    ibm_reserve(&route->served, &route->served_size, (size_t)b->n * PLACED);
    par_exchange_forward(route->plan, route->mine, route->served, PLACED * sizeof(double));
    if (renewed) ibm_route_sort(route, g, route->served, PLACED);

    int range[2] = {b->x_low, b->x_high}, outside = 0;
    for (int k = 0; k < b->n; k++) {
        const double *item = route->served + (size_t)route->order[k] * PLACED;
        outside |= set_marker(b, item, &b->stencil[k], &b->marker[k], range);
        b->marker[k].volume = item[3];
    }
    double all[4] = {outside != 0, outside & 1, -range[0], range[1]};
    par_max_array(all, 4);
    b->crossing = all[0] > 0;
    b->crossing_x |= all[1] > 0; /* these only grow, so that what was written is always cleared */
    b->x_low = (int)-all[2];
    b->x_high = (int)all[3];
}

static void send_velocities(struct ibm *b, int n, const double *const v[3]) {
    struct ibm_route *route = &b->route;
    for (int h = 0; h < n; h++)
        for (int d = 0; d < 3; d++) route->mine[(size_t)h * 3 + (size_t)d] = v[d][h];
    par_exchange_forward(route->plan, route->mine, route->served, 3 * sizeof(double));
    for (int k = 0; k < b->n; k++)
        memcpy(b->marker[k].v, route->served + (size_t)route->order[k] * 3, 3 * sizeof(double));
}

void ibm_markers(struct ibm *b, int n, const double *const x[3], const double *const v[3],
                 const double *volume) {
    clock_begin(CLOCK_FORCING);
    double differs[2];
    keep(b, n, x, v, volume, differs);
    par_max_array(differs, 2);
    if (differs[0] > 0) place(b, n, x, volume);
    if (differs[1] > 0 || differs[0] > 0) send_velocities(b, n, v);
    clock_end(CLOCK_FORCING);
}
