/* Implicit diffusion: one Helmholtz equation for each velocity component in each stage. */
#include "fluid/momentum/diffusion.h"
#include "base/clock.h"
#include "base/die.h"
#include "base/memory.h"
#include "base/par_halo.h"
#include "base/side.h"
#include "base/threads.h"
#include "fluid/grid/boundary.h"
#include "fluid/internal.h"
#include "fluid/poisson/poisson.h"

#include <stdlib.h>
#include <string.h>

/* b_r: backward Euler in every stage. Each stage then damps every wave at any step and changes no wave's sign; the
 * increments of pressure and forcing need that. The method is first order in time. */
static const double implicit[3] = {8.0 / 15, 2.0 / 15, 1.0 / 3};

struct fluid_diffusion {
    struct fluid_poisson *solver[3]; /* of u, v, w; components with the same ends share one */
    double *change;                  /* [threads][m_y][row] u* - u of a plane */
    double *field[3];                /* for an implicit forcing: a field on the faces; zero on the sides */
};

static size_t change_size(const struct fluid_grid *g) { return (size_t)(g->row * g->m[1]); }

/* Ends of component c: on its own faces along its own direction, at centres along the others. */
static void ends_of(const struct fluid *f, int c, enum fluid_end end[3][2]) {
    for (int d = 0; d < 3; d++)
        for (int side = 0; side < 2; side++)
            end[d][side] = f->grid->periodic[d] ? FLUID_END_PERIODIC
                           : c == d             ? FLUID_END_FACE
                                                : fluid_boundary_end(f->boundary, d, side, c);
}

static struct fluid_poisson *new_solver(const struct fluid *f, int c) {
    const struct fluid_grid *g = f->grid;
    struct fluid_poisson_input in = {.row = g->row, .shifts = 3};
    for (int d = 0; d < 3; d++) {
        in.n[d] = g->n[d];
        in.d[d] = g->d[d];
        in.ranks[d] = g->ranks[d];
        in.cut[d] = g->cut[d];
    }
    ends_of(f, c, in.end);
    return fluid_poisson_new(&in);
}

static void refuse_open(const struct fluid *f) {
    if (!(f->in.viscosity > 0)) die_all(EXIT_CODE_SCENE, "fluid.diffusion: implicit needs a viscosity");
    for (int d = 0; d < 3; d++)
        for (int side = 0; side < 2; side++)
            if (!f->grid->periodic[d] && f->boundary->side[d][side].normal == FLUID_NORMAL_FREE)
                die_all(EXIT_CODE_SCENE,
                        "fluid.diffusion: implicit needs a normal velocity on every side, and that of "
                        "fluid.sides.%s is free",
                        side_name[d][side]);
    for (int d = 0; d < 3; d++)
        for (int side = 0; side < 2; side++)
            if (f->boundary->side[d][side].normal == FLUID_NORMAL_CONVECTIVE && f->grid->n[d] / f->grid->ranks[d] < 2)
                die_all(EXIT_CODE_SCENE,
                        "fluid.diffusion: implicit with an outflow at %s needs two cells a rank in %c, and "
                        "there are %d for %d ranks",
                        side_name[d][side], "xyz"[d], f -> grid -> n[d], f -> grid -> ranks[d]);
}

struct fluid_diffusion *fluid_diffusion_new(const struct fluid *f) {
    refuse_open(f);
    struct fluid_diffusion *diffusion = calloc(1, sizeof *diffusion);
    enum fluid_end end[3][3][2];
    for (int c = 0; c < 3; c++) {
        ends_of(f, c, end[c]);
        for (int o = 0; o < c && !diffusion->solver[c]; o++)
            if (!memcmp(end[c], end[o], sizeof end[c])) diffusion->solver[c] = diffusion->solver[o];
        if (!diffusion->solver[c]) diffusion->solver[c] = new_solver(f, c);
    }
    diffusion->change = memory_new(MEMORY_FLUID, (size_t)threads_count() * change_size(f->grid), sizeof(double));
    for (int c = 0; c < 3 && f->in.immersed; c++)
        diffusion->field[c] = memory_new(MEMORY_FLUID, f->grid->size, sizeof(double));
    return diffusion;
}

void fluid_diffusion_free(struct fluid_diffusion *d) {
    if (!d) return;
    for (int c = 2; c >= 0; c--) {
        memory_free(d->field[c]);
        int shared = 0;
        for (int o = 0; o < c; o++) shared |= d->solver[o] == d->solver[c];
        if (!shared) fluid_poisson_free(d->solver[c]);
    }
    memory_free(d->change);
    free(d);
}

