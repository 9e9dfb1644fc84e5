/* Transposes between x pencils and y pencils. */
#include "base/par_pencil.h"
#include "base/clock.h"
#include "base/ensure.h"
#include "base/memory.h"
#include "base/par.h"
#include "base/par_count.h"
#include "base/par_piece.h"
#include "base/par_wait.h"
#include "base/threads.h"

#include <mpi.h>
#include <stdlib.h>
#include <string.h>

struct par_pencil {
    struct par_pencil_input in;
    int place, first;        /* this rank's place along y; the rank of place 0 */
    int m_x, m_y, m_z;       /* of the y pencil; of the x pencil; of both */
    double *packed, *landed; /* the blocks of the x pencil, one for each rank; those of the y pencil */
    MPI_Request *request;
};

static int low_x(const struct par_pencil *p, int q) { return par_piece_low(p->in.n[0], p->in.ranks[1], q); }
static int piece_x(const struct par_pencil *p, int q) { return low_x(p, q + 1) - low_x(p, q); }
static int low_of(const struct par_pencil *p, int d, int q) {
    return p->in.cut[d] ? p->in.cut[d][q] : par_piece_low(p->in.n[d], p->in.ranks[d], q);
}
static int low_y(const struct par_pencil *p, int q) { return low_of(p, 1, q); }
static int piece_y(const struct par_pencil *p, int q) { return low_y(p, q + 1) - low_y(p, q); }

struct par_pencil *par_pencil_new(const struct par_pencil_input *in) {
    struct par_pencil *p = calloc(1, sizeof *p);
    ENSURE(in->ranks[0] == 1 && in->ranks[1] * in->ranks[2] == par_size(), "process grid %d x %d x %d on %d ranks",
           in->ranks[0], in->ranks[1], in->ranks[2], par_size());
    p->in = *in;
    p->place = par_rank() % in->ranks[1];
    p->first = par_rank() - p->place;
    p->m_x = piece_x(p, p->place);
    p->m_y = piece_y(p, p->place);
    const int c = par_rank() / in->ranks[1];
    p->m_z = low_of(p, 2, c + 1) - low_of(p, 2, c);
    if (par_pencil_same(p)) return p;
    const size_t planes = (size_t)(p->m_z + in->extra);
    p->packed = memory_new(MEMORY_FLUID, planes * (size_t)in->n[0] * (size_t)p->m_y, sizeof(double));
    p->landed = memory_new(MEMORY_FLUID, planes * (size_t)in->n[1] * (size_t)p->m_x, sizeof(double));
    p->request = calloc(2 * (size_t)in->ranks[1], sizeof *p->request);
    return p;
}

void par_pencil_free(struct par_pencil *p) {
    if (!p) return;
    MEMORY_FREE(p->packed, p->landed);
    free(p->request);
    free(p);
}

void par_pencil_shape(const struct par_pencil *p, int x_pencil[3], int y_pencil[3]) {
    memcpy(x_pencil, (int[3]){p->in.n[0], p->m_y, p->m_z}, 3 * sizeof(int));
    memcpy(y_pencil, (int[3]){p->m_x, p->in.n[1], p->m_z}, 3 * sizeof(int));
}

int par_pencil_low(const struct par_pencil *p) { return low_x(p, p->place); }

int par_pencil_same(const struct par_pencil *p) { return p->in.ranks[1] == 1; }

/* Planes from .. to-1 of a box width x height at the start of an array (strides row, plane) <-> a tight block. */
static void copy_box(double *block, double *array, size_t row, size_t plane, int width, int height, int from, int to,
                     int out) {
    const size_t bytes = (size_t)width * sizeof *block;
    block += (size_t)from * (size_t)height * (size_t)width;
    for (int k = from; k < to; k++)
        for (int j = 0; j < height; j++, block += width) {
            double *line = array + (size_t)k * plane + (size_t)j * row;
            if (out)
                memcpy(block, line, bytes);
            else
                memcpy(line, block, bytes);
        }
}

