#include "base/par_pencil.h"
#include "base/error.h"
#include "base/memory.h"
#include "base/par.h"

#include <mpi.h>
#include <stdlib.h>
#include <string.h>

/* What one peer and this rank swap in one transpose: a box of the near pencil's array against a box of the far one's. */
struct peer {
    int rank;
    size_t near_at, far_at;   /* offset of the box */
    int width, height, depth; /* near box: depth planes of height rows of width values */
    int far_width, far_height, far_depth;
};

struct transpose {
    int peers;
    struct peer *peer;
    size_t near_row, near_plane, far_row, far_plane; /* strides of the arrays */
    MPI_Request *request;
};

struct par_pencil {
    struct par_pencil_input in;
    int c[3];             /* coordinates on the process grid */
    int x[3], y[3], z[3]; /* extents of the pencils */
    int x_low, y_low;     /* of the z pencil */
    struct transpose step[2];
    double *sent, *received;
};

static int piece(int n, int pieces, int c) {
    return par_piece_low(n, pieces, c + 1) - par_piece_low(n, pieces, c);
}

/* x to y pencil, among the ranks of one c_z: peer q holds y piece q before and x piece q after. */
static void plan_xy(struct par_pencil *p, struct transpose *t) {
    const int *n = p->in.n, parts = p->in.ranks[1];
    t->near_row = (size_t)p->x[0];
    t->near_plane = t->near_row * (size_t)p->x[1];
    t->far_row = (size_t)p->y[0];
    t->far_plane = t->far_row * (size_t)p->y[1];
    for (int q = 0; q < parts; q++) {
        const int rank = p->c[2] * parts + q;
        t->peer[q] = (struct peer){rank,
                                   (size_t)par_piece_low(n[0], parts, q),
                                   (size_t)par_piece_low(n[1], parts, q) * t->far_row,
                                   piece(n[0], parts, q),
                                   p->x[1],
                                   p->x[2],
                                   p->y[0],
                                   piece(n[1], parts, q),
                                   p->y[2]};
    }
}

/* y to z pencil, among the ranks of one c_y: peer q holds z piece q before and y piece q after. */
static void plan_yz(struct par_pencil *p, struct transpose *t) {
    const int *n = p->in.n, parts = p->in.ranks[2];
    t->near_row = (size_t)p->y[0];
    t->near_plane = t->near_row * (size_t)p->y[1];
    t->far_row = (size_t)p->z[0];
    t->far_plane = t->far_row * (size_t)p->z[1];
    for (int q = 0; q < parts; q++) {
        const int rank = q * p->in.ranks[1] + p->c[1];
        t->peer[q] = (struct peer){rank,
                                   (size_t)par_piece_low(n[1], parts, q) * t->near_row,
                                   (size_t)par_piece_low(n[2], parts, q) * t->far_plane,
                                   p->y[0],
                                   piece(n[1], parts, q),
                                   p->y[2],
                                   p->z[0],
                                   p->z[1],
                                   piece(n[2], parts, q)};
    }
}

struct par_pencil *par_pencil_new(const struct par_pencil_input *in) {
    struct par_pencil *p = calloc(1, sizeof *p);
    const int rank = par_rank();
    p->in = *in;
    ENSURE(in->ranks[0] == 1 && in->ranks[1] * in->ranks[2] == par_size(),
           "process grid %d x %d x %d on %d ranks", in->ranks[0], in->ranks[1], in->ranks[2], par_size());
    p->c[1] = rank % in->ranks[1];
    p->c[2] = rank / in->ranks[1];
    const int *n = in->n;
    memcpy(p->x, (int[3]){n[0], piece(n[1], in->ranks[1], p->c[1]), piece(n[2], in->ranks[2], p->c[2])},
           sizeof p->x);
    memcpy(p->y, (int[3]){piece(n[0], in->ranks[1], p->c[1]), n[1], p->x[2]}, sizeof p->y);
    memcpy(p->z, (int[3]){p->y[0], piece(n[1], in->ranks[2], p->c[2]), n[2]}, sizeof p->z);
    p->x_low = par_piece_low(n[0], in->ranks[1], p->c[1]);
    p->y_low = par_piece_low(n[1], in->ranks[2], p->c[2]);
    size_t most = 0;
    for (int s = 0; s < 2; s++) {
        struct transpose *t = &p->step[s];
        t->peers = in->ranks[s == PAR_PENCIL_XY ? 1 : 2];
        if (t->peers == 1) continue;
        t->peer = calloc((size_t)t->peers, sizeof *t->peer);
        t->request = calloc(2 * (size_t)t->peers, sizeof *t->request);
        if (s == PAR_PENCIL_XY)
            plan_xy(p, t);
        else
            plan_yz(p, t);
        const int *shapes[3] = {p->x, p->y, p->z};
        for (int a = s; a < s + 2; a++) {
            const size_t count = (size_t)shapes[a][0] * (size_t)shapes[a][1] * (size_t)shapes[a][2];
            if (count > most) most = count;
        }
    }
    if (most > 0) {
        p->sent = memory_new(MEMORY_FLUID, most, sizeof(double));
        p->received = memory_new(MEMORY_FLUID, most, sizeof(double));
    }
    return p;
}

