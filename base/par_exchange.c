/* Exchange of items between two distributions over ranks. */
#include "base/par_exchange.h"
#include "base/ensure.h"
#include "base/par.h"
#include "base/par_count.h"
#include "base/par_exchange_private.h"
#include "base/par_wait.h"

#include <mpi.h>
#include <sched.h>
#include <stdlib.h>
#include <string.h>

char *par_exchange_reserve(struct par_exchange *x, size_t bytes) {
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

/* Fills from[]: how many items each rank sends here. Only the ranks that get items are told (algorithm NBX of Hoefler,
 * Siebert and Lumsdaine 2010). A synchronous send ends once it is received. So a rank without open sends enters a
 * barrier, and when all are in it, nothing is under way; until then it receives. The tag alternates, because a rank
 * that has left the barrier may begin the next round while another one still receives. No rank can be two rounds
 * ahead. */
static void exchange_counts(struct par_exchange *x) {
    static int round;
    const int size = par_size(), rank = par_rank(), tag = 74 + round;
    int open = 0, sent = 0, is_over = 0;
    MPI_Request barrier;
    memset(x->from, 0, (size_t)size * sizeof *x->from);
    x->from[rank] = x->to[rank];
    for (int r = 0; r < size; r++)
        if (x->to[r] > 0 && r != rank) {
            MPI_Issend(&x->to[r], 1, MPI_INT, r, tag, MPI_COMM_WORLD, &x->request[open++]);
            par_count_message(x->kind, sizeof(int));
        }
    while (!is_over) {
        MPI_Status status;
        int has_arrived;
        MPI_Iprobe(MPI_ANY_SOURCE, tag, MPI_COMM_WORLD, &has_arrived, &status);
        if (has_arrived) {
            const int r = status.MPI_SOURCE;
            MPI_Recv(&x->from[r], 1, MPI_INT, r, tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
        } else if (sent) {
            MPI_Test(&barrier, &is_over, MPI_STATUS_IGNORE);
        } else {
            MPI_Testall(open, x->request, &sent, MPI_STATUSES_IGNORE);
            if (sent) MPI_Ibarrier(MPI_COMM_WORLD, &barrier);
        }
        if (!has_arrived && !is_over) sched_yield(); /* several ranks may share a core */
    }
    par_count_collective(x->kind, 0);
    round = !round;
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
        PAR_WAIT(exchange_counts(x));
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

int par_exchange_begin(struct par_exchange *x, const char *send, const int *to, const int *to_at, char *recv,
                       const int *from, const int *from_at, size_t bytes) {
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

/* Number of items from the first on that follow one another. */
static int run(const int *order, int n) {
    int k = 1;
    while (k < n && order[k] == order[0] + k) k++;
    return k;
}

/* Items of up to eight numbers are copied number by number: a call of memcpy costs more. Larger ones and bytes are
 * copied by runs. Vectors have their own length in the code, so that there is no loop over their numbers. */
enum { NUMBER = sizeof(double), VECTOR = 3 * NUMBER, SMALL = 8 * NUMBER };

static int is_small(size_t bytes) { return bytes <= SMALL && bytes % NUMBER == 0; }

static inline void copy(char *restrict to, const char *restrict from, size_t bytes) {
    for (size_t k = 0; k < bytes; k += NUMBER) memcpy(to + k, from + k, NUMBER);
}

static inline void pack_small(char *packed, const char *items, const int *order, int n, size_t bytes) {
    for (int k = 0; k < n; k++) copy(packed + (size_t)k * bytes, items + (size_t)order[k] * bytes, bytes);
}

static inline void unpack_small(const char *packed, char *items, const int *order, int n, size_t bytes) {
    for (int k = 0; k < n; k++) copy(items + (size_t)order[k] * bytes, packed + (size_t)k * bytes, bytes);
}

/* packed [n] <- items of this order, and back */
static void pack(char *packed, const char *items, const int *order, int n, size_t bytes) {
    if (bytes == VECTOR) {
        pack_small(packed, items, order, n, VECTOR);
    } else if (is_small(bytes)) {
        pack_small(packed, items, order, n, bytes);
    } else {
        for (int k = 0, m; k < n; k += m) {
            m = run(order + k, n - k);
            memcpy(packed + (size_t)k * bytes, items + (size_t)order[k] * bytes, (size_t)m * bytes);
        }
    }
}

static void unpack(const char *packed, char *items, const int *order, int n, size_t bytes) {
    if (bytes == VECTOR) {
        unpack_small(packed, items, order, n, VECTOR);
    } else if (is_small(bytes)) {
        unpack_small(packed, items, order, n, bytes);
    } else {
        for (int k = 0, m; k < n; k += m) {
            m = run(order + k, n - k);
            memcpy(items + (size_t)order[k] * bytes, packed + (size_t)k * bytes, (size_t)m * bytes);
        }
    }
}

/* Packs and sends what goes to other ranks first, then copies this rank's own items while the messages travel. */
void par_exchange_forward(struct par_exchange *x, const void *local, void *served, size_t bytes) {
    const int size = par_size(), rank = par_rank();
    if (x->in_order) {
        if (x->sent > 0) memcpy(served, local, (size_t)x->sent * bytes);
        return;
    }
    char *packed = size > 1 ? par_exchange_reserve(x, (size_t)x->sent * bytes + 1) : NULL;
    for (int r = 0; r < size; r++)
        if (r != rank) pack(packed + (size_t)x->to_at[r] * bytes, local, x->order + x->to_at[r], x->to[r], bytes);
    const int requests = par_exchange_begin(x, packed, x->to, x->to_at, served, x->from, x->from_at, bytes);
    pack((char *)served + (size_t)x->from_at[rank] * bytes, local, x->order + x->to_at[rank], x->to[rank], bytes);
    PAR_WAIT(MPI_Waitall(requests, x->request, MPI_STATUSES_IGNORE));
}

void par_exchange_backward(struct par_exchange *x, const void *served, void *local, size_t bytes) {
    const int size = par_size(), rank = par_rank();
    if (x->in_order) {
        if (x->sent > 0) memcpy(local, served, (size_t)x->sent * bytes);
        return;
    }
    char *packed = size > 1 ? par_exchange_reserve(x, (size_t)x->sent * bytes + 1) : NULL;
    const int requests = par_exchange_begin(x, served, x->from, x->from_at, packed, x->to, x->to_at, bytes);
    unpack((const char *)served + (size_t)x->from_at[rank] * bytes, local, x->order + x->to_at[rank], x->to[rank],
           bytes);
    PAR_WAIT(MPI_Waitall(requests, x->request, MPI_STATUSES_IGNORE));
    for (int r = 0; r < size; r++)
        if (r != rank) unpack(packed + (size_t)x->to_at[r] * bytes, local, x->order + x->to_at[r], x->to[r], bytes);
}
