/* Ghost copies of particles: each rank gets the values of items that other ranks own. */
#include "base/par_ghost.h"
#include "base/ensure.h"
#include "base/par.h"
#include "base/par_exchange_private.h"
#include "base/par_wait.h"
#include "base/sort.h"

#include <stdlib.h>
#include <string.h>

enum { GHOST_FIELDS = 8 };

struct par_ghost {
    struct par_exchange *exchange; /* the copies wanted here; the owning ranks serve them */
    int n, served;
    int *index;    /* [served] the owned index of each item that another rank wants */
    double *value; /* [served][fields] */
    int capacity;
    double *given; /* [n][fields] as sent by par_ghost_add, then [served][fields] as arrived */
    int given_capacity;
    /* of the update underway */
    int fields, receiving, sending; /* requests: what arrives, then what was sent */
    double *field[GHOST_FIELDS];    /* at the first ghost */
};

struct par_ghost *par_ghost_new(const long *first, int n, const long *id) {
    const int size = par_size(), rank = par_rank();
    struct par_ghost *g = calloc(1, sizeof *g);
    int *dest = malloc((size_t)(n + 1) * sizeof *dest);
    for (int i = 0; i < n; i++) dest[i] = (int)sort_find(first, size, id[i]);
    g->n = n;
    g->exchange = par_exchange_new(n, dest);
    g->exchange->kind = PAR_COUNT_GHOST;
    g->served = par_exchange_count(g->exchange);
    long *wanted = malloc((size_t)(g->served + 1) * sizeof *wanted);
    par_exchange_forward(g->exchange, id, wanted, sizeof *wanted);
    g->index = malloc((size_t)(g->served + 1) * sizeof *g->index);
    for (int k = 0; k < g->served; k++) g->index[k] = (int)(wanted[k] - first[rank]);
    free(wanted);
    free(dest);
    return g;
}

/* Waits until the messages of the update before have left. */
static void settle(struct par_ghost *g) {
    PAR_WAIT(MPI_Waitall(g->sending, g->exchange->request + g->receiving, MPI_STATUSES_IGNORE));
    g->sending = 0;
}

void par_ghost_free(struct par_ghost *g) {
    if (!g) return;
    settle(g);
    par_exchange_free(g->exchange);
    free(g->index);
    free(g->value);
    free(g->given);
    free(g);
}

int par_ghost_served(const struct par_ghost *g, const int **index) {
    *index = g->index;
    return g->served;
}

void par_ghost_begin(struct par_ghost *g, int fields, double *const *field, int n_owned) {
    struct par_exchange *x = g->exchange;
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
    char *pack = par_exchange_reserve(x, (size_t)x->sent * bytes + 1);
    const int requests =
        par_exchange_begin(x, (const char *)g->value, x->from, x->from_at, pack, x->to, x->to_at, bytes);
    g->receiving = 0;
    for (int r = 0; r < size; r++) g->receiving += x->to[r] > 0 && r != par_rank();
    g->sending = requests - g->receiving;
    g->fields = fields;
    for (int f = 0; f < fields; f++) g->field[f] = field[f] + n_owned;
}

void par_ghost_end(struct par_ghost *g) {
    struct par_exchange *x = g->exchange;
    if (!g->fields) return;
    PAR_WAIT(MPI_Waitall(g->receiving, x->request, MPI_STATUSES_IGNORE));
    const double *arrived = (const double *)(const void *)x->buffer;
    for (int k = 0; k < x->sent; k++)
        for (int f = 0; f < g->fields; f++) g->field[f][x->order[k]] = arrived[k * g->fields + f];
    g->fields = 0;
}

void par_ghost_update(struct par_ghost *g, int fields, double *const *field, int n_owned) {
    par_ghost_begin(g, fields, field, n_owned);
    par_ghost_end(g);
}

void par_ghost_add(struct par_ghost *g, int fields, double *const *field, int n_owned) {
    if (par_size() == 1) return;
    settle(g);
    const size_t bytes = (size_t)fields * sizeof(double);
    if (fields > g->given_capacity) {
        g->given_capacity = fields;
        g->given = realloc(g->given, ((size_t)g->n + (size_t)g->served) * bytes + 1);
        ENSURE(g->given, "no memory for %d ghosts", g->n);
    }
    double *const sent = g->given, *const arrived = g->given + (size_t)g->n * (size_t)fields;
    for (int i = 0; i < g->n; i++)
        for (int f = 0; f < fields; f++) sent[i * fields + f] = field[f][n_owned + i];
    par_exchange_forward(g->exchange, sent, arrived, bytes);
    for (int k = 0; k < g->served; k++)
        for (int f = 0; f < fields; f++) field[f][g->index[k]] += arrived[k * fields + f];
}

void par_ghost_update_records(struct par_ghost *g, size_t bytes, void *record, int n_owned) {
    if (par_size() == 1) return;
    settle(g);
    char *value = malloc((size_t)g->served * bytes + 1), *item = record;
    ENSURE(value, "no memory for %d ghosts", g->served);
    for (int k = 0; k < g->served; k++) memcpy(value + (size_t)k * bytes, item + (size_t)g->index[k] * bytes, bytes);
    par_exchange_backward(g->exchange, value, item + (size_t)n_owned * bytes, bytes);
    free(value);
}

void par_ghost_update_bytes(struct par_ghost *g, unsigned char *field, int n_owned) {
    par_ghost_update_records(g, 1, field, n_owned);
}
