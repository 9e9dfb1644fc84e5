/* One copy of an array for the ranks of a node: a file in memory without a name, which they map. MPI's own shared
 * windows are not used: where the node has no room for one, Open MPI 4.1 reports it on one rank and waits forever on
 * others. */
#include "base/par_shared.h"
#include "base/par.h"
#include "base/par_count.h"
#include "base/par_wait.h"

#include <mpi.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

enum { PIECE = 1 << 23 }; /* bytes that are sent at once */

/* Ranks that have one copy, and the first ones of all copies (MPI_COMM_NULL on others). */
struct groups {
    MPI_Comm copy, first;
    int rank, sharers, copies;
};

static struct groups node; /* while is_known */
static int is_known, limit;

/* Where the first rank of a node keeps the memory. */
struct origin {
    long process;
    int file, fault;
    dev_t device;
    ino_t number;
};

static void forget(void) {
    if (!is_known) return;
    MPI_Comm_free(&node.copy);
    if (node.first != MPI_COMM_NULL) MPI_Comm_free(&node.first);
    is_known = 0;
}

/* The nodes, or parts of them. */
static void find_nodes(void) {
    if (is_known) return;
    MPI_Comm whole;
    int rank;
    MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, par_rank(), MPI_INFO_NULL, &whole);
    MPI_Comm_rank(whole, &rank);
    MPI_Comm_split(whole, limit > 0 ? rank / limit : 0, rank, &node.copy);
    MPI_Comm_free(&whole);
    MPI_Comm_rank(node.copy, &node.rank);
    MPI_Comm_size(node.copy, &node.sharers);
    MPI_Comm_split(MPI_COMM_WORLD, node.rank == 0 ? 0 : MPI_UNDEFINED, par_rank(), &node.first);
    if (node.rank == 0) MPI_Comm_size(node.first, &node.copies);
    PAR_WAIT(MPI_Bcast(&node.copies, 1, MPI_INT, 0, MPI_COMM_WORLD));
    is_known = 1;
}

int par_shared_ranks(void) {
    if (par_size() > 1) find_nodes();
    return par_size() > 1 ? node.sharers : 1;
}

void par_shared_limit(int ranks) {
    forget();
    limit = ranks;
}

/* Of those that hold a copy. */
static MPI_Comm first_of(const struct par_shared *s) { return s->why[0] ? MPI_COMM_WORLD : node.first; }

static void give_reason(char why[128], const char *what, int fault) {
    snprintf(why, 128, "%s: %s", what, strerror(fault));
}

