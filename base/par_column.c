/* Exchanges values of z columns that are divided over ranks, each column with the rank that solves it. */
#include "base/par_column.h"
#include "base/clock.h"
#include "base/ensure.h"
#include "base/memory.h"
#include "base/par_count.h"
#include "base/par_piece.h"
#include "base/par_wait.h"

#include <mpi.h>
#include <stdlib.h>
#include <string.h>

struct par_column {
    int parts, place, owners, columns, values;
    int *rank;      /* [parts] */
    double *packed; /* [columns of an owner][values][...] one block after another */
    double *own;    /* its memory; NULL: it is borrowed */
    MPI_Request *request;
};

struct par_column *par_column_new(const struct par_column_input *in) {
    struct par_column *c = calloc(1, sizeof *c);
    ENSURE(c && in->owners >= 1 && in->owners <= in->parts, "%d of %d ranks own columns", in->owners, in->parts);
    c->parts = in->parts;
    c->place = in->place;
    c->owners = in->owners;
    c->columns = in->columns;
    c->values = in->values;
    c->rank = calloc((size_t)in->parts, sizeof *c->rank);
    memcpy(c->rank, in->rank, (size_t)in->parts * sizeof *c->rank);
    const size_t packed = (size_t)in->columns * (size_t)in->values + 1;
    if (packed > in->capacity) c->own = memory_new(MEMORY_FLUID, packed, sizeof(double));
    c->packed = c->own ? c->own : in->work;
    c->request = calloc(2 * (size_t)in->parts, sizeof *c->request);
    return c;
}

void par_column_free(struct par_column *c) {
    if (!c) return;
    memory_free(c->own);
    free(c->rank);
    free(c->request);
    free(c);
}

static int low_of(const struct par_column *c, int place) {
    return place < c->owners ? par_piece_low(c->columns, c->owners, place) : c->columns;
}

static int count_of(const struct par_column *c, int place) { return low_of(c, place + 1) - low_of(c, place); }

void par_column_own(const struct par_column *c, int *low, int *count) {
    *low = low_of(c, c->place);
    *count = count_of(c, c->place);
}

/* Exchanges the blocks of packed (one for each owner of columns) with those of of_all (one for each rank whose values
 * they hold). back: the direction, 0 from packed to of_all. */
static void swap(struct par_column *c, double *packed, double *of_all, int back) {
    const int own = c->values * count_of(c, c->place);
    int requests = 0;
    for (int out = 0; out < 2; out++)
        for (int step = 1; step < c->parts; step++) {
            const int other = (c->place + step) % c->parts, rank = c->rank[other];
            double *theirs = packed + (size_t)c->values * (size_t)low_of(c, other);
            double *ours = of_all + (size_t)other * (size_t)own;
            const int their_count = c->values * count_of(c, other);
            const int sent = back ? own : their_count, received = back ? their_count : own;
            if ((out ? sent : received) == 0) continue;
            if (out) par_count_message(PAR_COUNT_TRANSPOSE, (size_t)sent * sizeof(double));
            if (out)
                MPI_Isend(back ? ours : theirs, sent, MPI_DOUBLE, rank, 100 + back, MPI_COMM_WORLD,
                          &c->request[requests++]);
            else
                MPI_Irecv(back ? theirs : ours, received, MPI_DOUBLE, rank, 100 + back, MPI_COMM_WORLD,
                          &c->request[requests++]);
        }
    double *local = packed + (size_t)c->values * (size_t)low_of(c, c->place),
           *about_me = of_all + (size_t)c->place * (size_t)own;
    memcpy(back ? local : about_me, back ? about_me : local, (size_t)own * sizeof *local);
    PAR_WAIT(MPI_Waitall(requests, c->request, MPI_STATUSES_IGNORE));
}

/* The block of an owner's columns in packed holds one value of all of them after another. */
static double *block(const struct par_column *c, int place, int value) {
    return c->packed + (size_t)c->values * (size_t)low_of(c, place) + (size_t)value * (size_t)count_of(c, place);
}

void par_column_share(struct par_column *c, const double *const *local, double *of_all) {
    clock_begin(CLOCK_HALO);
    for (int q = 0; q < c->parts; q++)
        for (int v = 0; v < c->values; v++)
            memcpy(block(c, q, v), local[v] + low_of(c, q), (size_t)count_of(c, q) * sizeof(double));
    swap(c, c->packed, of_all, 0);
    clock_end(CLOCK_HALO);
}

void par_column_return(struct par_column *c, const double *of_all, double *const *local) {
    clock_begin(CLOCK_HALO);
    swap(c, c->packed, (double *)(size_t)of_all, 1);
    for (int q = 0; q < c->parts; q++)
        for (int v = 0; v < c->values; v++)
            memcpy(local[v] + low_of(c, q), block(c, q, v), (size_t)count_of(c, q) * sizeof(double));
    clock_end(CLOCK_HALO);
}