double fluid_diffusion_length2(const struct fluid *f, int r, double dt) { return implicit[r] * dt * f->in.viscosity; }

double fluid_diffusion_step(const struct fluid *f) {
    double sum = 0;
    for (int d = 0; d < 3; d++) sum += 1 / (f->grid->d[d] * f->grid->d[d]);
    return FLUID_DIFFUSION_NUMBER * 3 / (f->in.viscosity * sum);
}

void fluid_diffusion_plane(const struct fluid_grid *g, int k, double shift, const double weight[3], const int faces[3],
                           const double *predicted, const double *q, double *rhs) {
    const ptrdiff_t row = g->row, plane = g->plane;
    const double wx = weight[0], wy = weight[1], wz = weight[2];
    for (int j = 0; j < g->m[1]; j++) {
        const size_t n = fluid_grid_at(g, 0, j, k);
        const double *restrict p = predicted + n, *restrict u = q + n;
        double *restrict to = rhs + (ptrdiff_t)j * g->m[0];
        const int end = j < faces[1] && k < faces[2] ? faces[0] : 0;
        for (int i = 0; i < end; i++) {
            const double lap = wx * (u[i - 1] - 2 * u[i] + u[i + 1]) + wy * (u[i - row] - 2 * u[i] + u[i + row]) +
                               wz * (u[i - plane] - 2 * u[i] + u[i + plane]);
            to[i] = -shift * (p[i] - u[i] + lap);
        }
        for (int i = end; i < g->m[0]; i++) to[i] = 0;
    }
}

/* An outflow changes the normal velocity on its faces, which are not advanced here. The part of the Laplacian that
 * contains this change goes to the right-hand side of the adjacent faces, in plane k. */
static void take_sides(const struct fluid *f, int c, int k, double *rhs) {
    const struct fluid_grid *g = f->grid;
    const double *q = fluid_component(&f->state, c), *predicted = f->predicted[c];
    const double per = 1 / (g->d[c] * g->d[c]);
    for (int side = 0; side < 2; side++) {
        const struct fluid_boundary_side *s = &f->boundary->side[c][side];
        int low[3] = {0, 0, k}, high[3] = {g->m[0], g->m[1], k + 1};
        if (!s->here || s->normal != FLUID_NORMAL_CONVECTIVE) continue;
        low[c] = side ? g->m[c] - 2 : 0; /* the advanced face next to the side */
        high[c] = low[c] + 1;
        if (c == 2 && low[2] != k) continue;
        const ptrdiff_t out = (side ? 1 : -1) * fluid_boundary_stride(g, c);
        for (int j = low[1]; j < high[1]; j++)
            for (int i = low[0]; i < high[0]; i++) {
                const ptrdiff_t n = (ptrdiff_t)fluid_grid_at(g, i, j, k) + out;
                rhs[j * g->m[0] + i] -= per * (predicted[n] - q[n]);
            }
    }
}

static void faces_of(const struct fluid_grid *g, int c, int faces[3]) {
    for (int d = 0; d < 3; d++) faces[d] = g->m[d] - (c == d && par_halo_at_side(g->halos, c, 1));
}

/* to = from + change, or change alone (from NULL), on the advanced faces of plane k. */
static void put_plane(const struct fluid_grid *g, int k, const int faces[3], const double *change, const double *from,
                      double *to) {
    if (k >= faces[2]) return;
    for (int j = 0; j < faces[1]; j++) {
        const size_t n = fluid_grid_at(g, 0, j, k);
        const double *restrict w = change + j * g->row;
        for (int i = 0; i < faces[0]; i++) to[n + (size_t)i] = (from ? from[n + (size_t)i] : 0) + w[i];
    }
}

/* One component as the threads take it, plane by plane. */
struct component {
    struct fluid *f;
    int c, faces[3];
    double shift, weight[3];
    const double *from; /* NULL: 0 */
    double *to;
};

static double *change_of(void *data, int k) {
    const struct component *component = data;
    (void)k;
    return component->f->diffusion->change + (size_t)threads_me() * change_size(component->f->grid);
}

static void put(void *data, int k) {
    const struct component *component = data;
    if (k < component->f->grid->m[2])
        put_plane(component->f->grid, k, component->faces, change_of(data, k), component->from, component->to);
}