static void *map(int file, size_t bytes, char why[128]) {
    void *data = mmap(NULL, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    if (data != MAP_FAILED) return data;
    give_reason(why, "mmap", errno);
    return NULL;
}

/* The node's first rank: a file in memory, all of whose bytes are reserved, so that writing cannot fail later. */
static void *begin(size_t bytes, struct origin *origin, char why[128]) {
    struct rlimit most;
    struct stat is;
    int fault;
    *origin = (struct origin){.process = getpid(), .file = memfd_create("frana", MFD_CLOEXEC)};
    if (origin->file < 0) return give_reason(why, "memfd_create", errno), NULL;
    if (getrlimit(RLIMIT_FSIZE, &most) == 0 && most.rlim_cur < bytes) /* a signal would end the program */
        return give_reason(why, "ulimit -f", EFBIG), NULL;
    do fault = posix_fallocate(origin->file, 0, (off_t)bytes);
    while (fault == EINTR);
    if (fault) return give_reason(why, "posix_fallocate", fault), NULL;
    if (fstat(origin->file, &is)) return give_reason(why, "fstat", errno), NULL;
    origin->device = is.st_dev;
    origin->number = is.st_ino;
    return map(origin->file, bytes, why);
}

/* The others find it by the first one's process: where ranks of a node do not see each other's, that is another file,
 * or none. */
static void *join(size_t bytes, const struct origin *origin, char why[128]) {
    char path[64];
    struct stat is;
    snprintf(path, sizeof path, "/proc/%ld/fd/%d", origin->process, origin->file);
    if (stat(path, &is)) return give_reason(why, path, errno), NULL;
    if (is.st_dev != origin->device || is.st_ino != origin->number) return give_reason(why, path, ESRCH), NULL;
    const int file = open(path, O_RDWR | O_CLOEXEC);
    if (file < 0) return give_reason(why, path, errno), NULL;
    void *data = map(file, bytes, why);
    close(file);
    return data;
}

/* Agrees on the first sentence of any rank. */
static void agree(char why[128]) {
    int first = why[0] ? par_rank() : par_size();
    PAR_WAIT(MPI_Allreduce(MPI_IN_PLACE, &first, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD));
    if (first < par_size()) PAR_WAIT(MPI_Bcast(why, 128, MPI_CHAR, first, MPI_COMM_WORLD));
}

/* Maps the node's copy on all its ranks; leaves data NULL and says why if any rank of all cannot. */
static void share(struct par_shared *s) {
    struct origin origin = {.file = -1};
    if (node.rank == 0) s->data = begin(s->bytes, &origin, s->why);
    origin.fault = s->why[0] != '\0';
    PAR_WAIT(MPI_Bcast(&origin, (int)sizeof origin, MPI_BYTE, 0, node.copy));
    if (node.rank > 0 && !origin.fault) s->data = join(s->bytes, &origin, s->why);
    agree(s->why);
    if (node.rank == 0 && origin.file >= 0) close(origin.file);
    s->is_mapped = s->why[0] == '\0';
    if (s->is_mapped || !s->data) return;
    munmap(s->data, s->bytes);
    s->data = NULL;
}

struct par_shared *par_shared_new(enum memory_part part, size_t bytes) {
    struct par_shared *s = memory_new(part, 1, sizeof *s);
    *s = (struct par_shared){.part = part, .bytes = (bytes + 7) / 8 * 8, .sharers = 1, .copies = 1, .is_writer = 1};
    if (s->bytes == 0) s->bytes = 8;
    if (par_size() > 1) {
        find_nodes();
        /* nobody asks for memory in a file if no two ranks are together */
        if (node.copies < par_size()) share(s);
        s->sharers = s->is_mapped ? node.sharers : 1;
        s->copies = s->is_mapped ? node.copies : par_size();
        s->is_writer = !s->is_mapped || node.rank == 0;
    }
    if (!s->is_mapped) s->data = memory_new(part, s->bytes, 1);
    if (s->is_mapped && s->is_writer) memory_count(part, (long)s->bytes);
    return s;
}

void par_shared_free(struct par_shared *s) {
    if (!s) return;
    if (!s->is_mapped)
        memory_free(s->data);
    else
        munmap(s->data, s->bytes);
    if (s->is_mapped && s->is_writer) memory_count(s->part, -(long)s->bytes);
    memory_free(s);
}

void par_shared_fence(const struct par_shared *s) {
    if (s->sharers == 1) return;
    __atomic_thread_fence(__ATOMIC_SEQ_CST);
    PAR_WAIT(MPI_Barrier(node.copy));
    __atomic_thread_fence(__ATOMIC_SEQ_CST);
}

/* Bytes of the piece that begins here; 0: none, or nothing is sent. */
static size_t piece(const struct par_shared *s, size_t at) {
    if (s->copies == 1 || !s->is_writer || at >= s->bytes) return 0;
    const size_t n = s->bytes - at < PIECE ? s->bytes - at : PIECE;
    par_count_collective(PAR_COUNT_REDUCTION, n);
    return n;
}

void par_shared_unite(const struct par_shared *s) {
    char *data = s->data;
    par_shared_fence(s);
    for (size_t at = 0, n; (n = piece(s, at)) > 0; at += n)
        PAR_WAIT(MPI_Allreduce(MPI_IN_PLACE, data + at, (int)(n / 8), MPI_UINT64_T, MPI_BOR, first_of(s)));
    par_shared_fence(s);
}

void par_shared_spread(const struct par_shared *s) {
    char *data = s->data;
    par_shared_fence(s);
    for (size_t at = 0, n; (n = piece(s, at)) > 0; at += n)
        PAR_WAIT(MPI_Bcast(data + at, (int)n, MPI_BYTE, 0, first_of(s)));
    par_shared_fence(s);
}
