/* Buffers and exchange plan that carry items from the particles' ranks to the fluid's ranks and back. */
#include "base/memory.h"
#include "ibm/state.h"

#include <string.h>

int ibm_route_reserve(struct ibm_route *route, int n, size_t doubles) {
    const int other = n != route->n || !route->plan;
    route->n = n;
    if (n > route->capacity || !route->key) {
        MEMORY_FREE(route->key, route->item, route->dest, route->mine);
        route->capacity = n + n / 4 + 64;
        const size_t capacity = (size_t)route->capacity;
        route->key = memory_new(MEMORY_IBM, capacity, sizeof *route->key);
        route->item = memory_new(MEMORY_IBM, IBM_SHARERS * capacity, sizeof *route->item);
        route->dest = memory_new(MEMORY_IBM, IBM_SHARERS * capacity, sizeof *route->dest);
        route->mine = memory_new(MEMORY_IBM, capacity, doubles * sizeof *route->mine);
    }
    return other;
}

void ibm_route_free(struct ibm_route *route) {
    par_exchange_free(route->plan);
    MEMORY_FREE(route->key, route->item, route->dest, route->mine, route->served);
    memset(route, 0, sizeof *route);
}
