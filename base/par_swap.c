/* Exchange of values that pairs of ranks share in a common order. */
#include "base/par_swap.h"
#include "base/ensure.h"
#include "base/par_count.h"
#include "base/par_wait.h"

#include <mpi.h>
#include <stdlib.h>
#include <string.h>

enum { TAG = 72 };

struct par_swap {
    int peers, capacity;
    int *rank, *count; /* [peers] */
    MPI_Request *request;
};

struct par_swap *par_swap_new(void) {
    return calloc(1, sizeof(struct par_swap));
}

void par_swap_free(struct par_swap *s) {
    if (!s) return;
    free(s->rank);
    free(s->count);
    free(s->request);
    free(s);
}

void par_swap_set(struct par_swap *s, int peers, const int *rank, const int *count) {
    if (peers > s->capacity) {
        s->capacity = peers;
        s->rank = realloc(s->rank, (size_t)peers * sizeof *s->rank);
        s->count = realloc(s->count, (size_t)peers * sizeof *s->count);
        s->request = realloc(s->request, 2 * (size_t)peers * sizeof *s->request);
        ENSURE(s->rank && s->count && s->request, "no memory to swap with %d ranks", peers);
    }
    s->peers = peers;
    if (peers == 0) return;
    memcpy(s->rank, rank, (size_t)peers * sizeof *rank);
    memcpy(s->count, count, (size_t)peers * sizeof *count);
}

void par_swap(struct par_swap *s, const double *send, double *received, int doubles) {
    size_t at = 0;
    for (int p = 0; p < s->peers; p++) {
        const int n = s->count[p] * doubles;
        par_count_message(PAR_COUNT_HALO, (size_t)n * sizeof(double));
        MPI_Irecv(received + at, n, MPI_DOUBLE, s->rank[p], TAG, MPI_COMM_WORLD, &s->request[2 * p]);
        MPI_Isend(send + at, n, MPI_DOUBLE, s->rank[p], TAG, MPI_COMM_WORLD, &s->request[2 * p + 1]);
        at += (size_t)n;
    }
    PAR_WAIT(MPI_Waitall(2 * s->peers, s->request, MPI_STATUSES_IGNORE));
}