/* The boxes of all peers in an x pencil, or in a y pencil, to or from the blocks. */
struct copy {
    const struct par_pencil *p;
    int planes, is_x, out;
    double *array;
};

/* Peer q's box in an x pencil: its x for this rank's y; and its box in a y pencil: its y for this rank's x. */
static void copy_planes(const struct copy *c, int from, int to) {
    const struct par_pencil *p = c->p;
    const size_t n_x = (size_t)p->in.n[0], n_y = (size_t)p->in.n[1], m_x = (size_t)p->m_x, m_y = (size_t)p->m_y;
    const size_t planes = (size_t)c->planes;
    for (int q = 0; q < p->in.ranks[1]; q++) {
        const size_t x = (size_t)low_x(p, q), y = (size_t)low_y(p, q);
        if (c->is_x)
            copy_box(p->packed + x * m_y * planes, c->array + x, n_x, n_x * m_y, piece_x(p, q), p->m_y, from, to,
                     c->out);
        else
            copy_box(p->landed + y * m_x * planes, c->array + y * m_x, m_x, n_y * m_x, p->m_x, piece_y(p, q), from, to,
                     c->out);
    }
}

static void copy_part(int thread, void *data) {
    int from, to;
    threads_share(((const struct copy *)data)->planes, 1, thread, &from, &to);
    copy_planes(data, from, to);
}

/* Threads share the planes. */
static void copy(const struct par_pencil *p, int planes, int is_x, int out, double *array) {
    struct copy c = {p, planes, is_x, out, array};
    if (planes * (is_x ? p->in.n[0] * p->m_y : p->m_x * p->in.n[1]) < PAR_PENCIL_SHARED)
        copy_planes(&c, 0, planes);
    else
        threads_run(copy_part, &c);
}

/* Sends the blocks of packed to the other ranks' landed (back = 0), or those of landed to the others' packed. */
static void swap(struct par_pencil *p, int planes, int back) {
    const int parts = p->in.ranks[1];
    int requests = 0;
    for (int out = 0; out < 2; out++)
        for (int step = 0; step < parts; step++) {
            const int q = (p->place + step) % parts;
            const size_t x_at = (size_t)low_x(p, q) * (size_t)p->m_y * (size_t)planes,
                         y_at = (size_t)low_y(p, q) * (size_t)p->m_x * (size_t)planes;
            const int x_count = piece_x(p, q) * p->m_y * planes, y_count = piece_y(p, q) * p->m_x * planes;
            if (q == p->place && out)
                memcpy(back ? p->packed + x_at : p->landed + y_at, back ? p->landed + y_at : p->packed + x_at,
                       (size_t)x_count * sizeof(double));
            if (q == p->place) continue;
            double *block = (out != back) ? p->packed + x_at : p->landed + y_at;
            const int count = (out != back) ? x_count : y_count;
            if (out) par_count_message(PAR_COUNT_TRANSPOSE, (size_t)count * sizeof(double));
            if (out)
                MPI_Isend(block, count, MPI_DOUBLE, p->first + q, 90 + back, MPI_COMM_WORLD, &p->request[requests++]);
            else
                MPI_Irecv(block, count, MPI_DOUBLE, p->first + q, 90 + back, MPI_COMM_WORLD, &p->request[requests++]);
        }
    PAR_WAIT(MPI_Waitall(requests, p->request, MPI_STATUSES_IGNORE));
}

void par_pencil_forward(struct par_pencil *p, int planes, const double *x_pencil, double *y_pencil) {
    clock_begin(CLOCK_HALO);
    copy(p, planes, 1, 1, (double *)(size_t)x_pencil);
    swap(p, planes, 0);
    copy(p, planes, 0, 0, y_pencil);
    clock_end(CLOCK_HALO);
}

void par_pencil_backward(struct par_pencil *p, int planes, const double *y_pencil, double *x_pencil) {
    clock_begin(CLOCK_HALO);
    copy(p, planes, 0, 1, (double *)(size_t)y_pencil);
    swap(p, planes, 1);
    copy(p, planes, 1, 0, x_pencil);
    clock_end(CLOCK_HALO);
}
