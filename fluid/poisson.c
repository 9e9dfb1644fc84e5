#include "fluid/poisson.h"
#include "base/memory.h"
#include "base/par_pencil.h"
#include "fluid/tridiagonal.h"

#include <stdlib.h>

struct fluid_poisson {
    struct fluid_poisson_input in;
    struct par_pencil *pencil;
    int x[3], y[3], z[3]; /* shapes of the pencils */
    struct fluid_transform
        *t[3];            /* of a plane of the x pencil, a plane of the y pencil, a row of the z pencil */
    double *lambda[3];    /* of this rank's part of the z pencil, 1/m2 */
    double inverse_scale; /* one over what all transforms multiply by */
    double *home, *y_array, *z_array; /* one array where no transpose stands between them */
    double *column, *work;            /* [m_x] sums of lambda, and scratch of the bands [n_z][m_x] */
};

static int bands(const struct fluid_poisson *p) {
    return p->in.last != FLUID_POISSON_TRANSFORM && p->in.end[2][0] != FLUID_END_PERIODIC;
}

static double *eigenvalues(const struct fluid_poisson_input *in, int d, int low, int count) {
    double *all = memory_new(MEMORY_FLUID, (size_t)in->n[d], sizeof *all);
    double *part = memory_new(MEMORY_FLUID, (size_t)count, sizeof *part);
    fluid_transform_eigenvalues(in->n[d], in->d[d], in->end[d][0], in->end[d][1], all);
    for (int i = 0; i < count; i++) part[i] = all[low + i];
    memory_free(all);
    return part;
}

static size_t volume(const int shape[3]) { return (size_t)shape[0] * (size_t)shape[1] * (size_t)shape[2]; }

static void plan(struct fluid_poisson *p) {
    const struct fluid_poisson_input *in = &p->in;
    const int *x = p->x, *y = p->y, *z = p->z;
    const struct fluid_transform_input of[3] = {
        {.n = x[0],
         .lines = x[1],
         .stride = 1,
         .distance = x[0],
         .out_stride = 1,
         .out_distance = (int)in->row},
        {.n = y[1], .lines = y[0], .stride = y[0], .distance = 1},
        {.n = z[2], .lines = z[0], .stride = z[0] * z[1], .distance = 1}};
    p->inverse_scale = 1;
    for (int d = 0; d < (bands(p) ? 2 : 3); d++) {
        struct fluid_transform_input t = of[d];
        t.low = in->end[d][0];
        t.high = in->end[d][1];
        p->t[d] = fluid_transform_new(&t);
        p->inverse_scale /= fluid_transform_scale(t.n, t.low, t.high);
    }
}

struct fluid_poisson *fluid_poisson_new(const struct fluid_poisson_input *in) {
    struct fluid_poisson *p = calloc(1, sizeof *p);
    struct par_pencil_input grid = {.n = {in->n[0], in->n[1], in->n[2]},
                                    .ranks = {1, in->ranks[1], in->ranks[2]}};
    p->in = *in;
    p->pencil = par_pencil_new(&grid);
    par_pencil_shape(p->pencil, p->x, p->y, p->z);
    int low[3] = {0, 0, 0};
    par_pencil_z_low(p->pencil, &low[0], &low[1]);
    for (int d = 0; d < 3; d++) p->lambda[d] = eigenvalues(in, d, low[d], p->z[d]);
    p->home = memory_new_work(MEMORY_FLUID, volume(p->x));
    p->y_array =
        par_pencil_same(p->pencil, PAR_PENCIL_XY) ? p->home : memory_new_work(MEMORY_FLUID, volume(p->y));
    p->z_array =
        par_pencil_same(p->pencil, PAR_PENCIL_YZ) ? p->y_array : memory_new_work(MEMORY_FLUID, volume(p->z));
    p->column = memory_new_work(MEMORY_FLUID, (size_t)p->z[0]);
    if (bands(p)) p->work = memory_new_work(MEMORY_FLUID, (size_t)p->z[0] * (size_t)p->z[2]);
    plan(p);
    return p;
}

