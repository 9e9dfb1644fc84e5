#include "base/par_exchange.h"
#include "base/error.h"
#include "base/par.h"

#include <mpi.h>
#include <stdlib.h>
#include <string.h>

struct par_exchange {
    int n, sent, served;              /* items here, of these sent, items served */
    int *order;                       /* [sent] item index, by destination */
    int *to, *to_at, *from, *from_at; /* [size] counts and offsets */
    int alone;                        /* nothing crosses a rank anywhere */
    char *buffer;
    size_t buffer_bytes;
};

static void *reserve(struct par_exchange *x, size_t bytes) {
    if (bytes > x->buffer_bytes) {
        x->buffer = realloc(x->buffer, bytes);
        x->buffer_bytes = bytes;
        ENSURE(x->buffer, "no memory for %zu bytes", bytes);
    }
    return x->buffer;
}

static int offsets(const int *count, int *at, int size) {
    int total = 0;
    for (int r = 0; r < size; r++) {
        at[r] = total;
        total += count[r];
    }
    return total;
}

struct par_exchange *par_exchange_new(int n, const int *dest) {
    const int size = par_size();
    struct par_exchange *x = calloc(1, sizeof *x);
    x->n = n;
    x->to = calloc(4 * (size_t)size, sizeof(int));
    x->to_at = x->to + size;
    x->from = x->to + 2 * size;
    x->from_at = x->to + 3 * size;
    for (int i = 0; i < n; i++)
        if (dest[i] >= 0) x->to[dest[i]]++;
    x->sent = offsets(x->to, x->to_at, size);
    x->order = malloc((size_t)(x->sent + 1) * sizeof(int));
    int *next = malloc((size_t)size * sizeof(int));
    memcpy(next, x->to_at, (size_t)size * sizeof(int));
    for (int i = 0; i < n; i++)
        if (dest[i] >= 0) x->order[next[dest[i]]++] = i;
    free(next);
    if (size == 1)
        x->from[0] = x->to[0];
    else
        MPI_Alltoall(x->to, 1, MPI_INT, x->from, 1, MPI_INT, MPI_COMM_WORLD);
    x->served = offsets(x->from, x->from_at, size);
    x->alone = size == 1;
    return x;
}

void par_exchange_free(struct par_exchange *x) {
    if (!x) return;
    free(x->to);
    free(x->order);
    free(x->buffer);
    free(x);
}

int par_exchange_count(const struct par_exchange *x) { return x->served; }

/* Pieces of unequal size between all ranks, empty ones not sent. */
static void all_to_some(const char *send, const int *to, const int *to_at, char *recv, const int *from,
                        const int *from_at, size_t bytes) {
    const int size = par_size(), rank = par_rank();
    MPI_Request *request = malloc(2 * (size_t)size * sizeof *request);
    int requests = 0;
    for (int r = 0; r < size; r++)
        if (from[r] > 0 && r != rank)
            MPI_Irecv(recv + (size_t)from_at[r] * bytes, (int)((size_t)from[r] * bytes), MPI_BYTE, r, 71,
                      MPI_COMM_WORLD, &request[requests++]);
    for (int r = 0; r < size; r++)
        if (to[r] > 0 && r != rank)
            MPI_Isend(send + (size_t)to_at[r] * bytes, (int)((size_t)to[r] * bytes), MPI_BYTE, r, 71,
                      MPI_COMM_WORLD, &request[requests++]);
    if (to[rank] > 0)
        memcpy(recv + (size_t)from_at[rank] * bytes, send + (size_t)to_at[rank] * bytes,
               (size_t)to[rank] * bytes);
    MPI_Waitall(requests, request, MPI_STATUSES_IGNORE);
    free(request);
}

void par_exchange_forward(struct par_exchange *x, const void *mine, void *served, size_t bytes) {
    char *pack = x->alone ? served : reserve(x, (size_t)x->sent * bytes + 1);
    for (int k = 0; k < x->sent; k++)
        memcpy(pack + (size_t)k * bytes, (const char *)mine + (size_t)x->order[k] * bytes, bytes);
    if (!x->alone) all_to_some(pack, x->to, x->to_at, served, x->from, x->from_at, bytes);
}

void par_exchange_backward(struct par_exchange *x, const void *served, void *mine, size_t bytes) {
    const char *pack = served;
    if (!x->alone) {
        char *buffer = reserve(x, (size_t)x->sent * bytes + 1);
        all_to_some(served, x->from, x->from_at, buffer, x->to, x->to_at, bytes);
        pack = buffer;
    }
    for (int k = 0; k < x->sent; k++)
        memcpy((char *)mine + (size_t)x->order[k] * bytes, pack + (size_t)k * bytes, bytes);
}

struct par_ghost {
    struct par_exchange *wish; /* the wanting ranks' items; the owners serve them */
    int n, served;
    int *index; /* [served] owned index wanted by others */
    double *value, *arrived;
    int capacity;
};

struct par_ghost *par_ghost_new(const long *first, int n, const long *id) {
    const int size = par_size(), rank = par_rank();
    struct par_ghost *g = calloc(1, sizeof *g);
    int *dest = malloc((size_t)(n + 1) * sizeof *dest);
    for (int i = 0; i < n; i++) {
        int low = 0, high = size - 1;
        while (low < high) {
            const int middle = (low + high + 1) / 2;
            if (first[middle] <= id[i])
                low = middle;
            else
                high = middle - 1;
        }
        dest[i] = low;
    }
    g->n = n;
    g->wish = par_exchange_new(n, dest);
    g->served = par_exchange_count(g->wish);
    long *wanted = malloc((size_t)(g->served + 1) * sizeof *wanted);
    par_exchange_forward(g->wish, id, wanted, sizeof *wanted);
    g->index = malloc((size_t)(g->served + 1) * sizeof *g->index);
    for (int k = 0; k < g->served; k++) g->index[k] = (int)(wanted[k] - first[rank]);
    free(wanted);
    free(dest);
    return g;
}

void par_ghost_free(struct par_ghost *g) {
    if (!g) return;
    par_exchange_free(g->wish);
    free(g->index);
    free(g->value);
    free(g->arrived);
    free(g);
}

void par_ghost_update(struct par_ghost *g, int fields, double *const *field, int n_owned) {
    if (par_size() == 1) return;
    if (fields > g->capacity) {
        g->capacity = fields;
        g->value = realloc(g->value, ((size_t)g->served * (size_t)fields + 1) * sizeof(double));
        g->arrived = realloc(g->arrived, ((size_t)g->n * (size_t)fields + 1) * sizeof(double));
    }
    for (int k = 0; k < g->served; k++)
        for (int f = 0; f < fields; f++) g->value[k * fields + f] = field[f][g->index[k]];
    par_exchange_backward(g->wish, g->value, g->arrived, (size_t)fields * sizeof(double));
    for (int i = 0; i < g->n; i++)
        for (int f = 0; f < fields; f++) field[f][n_owned + i] = g->arrived[i * fields + f];
}

void par_ghost_update_bytes(struct par_ghost *g, unsigned char *field, int n_owned) {
    if (par_size() == 1) return;
    unsigned char *value = malloc((size_t)g->served + 1);
    for (int k = 0; k < g->served; k++) value[k] = field[g->index[k]];
    par_exchange_backward(g->wish, value, field + n_owned, 1);
    free(value);
}

int par_ghost_sent(const struct par_ghost *g, const int **owned_index) {
    *owned_index = g->index;
    return g->served;
}
