/* MPI basics: start, ranks, reductions, broadcasts, gathers, wall clock. */
#include "base/par.h"
#include "base/alone.h"
#include "base/par_count.h"
#include "base/par_wait.h"

#include <mpi.h>
#include <limits.h>
#include <stdlib.h>
#include <time.h>

static int on(void) {
    int begun = 0, ended = 0;
    MPI_Initialized(&begun);
    MPI_Finalized(&ended);
    return begun && !ended;
}

void par_begin(int *argc, char ***argv) {
    int begun = 0;
    MPI_Initialized(&begun);
    if (begun) return;
    int given;
    alone_begin();
    MPI_Init_thread(argc, argv, MPI_THREAD_FUNNELED, &given);
    alone_end();
}

void par_end(void) {
    if (on()) MPI_Finalize();
}

/* mpiexec of Open MPI 4 ends the other ranks when one exits without MPI_Finalize, and returns its code. After MPI_Abort
 * it does the same, but at times it crashes or waits for ever in PMIx_server_finalize (seen with PMIx 4.2.2). Other
 * launchers may leave the other ranks waiting unless MPI_Abort is called. */
void par_abort(int code) {
    const int told_by_exit = getenv("OMPI_MCA_orte_hnp_uri") != NULL;
    if (on() && !told_by_exit) MPI_Abort(MPI_COMM_WORLD, code);
    _Exit(code);
}

int par_rank(void) {
    int rank = 0;
    if (on()) MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    return rank;
}

int par_size(void) {
    int size = 1;
    if (on()) MPI_Comm_size(MPI_COMM_WORLD, &size);
    return size;
}

/* Counts one call that all ranks take part in. */
static void note(size_t bytes) {
    if (par_size() > 1) par_count_collective(PAR_COUNT_REDUCTION, bytes);
}

static void reduce(void *value, int n, MPI_Datatype type, MPI_Op op) {
    if (!on()) return;
    note((size_t)n * 8); /* doubles and longs */
    PAR_WAIT(MPI_Allreduce(MPI_IN_PLACE, value, n, type, op, MPI_COMM_WORLD));
}

void par_sum_array(double *value, int n) { reduce(value, n, MPI_DOUBLE, MPI_SUM); }
void par_min_array(double *value, int n) { reduce(value, n, MPI_DOUBLE, MPI_MIN); }
void par_max_array(double *value, int n) { reduce(value, n, MPI_DOUBLE, MPI_MAX); }
void par_sum_long_array(long *value, int n) { reduce(value, n, MPI_LONG, MPI_SUM); }

double par_sum(double value) {
    par_sum_array(&value, 1);
    return value;
}

double par_min(double value) {
    par_min_array(&value, 1);
    return value;
}

double par_max(double value) {
    par_max_array(&value, 1);
    return value;
}

long par_sum_long(long value) {
    par_sum_long_array(&value, 1);
    return value;
}

long par_sum_before(long value) {
    long before = 0;
    note(sizeof value);
    if (on()) PAR_WAIT(MPI_Exscan(&value, &before, 1, MPI_LONG, MPI_SUM, MPI_COMM_WORLD));
    return par_rank() == 0 ? 0 : before;
}

void par_bcast(void *data, size_t bytes, int root) {
    char *at = data;
    note(bytes);
    while (on() && bytes > 0) {
        const int piece = bytes > INT_MAX ? INT_MAX : (int)bytes;
        PAR_WAIT(MPI_Bcast(at, piece, MPI_BYTE, root, MPI_COMM_WORLD));
        at += piece;
        bytes -= (size_t)piece;
    }
}

void par_gather(const void *local, size_t bytes, void *everyone) {
    note(bytes);
    PAR_WAIT(MPI_Gather(local, (int)bytes, MPI_BYTE, everyone, (int)bytes, MPI_BYTE, 0, MPI_COMM_WORLD));
}

void par_all_gather(const void *local, size_t bytes, void *everyone) {
    note(bytes);
    PAR_WAIT(MPI_Allgather(local, (int)bytes, MPI_BYTE, everyone, (int)bytes, MPI_BYTE, MPI_COMM_WORLD));
}

void *par_all_gather_any(const void *local, size_t bytes, size_t *total) {
    const int size = par_size();
    int *count = malloc(2 * (size_t)size * sizeof *count), *at = count + size, my_count = (int)bytes;
    note(sizeof my_count);
    note(bytes);
    PAR_WAIT(MPI_Allgather(&my_count, 1, MPI_INT, count, 1, MPI_INT, MPI_COMM_WORLD));
    *total = 0;
    for (int r = 0; r < size; r++) {
        at[r] = (int)*total;
        *total += (size_t)count[r];
    }
    void *everyone = malloc(*total + 1);
    PAR_WAIT(MPI_Allgatherv(local, my_count, MPI_BYTE, everyone, count, at, MPI_BYTE, MPI_COMM_WORLD));
    free(count);
    return everyone;
}

void par_barrier(void) {
    if (on()) PAR_WAIT(MPI_Barrier(MPI_COMM_WORLD));
}

double par_seconds(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}
