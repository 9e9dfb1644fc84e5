/* Exchange of ghost layers on the staggered grid: filling them, and adding them back to their owners. */
#include "base/par_halo.h"
#include "base/clock.h"
#include "base/ensure.h"
#include "base/memory.h"
#include "base/par.h"
#include "base/par_count.h"
#include "base/par_wait.h"

#include <mpi.h>
#include <stdlib.h>
#include <string.h>

struct par_halo {
    struct par_halo_input in;
    int rank;
    int neighbour[3][2]; /* [direction][low, high] the neighbour's rank: this rank where it is its own neighbour, -1
                          * beyond a side */
    double *buffer;      /* [4][capacity]; NULL: borrowed, or not needed yet */
    size_t capacity;
};

/* Cells low .. high-1 of the three directions, ghosts counted as -1, -2, ... and m, m+1, ... */
struct box {
    int low[3], high[3];
};

static size_t box_cells(const struct box *b) {
    return (size_t)(b->high[0] - b->low[0]) * (size_t)(b->high[1] - b->low[1]) * (size_t)(b->high[2] - b->low[2]);
}

static size_t at(const struct par_halo *h, int i, int j, int k) {
    return (size_t)(h->in.first + k * h->in.plane + j * h->in.row + i);
}

struct par_halo *par_halo_new(const struct par_halo_input *in) {
    struct par_halo *h = calloc(1, sizeof *h);
    const int rank = par_rank(), size = par_size();
    h->in = *in;
    h->rank = rank;
    ENSURE(in->ranks[0] == 1 && in->ranks[1] * in->ranks[2] == size, "process grid %d x %d x %d on %d ranks",
           in->ranks[0], in->ranks[1], in->ranks[2], size);
    const int c[3] = {0, rank % in->ranks[1], rank / in->ranks[1]};
    const int stride[3] = {0, 1, in->ranks[1]};
    for (int d = 0; d < 3; d++) {
        const int n = in->ranks[d];
        for (int side = 0; side < 2; side++) {
            const int to = c[d] + (side ? 1 : -1);
            const int wrapped = (to + n) % n;
            const int outside = to < 0 || to >= n;
            h->neighbour[d][side] = outside && !in->periodic[d] ? -1 : rank + (wrapped - c[d]) * stride[d];
            ENSURE(h->neighbour[d][side] < 0 || in->m[d] >= in->halo, "%d cells, %d layers", in->m[d], in->halo);
        }
    }
    return h;
}

void par_halo_free(struct par_halo *h) {
    if (!h) return;
    memory_free(h->buffer);
    free(h);
}

int par_halo_at_side(const struct par_halo *h, int direction, int side) { return h->neighbour[direction][side] < 0; }

/* The box of a direction's layers at a side: its ghosts, or the owned cells that the neighbour sees as its ghosts. */
static struct box layers_at(const struct par_halo *h, int direction, int side, const struct par_halo_part *part,
                            int ghosts) {
    const int layers = part->layers, m = h->in.m[direction];
    struct box b;
    memcpy(b.low, part->low, sizeof b.low);
    memcpy(b.high, part->high, sizeof b.high);
    b.low[direction] = side ? (ghosts ? m : m - layers) : (ghosts ? -layers : 0);
    b.high[direction] = b.low[direction] + layers;
    return b;
}

static void pack(const struct par_halo *h, const struct box *b, int fields, double *const *field, double *to) {
    const size_t width = (size_t)(b->high[0] - b->low[0]);
    for (int f = 0; f < fields; f++)
        for (int k = b->low[2]; k < b->high[2]; k++)
            for (int j = b->low[1]; j < b->high[1]; j++, to += width)
                memcpy(to, field[f] + at(h, b->low[0], j, k), width * sizeof *to);
}

static void unpack(const struct par_halo *h, const struct box *b, int fields, double *const *field,
                   const double *from) {
    const size_t width = (size_t)(b->high[0] - b->low[0]);
    for (int f = 0; f < fields; f++)
        for (int k = b->low[2]; k < b->high[2]; k++)
            for (int j = b->low[1]; j < b->high[1]; j++, from += width)
                memcpy(field[f] + at(h, b->low[0], j, k), from, width * sizeof *from);
}