void par_pencil_free(struct par_pencil *p) {
    if (!p) return;
    for (int s = 0; s < 2; s++) {
        free(p->step[s].peer);
        free(p->step[s].request);
    }
    memory_free(p->sent);
    memory_free(p->received);
    free(p);
}

void par_pencil_shape(const struct par_pencil *p, int x_pencil[3], int y_pencil[3], int z_pencil[3]) {
    memcpy(x_pencil, p->x, sizeof p->x);
    memcpy(y_pencil, p->y, sizeof p->y);
    memcpy(z_pencil, p->z, sizeof p->z);
}

void par_pencil_z_low(const struct par_pencil *p, int *x, int *y) {
    *x = p->x_low;
    *y = p->y_low;
}

int par_pencil_same(const struct par_pencil *p, enum par_pencil_step step) {
    return p->step[step].peers == 1;
}

/* A box of an array (strides row, plane) <-> a tight block, runs merged where rows or planes are contiguous. */
static void copy_box(double *block, double *array, size_t row, size_t plane, int width, int height, int depth,
                     int out) {
    size_t run = (size_t)width, rows = (size_t)height, planes = (size_t)depth;
    if (run == row) {
        run *= rows;
        rows = 1;
    }
    for (size_t k = 0; k < planes; k++)
        for (size_t j = 0; j < rows; j++, block += run) {
            double *line = array + k * plane + j * row;
            if (out)
                memcpy(block, line, run * sizeof *line);
            else
                memcpy(line, block, run * sizeof *line);
        }
}

static int contiguous(size_t row, size_t plane, int width, int height) {
    return (size_t)width == row && (size_t)width * (size_t)height == plane;
}

static size_t near_count(const struct peer *q) {
    return (size_t)q->width * (size_t)q->height * (size_t)q->depth;
}

static size_t far_count(const struct peer *q) {
    return (size_t)q->far_width * (size_t)q->far_height * (size_t)q->far_depth;
}

/* Boxes that are whole in an array are sent from and received into it; the others go through the buffers. */
static void transpose(struct par_pencil *p, struct transpose *t, const double *from, double *to,
                      int backward) {
    const int me = par_rank();
    const size_t from_row = backward ? t->far_row : t->near_row,
                 from_plane = backward ? t->far_plane : t->near_plane;
    const size_t to_row = backward ? t->near_row : t->far_row,
                 to_plane = backward ? t->near_plane : t->far_plane;
    int requests = 0;
    double *in = p->received, *out = p->sent;
    for (int q = 0; q < t->peers; q++) {
        const struct peer *a = &t->peer[q];
        const size_t count = backward ? near_count(a) : far_count(a);
        const int whole = backward ? contiguous(to_row, to_plane, a->width, a->height)
                                   : contiguous(to_row, to_plane, a->far_width, a->far_height);
        double *target = whole ? to + (backward ? a->near_at : a->far_at) : in;
        if (a->rank != me)
            MPI_Irecv(target, (int)count, MPI_DOUBLE, a->rank, 90 + backward, MPI_COMM_WORLD,
                      &t->request[requests++]);
        if (!whole) in += count;
    }
    const double *mine = NULL;
    for (int q = 0; q < t->peers; q++) {
        const struct peer *a = &t->peer[q];
        const int width = backward ? a->far_width : a->width, height = backward ? a->far_height : a->height;
        const int depth = backward ? a->far_depth : a->depth;
        double *box = (double *)(size_t)(from + (backward ? a->far_at : a->near_at));
        const double *source = box;
        if (!contiguous(from_row, from_plane, width, height)) {
            copy_box(out, box, from_row, from_plane, width, height, depth, 1);
            source = out;
            out += (size_t)width * (size_t)height * (size_t)depth;
        }
        if (a->rank == me)
            mine = source;
        else
            MPI_Isend(source, (int)((size_t)width * (size_t)height * (size_t)depth), MPI_DOUBLE, a->rank,
                      90 + backward, MPI_COMM_WORLD, &t->request[requests++]);
    }
    MPI_Waitall(requests, t->request, MPI_STATUSES_IGNORE);
    in = p->received;
    for (int q = 0; q < t->peers; q++) {
        const struct peer *a = &t->peer[q];
        const int width = backward ? a->width : a->far_width, height = backward ? a->height : a->far_height;
        const int depth = backward ? a->depth : a->far_depth;
        const size_t count = (size_t)width * (size_t)height * (size_t)depth;
        const int whole = contiguous(to_row, to_plane, width, height);
        double *box = to + (backward ? a->near_at : a->far_at);
        double *block = a->rank == me ? (double *)(size_t)mine : in;
        if (a->rank == me || !whole) copy_box(block, box, to_row, to_plane, width, height, depth, 0);
        if (!whole) in += count;
    }
}

void par_pencil_forward(struct par_pencil *p, enum par_pencil_step step, const double *from, double *to) {
    ENSURE(!par_pencil_same(p, step), "step %d has one rank", (int)step);
    transpose(p, &p->step[step], from, to, 0);
}

void par_pencil_backward(struct par_pencil *p, enum par_pencil_step step, const double *from, double *to) {
    ENSURE(!par_pencil_same(p, step), "step %d has one rank", (int)step);
    transpose(p, &p->step[step], from, to, 1);
}