void fluid_poisson_free(struct fluid_poisson *p) {
    if (!p) return;
    for (int d = 0; d < 3; d++) {
        fluid_transform_free(p->t[d]);
        memory_free(p->lambda[d]);
    }
    if (p->z_array != p->y_array) memory_free(p->z_array);
    if (p->y_array != p->home) memory_free(p->y_array);
    memory_free(p->home);
    memory_free(p->column);
    memory_free(p->work);
    par_pencil_free(p->pencil);
    free(p);
}

double *fluid_poisson_plane(struct fluid_poisson *p, int k) {
    return p->home + (size_t)k * (size_t)p->x[0] * (size_t)p->x[1];
}

void fluid_poisson_plane_forward(struct fluid_poisson *p, int k) {
    double *plane = fluid_poisson_plane(p, k);
    fluid_transform_forward(p->t[0], plane);
    if (p->y_array == p->home) fluid_transform_forward(p->t[1], plane);
}

/* q = b inverse_scale / (lambda + lambda_z), and 0 where that is singular. */
static void divide(int n, int columns, double scale, const double *restrict lambda,
                   const double *restrict lambda_z, double *restrict b, ptrdiff_t plane) {
    for (int k = 0; k < n; k++) {
        double *restrict q = b + k * plane;
        const double lz = lambda_z[k];
        for (int i = 0; i < columns; i++) {
            const double l = lambda[i] + lz;
            q[i] *= l == 0 ? 0 : scale / l;
        }
    }
}

static void scale_by(int n, int columns, double scale, double *b, ptrdiff_t plane) {
    for (int k = 0; k < n; k++)
        for (int i = 0; i < columns; i++) b[k * plane + i] *= scale;
}

/* Row j of the z pencil: all of z for every x. */
static void solve_row(struct fluid_poisson *p, int j) {
    const int columns = p->z[0], n = p->z[2];
    const ptrdiff_t plane = (ptrdiff_t)p->z[0] * p->z[1];
    double *b = p->z_array + (ptrdiff_t)j * columns;
    for (int i = 0; i < columns; i++) p->column[i] = p->lambda[0][i] + p->lambda[1][j];
    if (bands(p)) {
        scale_by(n, columns, p->inverse_scale, b, plane);
        fluid_tridiagonal_solve(n, columns, p->in.d[2], p->in.end[2][0], p->in.end[2][1], p->column, b, plane,
                                p->work);
    } else {
        fluid_transform_forward(p->t[2], b);
        divide(n, columns, p->inverse_scale, p->column, p->lambda[2], b, plane);
        fluid_transform_backward(p->t[2], b, b);
    }
}

void fluid_poisson_solve(struct fluid_poisson *p, double *q) {
    const int cut_xy = p->y_array != p->home, cut_yz = p->z_array != p->y_array;
    const size_t y_plane = (size_t)p->y[0] * (size_t)p->y[1];
    if (cut_xy) {
        par_pencil_forward(p->pencil, PAR_PENCIL_XY, p->home, p->y_array);
        for (int k = 0; k < p->y[2]; k++) fluid_transform_forward(p->t[1], p->y_array + (size_t)k * y_plane);
    }
    if (cut_yz) par_pencil_forward(p->pencil, PAR_PENCIL_YZ, p->y_array, p->z_array);
    for (int j = 0; j < p->z[1]; j++) solve_row(p, j);
    if (cut_yz) par_pencil_backward(p->pencil, PAR_PENCIL_YZ, p->z_array, p->y_array);
    if (cut_xy) {
        for (int k = 0; k < p->y[2]; k++)
            fluid_transform_backward(p->t[1], p->y_array + (size_t)k * y_plane,
                                     p->y_array + (size_t)k * y_plane);
        par_pencil_backward(p->pencil, PAR_PENCIL_XY, p->y_array, p->home);
    }
    for (int k = 0; k < p->x[2]; k++) {
        double *plane = fluid_poisson_plane(p, k);
        if (!cut_xy) fluid_transform_backward(p->t[1], plane, plane);
        fluid_transform_backward(p->t[0], plane, q + k * p->in.plane);
    }
}