static void unpack_adding(const struct par_halo *h, const struct box *b, int fields, double *const *field,
                          const double *from) {
    const int width = b->high[0] - b->low[0];
    for (int f = 0; f < fields; f++)
        for (int k = b->low[2]; k < b->high[2]; k++)
            for (int j = b->low[1]; j < b->high[1]; j++, from += width) {
                double *to = field[f] + at(h, b->low[0], j, k);
                for (int i = 0; i < width; i++) to[i] += from[i];
            }
}

static void clear(const struct par_halo *h, const struct box *b, int fields, double *const *field) {
    const size_t width = (size_t)(b->high[0] - b->low[0]);
    for (int f = 0; f < fields; f++)
        for (int k = b->low[2]; k < b->high[2]; k++)
            for (int j = b->low[1]; j < b->high[1]; j++)
                memset(field[f] + at(h, b->low[0], j, k), 0, width * sizeof(double));
}

/* Buffers of `doubles` each: sent low and high, received low and high. No exchange outlasts its call, so halos can
 * share them. */
static void reserve(struct par_halo *h, size_t doubles, double *sent[2], double *received[2]) {
    if (h->in.lender) {
        reserve(h->in.lender, doubles, sent, received);
        return;
    }
    if (doubles > h->capacity) {
        memory_free(h->buffer);
        h->capacity = doubles;
        h->buffer = memory_new(MEMORY_FLUID, 4 * doubles, sizeof(double));
    }
    for (int side = 0; side < 2; side++) {
        sent[side] = h->buffer + (size_t)side * h->capacity;
        received[side] = h->buffer + (size_t)(2 + side) * h->capacity;
    }
}

/* Sends sent[side] to the neighbour at that side and receives received[side] from it, `count` doubles each, at the
 * sides that the flags select. */
static void swap(struct par_halo *h, int direction, double *const sent[2], double *const received[2],
                 const int sends[2], const int receives[2], size_t count) {
    MPI_Request request[4];
    int requests = 0;
    for (int side = 0; side < 2; side++)
        if (receives[side]) /* the values from the low neighbour are those that it sent to its high side */
            MPI_Irecv(received[side], (int)count, MPI_DOUBLE, h->neighbour[direction][side], 80 + !side, MPI_COMM_WORLD,
                      &request[requests++]);
    for (int side = 0; side < 2; side++)
        if (sends[side]) {
            MPI_Isend(sent[side], (int)count, MPI_DOUBLE, h->neighbour[direction][side], 80 + side, MPI_COMM_WORLD,
                      &request[requests++]);
            par_count_message(PAR_COUNT_HALO, count * sizeof(double));
        }
    PAR_WAIT(MPI_Waitall(requests, request, MPI_STATUSES_IGNORE));
}

/* A periodic direction with one rank: the cells at each side are copied to the ghosts at the other side. */
static void wrap(const struct par_halo *h, int direction, int fields, double *const *field,
                 const struct par_halo_part *part) {
    for (int side = 0; side < 2; side++) {
        if (!part->wanted[direction][side]) continue;
        const struct box to = layers_at(h, direction, side, part, 1);
        const ptrdiff_t stride[3] = {1, h->in.row, h->in.plane};
        const ptrdiff_t away = (side ? -1 : 1) * h->in.m[direction] * stride[direction];
        const size_t width = (size_t)(to.high[0] - to.low[0]);
        for (int f = 0; f < fields; f++)
            for (int k = to.low[2]; k < to.high[2]; k++)
                for (int j = to.low[1]; j < to.high[1]; j++) {
                    double *ghost = field[f] + at(h, to.low[0], j, k);
                    for (size_t i = 0; i < width && direction == 0; i++) ghost[i] = ghost[away + (ptrdiff_t)i];
                    if (direction != 0) memcpy(ghost, ghost + away, width * sizeof *ghost);
                }
    }
}

