/* Exchange of items between two distributions over ranks, and of ghost copies of particles. */
#include "base/par_exchange.h"
#include "base/ensure.h"
#include "base/par.h"
#include "base/par_count.h"

#include <mpi.h>
#include <stdlib.h>
#include <string.h>

struct par_exchange {
    int sent, served;                        /* copies sent, items served */
    int *order, capacity;                    /* [sent] the item of each copy, by destination */
    int *to, *to_at, *from, *from_at, *next; /* [size] counts and offsets */
    int in_order;                            /* 1: all items stay on this rank, in their order */
    char *buffer;
    size_t buffer_bytes;
    MPI_Request *request;     /* [2 size] */
    enum par_count_kind kind; /* the kind that its messages count as */
};

static char *reserve(struct par_exchange *x, size_t bytes) {
    if (bytes > x->buffer_bytes) {
        free(x->buffer);
        x->buffer_bytes = bytes + bytes / 4;
        x->buffer = malloc(x->buffer_bytes);
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

static struct par_exchange *empty(void) {
    const size_t size = (size_t)par_size();
    struct par_exchange *x = calloc(1, sizeof *x);
    ENSURE(x, "no memory for %zu bytes", sizeof *x);
    x->to = calloc(5 * size, sizeof(int));
    x->request = malloc(2 * size * sizeof *x->request);
    ENSURE(x->to && x->request, "no memory to exchange with %zu ranks", size);
    x->to_at = x->to + size;
    x->from = x->to + 2 * size;
    x->from_at = x->to + 3 * size;
    x->next = x->to + 4 * size;
    return x;
}

struct par_exchange *par_exchange_new(int n, const int *dest) {
    return par_exchange_renew(NULL, n, NULL, dest);
}

struct par_exchange *par_exchange_renew(struct par_exchange *x, int n, const int *item, const int *dest) {
    const int size = par_size();
    if (!x) x = empty();
    for (int r = 0; r < size; r++) x->to[r] = 0;
    for (int c = 0; c < n; c++)
        if (dest[c] >= 0) x->to[dest[c]]++;
    x->sent = offsets(x->to, x->to_at, size);
    if (x->sent > x->capacity || !x->order) {
        free(x->order);
        x->capacity = x->sent + x->sent / 4 + 1;
        x->order = malloc((size_t)x->capacity * sizeof(int));
        ENSURE(x->order, "no memory for %d items", x->capacity);
    }
    memcpy(x->next, x->to_at, (size_t)size * sizeof(int));
    x->in_order = size == 1;
    for (int c = 0; c < n; c++)
        if (dest[c] >= 0) {
            const int k = x->next[dest[c]]++, i = item ? item[c] : c;
            x->order[k] = i;
            x->in_order &= k == i;
        }
    if (size == 1)
        x->from[0] = x->to[0];
    else
        MPI_Alltoall(x->to, 1, MPI_INT, x->from, 1, MPI_INT, MPI_COMM_WORLD);
    if (size > 1) par_count_collective(x->kind, (size_t)size * sizeof(int));
    x->served = offsets(x->from, x->from_at, size);
    return x;
}

void par_exchange_free(struct par_exchange *x) {
    if (!x) return;
    free(x->to);
    free(x->order);
    free(x->buffer);
    free(x->request);
    free(x);
}

int par_exchange_count(const struct par_exchange *x) { return x->served; }

/* Begins the exchange of pieces of unequal size between all ranks; empty pieces and this rank's own are not sent. */
static int begin(struct par_exchange *x, const char *send, const int *to, const int *to_at, char *recv, const int *from,
                 const int *from_at, size_t bytes) {
    const int size = par_size(), rank = par_rank();
    int requests = 0;
    for (int r = 0; r < size; r++)
        if (from[r] > 0 && r != rank)
            MPI_Irecv(recv + (size_t)from_at[r] * bytes, (int)((size_t)from[r] * bytes), MPI_BYTE, r, 71,
                      MPI_COMM_WORLD, &x->request[requests++]);
    for (int r = 0; r < size; r++)
        if (to[r] > 0 && r != rank) {
            MPI_Isend(send + (size_t)to_at[r] * bytes, (int)((size_t)to[r] * bytes), MPI_BYTE, r, 71, MPI_COMM_WORLD,
                      &x->request[requests++]);
            par_count_message(x->kind, (size_t)to[r] * bytes);
        }
    return requests;
}

/* Packs and sends what goes to other ranks first, then copies this rank's own items while the messages travel. */
void par_exchange_forward(struct par_exchange *x, const void *mine, void *served, size_t bytes) {
    const int size = par_size(), rank = par_rank();
    if (x->in_order) {
        if (x->sent > 0) memcpy(served, mine, (size_t)x->sent * bytes);
        return;
    }
    char *pack = size > 1 ? reserve(x, (size_t)x->sent * bytes + 1) : NULL;
    for (int r = 0; r < size; r++)
        for (int k = x->to_at[r]; k < x->to_at[r] + x->to[r] && r != rank; k++)
            memcpy(pack + (size_t)k * bytes, (const char *)mine + (size_t)x->order[k] * bytes, bytes);
    const int requests = begin(x, pack, x->to, x->to_at, served, x->from, x->from_at, bytes);
    for (int k = 0; k < x->to[rank]; k++)
        memcpy((char *)served + (size_t)(x->from_at[rank] + k) * bytes,
               (const char *)mine + (size_t)x->order[x->to_at[rank] + k] * bytes, bytes);
    MPI_Waitall(requests, x->request, MPI_STATUSES_IGNORE);
}

void par_exchange_backward(struct par_exchange *x, const void *served, void *mine, size_t bytes) {
    const int size = par_size(), rank = par_rank();
    if (x->in_order) {
        if (x->sent > 0) memcpy(mine, served, (size_t)x->sent * bytes);
        return;
    }
    char *pack = size > 1 ? reserve(x, (size_t)x->sent * bytes + 1) : NULL;
    const int requests = begin(x, served, x->from, x->from_at, pack, x->to, x->to_at, bytes);
    for (int k = 0; k < x->to[rank]; k++)
        memcpy((char *)mine + (size_t)x->order[x->to_at[rank] + k] * bytes,
               (const char *)served + (size_t)(x->from_at[rank] + k) * bytes, bytes);
    MPI_Waitall(requests, x->request, MPI_STATUSES_IGNORE);
    for (int r = 0; r < size; r++)
        for (int k = x->to_at[r]; k < x->to_at[r] + x->to[r] && r != rank; k++)
            memcpy((char *)mine + (size_t)x->order[k] * bytes, pack + (size_t)k * bytes, bytes);
}

enum { GHOST_FIELDS = 8 };

struct par_ghost {
    struct par_exchange *wish; /* the copies wanted here; the owning ranks serve them */
    int n, served;
    int *index;    /* [served] the owned index of each item that another rank wants */
    double *value; /* [served][fields] */
    int capacity;
    /* of the update underway */
    int fields, receiving, sending; /* requests: what arrives, then what was sent */
    double *field[GHOST_FIELDS];    /* at the first ghost */
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
    g->wish->kind = PAR_COUNT_GHOST;
    g->served = par_exchange_count(g->wish);
    long *wanted = malloc((size_t)(g->served + 1) * sizeof *wanted);
    par_exchange_forward(g->wish, id, wanted, sizeof *wanted);
    g->index = malloc((size_t)(g->served + 1) * sizeof *g->index);
    for (int k = 0; k < g->served; k++) g->index[k] = (int)(wanted[k] - first[rank]);
    free(wanted);
    free(dest);
    return g;
}

/* Waits until the messages of the update before have left. */
static void settle(struct par_ghost *g) {
    MPI_Waitall(g->sending, g->wish->request + g->receiving, MPI_STATUSES_IGNORE);
    g->sending = 0;
}

void par_ghost_free(struct par_ghost *g) {
    if (!g) return;
    settle(g);
    par_exchange_free(g->wish);
    free(g->index);
    free(g->value);
    free(g);
}

void par_ghost_begin(struct par_ghost *g, int fields, double *const *field, int n_owned) {
    struct par_exchange *x = g->wish;
    const int size = par_size();
    if (size == 1) return;
    ENSURE(fields <= GHOST_FIELDS && !g->fields, "%d fields of ghosts, %d underway", fields, g->fields);
    settle(g);
    if (fields > g->capacity) {
        g->capacity = fields;
        g->value = realloc(g->value, ((size_t)g->served * (size_t)fields + 1) * sizeof(double));
        ENSURE(g->value, "no memory for %d ghosts", g->served);
    }
    for (int k = 0; k < g->served; k++)
        for (int f = 0; f < fields; f++) g->value[k * fields + f] = field[f][g->index[k]];
    const size_t bytes = (size_t)fields * sizeof(double);
    char *pack = reserve(x, (size_t)x->sent * bytes + 1);
    const int requests = begin(x, (const char *)g->value, x->from, x->from_at, pack, x->to, x->to_at, bytes);
    g->receiving = 0;
    for (int r = 0; r < size; r++) g->receiving += x->to[r] > 0 && r != par_rank();
    g->sending = requests - g->receiving;
    g->fields = fields;
    for (int f = 0; f < fields; f++) g->field[f] = field[f] + n_owned;
}

void par_ghost_end(struct par_ghost *g) {
    struct par_exchange *x = g->wish;
    if (!g->fields) return;
    MPI_Waitall(g->receiving, x->request, MPI_STATUSES_IGNORE);
    const double *arrived = (const double *)(const void *)x->buffer;
    for (int k = 0; k < x->sent; k++)
        for (int f = 0; f < g->fields; f++) g->field[f][x->order[k]] = arrived[k * g->fields + f];
    g->fields = 0;
}

void par_ghost_update(struct par_ghost *g, int fields, double *const *field, int n_owned) {
    par_ghost_begin(g, fields, field, n_owned);
    par_ghost_end(g);
}

void par_ghost_update_bytes(struct par_ghost *g, unsigned char *field, int n_owned) {
    if (par_size() == 1) return;
    settle(g);
    unsigned char *value = malloc((size_t)g->served + 1);
    for (int k = 0; k < g->served; k++) value[k] = field[g->index[k]];
    par_exchange_backward(g->wish, value, field + n_owned, 1);
    free(value);
}