/* Solves, once all planes have been transformed: to = from + solution. */
static void finish(struct component *component) {
    struct fluid_poisson *solver = component->f->diffusion->solver[component->c];
    fluid_poisson_solve(solver, 0);
    fluid_poisson_backward(solver, &(struct fluid_poisson_target){change_of, put, component});
}

static void fill(void *data, int k, double *rhs) {
    const struct component *component = data;
    const struct fluid *f = component->f;
    fluid_diffusion_plane(f->grid, k, component->shift, component->weight, component->faces, f->predicted[component->c],
                          component->from, rhs);
    take_sides(f, component->c, k, rhs);
}

static void diffuse(struct fluid *f, int c, int r, double dt) {
    const struct fluid_grid *g = f->grid;
    struct component component = {.f = f,
                                  .c = c,
                                  .shift = 1 / fluid_diffusion_length2(f, r, dt),
                                  .from = fluid_component(&f->state, c),
                                  .to = f->predicted[c]};
    faces_of(g, c, component.faces);
    for (int d = 0; d < 3; d++) component.weight[d] = f->scheme.gamma[r] * dt * f->in.viscosity / (g->d[d] * g->d[d]);
    fluid_poisson_shift(f->diffusion->solver[c], r, component.shift);
    fluid_poisson_forward(f->diffusion->solver[c], fill, &component);
    finish(&component);
}

void fluid_diffusion_stage(struct fluid *f, int r, double dt) {
    if (!f->diffusion) return;
    clock_begin(CLOCK_MOMENTUM);
    for (int c = 0; c < 3; c++) diffuse(f, c, r, dt);
    clock_end(CLOCK_MOMENTUM);
}

double *const *fluid_diffusion_field(struct fluid *f) { return f->diffusion->field; }

static void clear_part(int thread, void *data) {
    const struct fluid *f = data;
    const size_t from = f->grid->size * (size_t)thread / (size_t)threads_count();
    const size_t to = f->grid->size * (size_t)(thread + 1) / (size_t)threads_count();
    for (int c = 0; c < 3; c++) memset(f->diffusion->field[c] + from, 0, (to - from) * sizeof(double));
}

void fluid_diffusion_clear(struct fluid *f) { threads_run(clear_part, f); }

/* One plane k of a field, without padding, times -shift; zero on faces that are not advanced. */
static void field_plane(const struct fluid_grid *g, int k, double shift, const int faces[3], const double *field,
                        double *rhs) {
    for (int j = 0; j < g->m[1]; j++) {
        const double *restrict q = field + fluid_grid_at(g, 0, j, k);
        double *restrict to = rhs + (ptrdiff_t)j * g->m[0];
        const int end = j < faces[1] && k < faces[2] ? faces[0] : 0;
        for (int i = 0; i < end; i++) to[i] = -shift * q[i];
        for (int i = end; i < g->m[0]; i++) to[i] = 0;
    }
}

static void fill_field(void *data, int k, double *rhs) {
    const struct component *component = data;
    field_plane(component->f->grid, k, component->shift, component->faces, component->to, rhs);
}

void fluid_diffusion_solve(struct fluid *f, int r, double dt) {
    for (int c = 0; c < 3; c++) {
        struct fluid_poisson *solver = f->diffusion->solver[c];
        struct component component = {
            .f = f, .c = c, .shift = 1 / fluid_diffusion_length2(f, r, dt), .to = f->diffusion->field[c]};
        faces_of(f->grid, c, component.faces);
        fluid_poisson_shift(solver, r, component.shift);
        fluid_poisson_forward(solver, fill_field, &component);
        finish(&component);
    }
}

/* A field times a factor, as the threads add it. */
struct addition {
    struct fluid *f;
    double factor;
};

static void add_part(int thread, void *data) {
    const struct addition *a = data;
    const struct fluid *f = a->f;
    const struct fluid_grid *g = f->grid;
    int from, to;
    threads_share(g->m[2], 1, thread, &from, &to);
    for (int c = 0; c < 3; c++)
        for (int k = from; k < to; k++)
            for (int j = 0; j < g->m[1]; j++) {
                const size_t n = fluid_grid_at(g, 0, j, k);
                const double *restrict w = f->diffusion->field[c] + n;
                double *restrict q = f->predicted[c] + n;
                for (int i = 0; i < g->m[0]; i++) q[i] += a->factor * w[i];
            }
}

void fluid_diffusion_add(struct fluid *f, double factor) {
    struct addition a = {f, factor};
    threads_run(add_part, &a);
}
