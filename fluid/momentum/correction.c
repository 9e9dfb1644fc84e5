/* Applies the pressure correction to velocity and pressure, plane by plane.  (001: eqs 3.72-3.73) */
#include "fluid/momentum/correction.h"
#include "base/par_halo.h"
#include "base/threads.h"
#include "fluid/grid/boundary.h"
#include "fluid/poisson/poisson.h"

static int cut(const struct fluid_grid *g) { return g->ranks[1] > 1; }

static ptrdiff_t turn_size(const struct fluid_grid *g) { return g->row * (g->m[1] + 1); }

size_t fluid_correction_work(const struct fluid_grid *g) {
    return cut(g) ? g->size : (size_t)(threads_count() + 1) * (size_t)turn_size(g);
}

/* Cell (0,0) of plane k; rows are g->row apart. */
static double *plane_of(const struct fluid *f, int k) {
    return cut(f->grid) ? f->correction + fluid_grid_at(f->grid, 0, 0, k)
                        : f->correction + (k % (threads_count() + 1)) * turn_size(f->grid);
}

/* What the threads correct, plane by plane. */
struct work {
    struct fluid *f;
    double c;
    const struct fluid_momentum_pressure *pressure;
    double *const *q;
};

static double *place(void *data, int k) { return plane_of(((const struct work *)data)->f, k); }

/* Computes all planes and gets their rows from the next rank in y. */
static void collect(struct work *w) {
    struct fluid *f = w->f;
    const struct fluid_grid *g = f->grid;
    const struct par_halo_part high = {.layers = 1,
                                       .high = {g->m[0], g->m[1], g->m[2] + 1},
                                       .wanted = {{0, 0}, {0, 1}, {0, 0}},
                                       .asked = {{0, 0}, {1, 0}, {0, 0}}};
    fluid_poisson_backward(f->poisson, &(struct fluid_poisson_target){.place = place, .data = w});
    par_halo_fill_part(g->halos, 1, 1, &f->correction, &high);
}

/* The sign of a ghost relative to the value that it mirrors; -1 where the correction is 0 on the side. */
static double image(const struct fluid *f, int d, int side) {
    return !f->grid->periodic[d] && f->boundary->side[d][side].condition[3] == FLUID_DIRICHLET ? -1 : 1;
}

/* Ghosts of a plane of phi on the high sides in x and y. */
static void extend(const struct fluid *f, double *phi) {
    const struct fluid_grid *g = f->grid;
    const int mx = g->m[0], my = g->m[1];
    const double in_x = image(f, 0, 1), in_y = image(f, 1, 1);
    const int from_x = g->periodic[0] ? 0 : mx - 1, from_y = g->periodic[1] ? 0 : my - 1;
    for (int j = 0; j < my; j++) phi[j * g->row + mx] = in_x * phi[j * g->row + from_x];
    if (cut(g) && !f->boundary->side[1][1].here) return;
    for (int i = 0; i < mx; i++) phi[my * g->row + i] = in_y * phi[from_y * g->row + i];
}

/* Adds phi to the pressures in the ghosts on the high sides of plane k. */
static void add_beside(const struct fluid_grid *g, int k, const double *phi,
                       const struct fluid_momentum_pressure *pressure) {
    const int mx = g->m[0], my = g->m[1];
    for (int j = 0; j < my; j++)
        fluid_momentum_kernels_add(pressure, fluid_grid_at(g, mx, j, k), 1, phi + j * g->row + mx);
    fluid_momentum_kernels_add(pressure, fluid_grid_at(g, 0, my, k), mx, phi + my * g->row);
}

static void add_above(const struct fluid_grid *g, const double *phi, const struct fluid_momentum_pressure *pressure) {
    for (int j = 0; j < g->m[1]; j++)
        fluid_momentum_kernels_add(pressure, fluid_grid_at(g, 0, j, g->m[2]), g->m[0], phi + j * g->row);
}

/* Corrects, at plane k, the free faces on low sides, which no array stores, and the pressures beyond them. */
static void correct_low(const struct fluid *f, double c, int k, const double *phi,
                        const struct fluid_momentum_pressure *pressure, double *const q[3]) {
    const struct fluid_grid *g = f->grid;
    for (int d = 0; d < 3; d++) {
        const struct fluid_boundary_side *s = &f->boundary->side[d][0];
        if (!s->here || s->normal != FLUID_NORMAL_FREE || (d == 2 && k > 0)) continue;
        const double factor = c / g->d[d] * (1 - image(f, d, 0));
        for (int j = 0; j < (d == 1 ? 1 : g->m[1]); j++)
            for (int i = 0; i < (d == 0 ? 1 : g->m[0]); i++) {
                const size_t n = fluid_grid_at(g, i, j, k) - (size_t)fluid_boundary_stride(g, d);
                q[d][n] = f->predicted[d][n] - factor * phi[j * g->row + i] + f->shift[d];
                const double beyond = image(f, d, 0) * phi[j * g->row + i];
                fluid_momentum_kernels_add(pressure, n, 1, &beyond);
            }
    }
}

/* Sets the sides' faces at plane k, and the ghosts of the plane whose neighbours are complete; if y is cut over ranks,
 * along x only. */
static void ghosts_of_plane(const struct fluid *f, int k, double *const q[3]) {
    const struct fluid_grid *g = f->grid;
    struct par_halo_part part = par_halo_whole(g->halos, 1);
    part.low[2] = k > 0 ? k : -1; /* includes the face on a low side */
    part.high[2] = k + 1;
    fluid_boundary_faces(f->boundary, g, q, &part);
    for (int d = 0; d < (cut(g) ? 1 : 2); d++) fluid_boundary_ghosts(f->boundary, g, q, d, &part);
}

/* The remaining ghosts of the velocity. */
static void ghosts_between_planes(const struct fluid *f, double *const q[3]) {
    const struct par_halo_part whole = par_halo_whole(f->grid->halos, 1);
    for (int d = cut(f->grid) ? 1 : 2; d < 3; d++) fluid_boundary_ghosts(f->boundary, f->grid, q, d, &whole);
}

/* Corrects plane k by the planes k and k+1 of phi. */
static void correct(void *data, int k) {
    const struct work *w = data;
    const struct fluid *f = w->f;
    double *phi = plane_of(f, k);
    if (k == f->grid->m[2]) {
        add_above(f->grid, phi, w->pressure);
        return;
    }
    extend(f, phi);
    fluid_momentum_kernels_correct(f->grid, k, w->c, f->shift, phi, plane_of(f, k + 1), f->predicted, w->q,
                                   w->pressure);
    add_beside(f->grid, k, phi, w->pressure);
    correct_low(f, w->c, k, phi, w->pressure, w->q);
    ghosts_of_plane(f, k, w->q);
}

static void correct_planes(int thread, void *data) {
    int from, to;
    threads_share(((const struct work *)data)->f->grid->m[2] + 1, 1, thread, &from, &to);
    for (int k = to - 1; k >= from; k--) correct(data, k);
}

void fluid_correction_apply(struct fluid *f, double c, const struct fluid_momentum_pressure *pressure,
                            double *const q[3]) {
    struct work w = {f, c, pressure, q};
    if (cut(f->grid)) {
        collect(&w);
        threads_run(correct_planes, &w);
    } else {
        fluid_poisson_backward(f->poisson, &(struct fluid_poisson_target){place, correct, &w});
    }
    ghosts_between_planes(f, q);
}