/* Copies owned layers to the neighbours' ghosts. */
static void fill(struct par_halo *h, int direction, int fields, double *const *field,
                 const struct par_halo_part *part) {
    int sends[2], receives[2];
    if (h->neighbour[direction][0] == h->rank) {
        wrap(h, direction, fields, field, part);
        return;
    }
    for (int side = 0; side < 2; side++) {
        sends[side] = part->asked[direction][side] && h->neighbour[direction][side] >= 0;
        receives[side] = part->wanted[direction][side] && h->neighbour[direction][side] >= 0;
    }
    if (h->neighbour[direction][0] < 0 && h->neighbour[direction][1] < 0) return;
    const struct box any = layers_at(h, direction, 0, part, 1);
    const size_t count = box_cells(&any) * (size_t)fields;
    double *sent[2], *received[2];
    reserve(h, count, sent, received);
    for (int side = 0; side < 2; side++) {
        const struct box from = layers_at(h, direction, side, part, 0);
        if (sends[side]) pack(h, &from, fields, field, sent[side]);
    }
    swap(h, direction, sent, received, sends, receives, count);
    for (int side = 0; side < 2; side++) {
        const struct box to = layers_at(h, direction, side, part, 1);
        if (receives[side]) unpack(h, &to, fields, field, received[side]);
    }
}

/* Adds ghost layers to the ranks that own them. */
static void add(struct par_halo *h, int direction, int fields, double *const *field, const struct par_halo_part *part) {
    const struct box any = layers_at(h, direction, 0, part, 1);
    const size_t count = box_cells(&any) * (size_t)fields;
    double *sent[2], *received[2];
    reserve(h, count, sent, received);
    int there[2];
    for (int side = 0; side < 2; side++) {
        const struct box from = layers_at(h, direction, side, part, 1);
        there[side] = h->neighbour[direction][side] >= 0;
        if (there[side]) pack(h, &from, fields, field, sent[side]);
        clear(h, &from, fields, field);
    }
    if (h->neighbour[direction][0] == h->rank) {
        received[0] = sent[1];
        received[1] = sent[0];
    } else {
        swap(h, direction, sent, received, there, there, count);
    }
    for (int side = 0; side < 2; side++) {
        const struct box to = layers_at(h, direction, side, part, 0);
        if (there[side]) unpack_adding(h, &to, fields, field, received[side]);
    }
}

struct par_halo_part par_halo_whole(const struct par_halo *h, int layers) {
    struct par_halo_part part = {.layers = layers};
    for (int d = 0; d < 3; d++) {
        part.low[d] = -layers;
        part.high[d] = h->in.m[d] + layers;
        for (int side = 0; side < 2; side++) part.wanted[d][side] = part.asked[d][side] = 1;
    }
    return part;
}

void par_halo_fill_part(struct par_halo *h, int direction, int fields, double *const *field,
                        const struct par_halo_part *part) {
    if (part->layers < 1) return;
    ENSURE(part->layers <= h->in.halo, "%d layers of %d", part->layers, h->in.halo);
    for (int d = 0; d < 3; d++)
        if (d != direction && part->low[d] >= part->high[d]) return;
    clock_begin(CLOCK_HALO);
    fill(h, direction, fields, field, part);
    clock_end(CLOCK_HALO);
}

void par_halo_fill(struct par_halo *h, int fields, double *const *field, int layers) {
    const struct par_halo_part whole = par_halo_whole(h, layers);
    for (int d = 0; d < 3; d++) par_halo_fill_part(h, d, fields, field, &whole);
}

void par_halo_add(struct par_halo *h, int fields, double *const *field, int layers) {
    if (layers < 1) return;
    ENSURE(layers <= h->in.halo, "%d layers of %d", layers, h->in.halo);
    const struct par_halo_part whole = par_halo_whole(h, layers);
    clock_begin(CLOCK_HALO);
    for (int d = 2; d >= 0; d--) add(h, d, fields, field, &whole);
    clock_end(CLOCK_HALO);
}
