/* From the particles' layout to the fluid's and back: each point is served by the rank that owns its cell.  (001: sec. 4.3) */
#include "base/error.h"
#include "base/memory.h"
#include "base/par.h"
#include "ibm/state.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void ibm_reserve(double **buffer, size_t *size, size_t wanted) {
    if (wanted <= *size) return;
    memory_free(*buffer);
    *size = wanted + wanted / 4;
    *buffer = memory_new(MEMORY_IBM, *size, sizeof(double));
}

double ibm_wrap(const struct fluid_grid *g, int direction, double x) {
    const double n = g->n[direction];
    double s = x / g->d[direction];
    if (g->periodic[direction]) {
        s -= n * floor(s / n);
        if (s >= n) s = 0; /* a hair below zero rounds to n */
    }
    return s;
}

int ibm_route_set(struct ibm_route *route, const struct fluid_grid *grid, int n, const double *const x[3]) {
    double renew = !route->plan || n != route->n;
    if (n > route->capacity) {
        memory_free(route->dest);
        route->capacity = n + n / 4;
        route->dest = memory_new(MEMORY_IBM, (size_t)route->capacity, sizeof *route->dest);
    }
    for (int h = 0; h < n; h++) {
        double at[3];
        for (int d = 0; d < 3; d++) at[d] = ibm_wrap(grid, d, x[d][h]) * grid->d[d];
        const int dest = fluid_grid_rank_of(grid, at);
        renew += dest != route->dest[h];
        route->dest[h] = dest;
    }
    route->n = n;
    if (par_max(renew) == 0) return 0;
    par_exchange_free(route->plan);
    route->plan = par_exchange_new(n, route->dest);
    return 1;
}

struct cell_of_item {
    long cell;
    int item;
};

static int compare_cells(const void *a, const void *b) {
    const struct cell_of_item *p = a, *q = b;
    if (p->cell != q->cell) return p->cell < q->cell ? -1 : 1;
    return p->item - q->item;
}

/* Strips sixteen cells wide in y, plane after plane, x fastest: what the next few planes of a strip touch stays in a core's
 * own cache. */
void ibm_route_sort(struct ibm_route *route, const struct fluid_grid *grid, const double *s, size_t stride) {
    enum { STRIP = 16 };
    const int n = par_exchange_count(route->plan);
    if (n > route->order_capacity) {
        memory_free(route->order);
        route->order_capacity = n + n / 4;
        route->order = memory_new(MEMORY_IBM, (size_t)route->order_capacity, sizeof *route->order);
    }
    struct cell_of_item *key = malloc(((size_t)n + 1) * sizeof *key);
    ENSURE(key, "no memory to sort %d items", n);
    for (int h = 0; h < n; h++) {
        const double *at = s + (size_t)h * stride;
        const long i = (long)at[0], j = (long)at[1], k = (long)at[2];
        key[h].cell = (((j / STRIP) * grid->n[2] + k) * STRIP + j % STRIP) * grid->n[0] + i;
        key[h].item = h;
    }
    qsort(key, (size_t)n, sizeof *key, compare_cells);
    for (int h = 0; h < n; h++) route->order[h] = key[h].item;
    free(key);
}

void ibm_route_free(struct ibm_route *route) {
    par_exchange_free(route->plan);
    memory_free(route->dest);
    memory_free(route->order);
    memory_free(route->mine);
    memory_free(route->served);
    memset(route, 0, sizeof *route);
}
