/* Transposes between x pencils and y pencils. */
#include "base/par_pencil.h"
#include "base/clock.h"
#include "base/ensure.h"
#include "base/memory.h"
#include "base/par.h"
#include "base/par_count.h"
#include "base/par_piece.h"
#include "base/par_wait.h"

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
    memory_free(p->packed);
    memory_free(p->landed);
    free(p->request);
    free(p);
}

void par_pencil_shape(const struct par_pencil *p, int x_pencil[3], int y_pencil[3]) {
    memcpy(x_pencil, (int[3]){p->in.n[0], p->m_y, p->m_z}, 3 * sizeof(int));
    memcpy(y_pencil, (int[3]){p->m_x, p->in.n[1], p->m_z}, 3 * sizeof(int));
}

int par_pencil_low(const struct par_pencil *p) { return low_x(p, p->place); }

int par_pencil_same(const struct par_pencil *p) { return p->in.ranks[1] == 1; }

/* A box of width x height x planes at the start of an array (strides row, plane) <-> a tight block. */
static void copy_box(double *block, double *array, size_t row, size_t plane, int width, int height, int planes,
                     int out) {
    const size_t bytes = (size_t)width * sizeof *block;
    for (int k = 0; k < planes; k++)
        for (int j = 0; j < height; j++, block += width) {
            double *line = array + (size_t)k * plane + (size_t)j * row;
            if (out)
                memcpy(block, line, bytes);
            else
                memcpy(line, block, bytes);
        }
}

/* Peer q's box in an x pencil: its x for this rank's y; and its box in a y pencil: its y for this rank's x. */
static void copy_x_box(const struct par_pencil *p, int q, int planes, double *array, int out) {
    const int n = p->in.n[0];
    copy_box(p->packed + (size_t)low_x(p, q) * (size_t)p->m_y * (size_t)planes, array + low_x(p, q), (size_t)n,
             (size_t)n * (size_t)p->m_y, piece_x(p, q), p->m_y, planes, out);
}

static void copy_y_box(const struct par_pencil *p, int q, int planes, double *array, int out) {
    const int n = p->in.n[1];
    copy_box(p->landed + (size_t)low_y(p, q) * (size_t)p->m_x * (size_t)planes,
             array + (size_t)low_y(p, q) * (size_t)p->m_x, (size_t)p->m_x, (size_t)n * (size_t)p->m_x, p->m_x,
             piece_y(p, q), planes, out);
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
    for (int q = 0; q < p->in.ranks[1]; q++) copy_x_box(p, q, planes, (double *)(size_t)x_pencil, 1);
    swap(p, planes, 0);
    for (int q = 0; q < p->in.ranks[1]; q++) copy_y_box(p, q, planes, y_pencil, 0);
    clock_end(CLOCK_HALO);
}

void par_pencil_backward(struct par_pencil *p, int planes, const double *y_pencil, double *x_pencil) {
    clock_begin(CLOCK_HALO);
    for (int q = 0; q < p->in.ranks[1]; q++) copy_y_box(p, q, planes, (double *)(size_t)y_pencil, 1);
    swap(p, planes, 1);
    for (int q = 0; q < p->in.ranks[1]; q++) copy_x_box(p, q, planes, x_pencil, 0);
    clock_end(CLOCK_HALO);
}
