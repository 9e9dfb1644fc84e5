/* Predicts the velocity by groups of planes. */
#include "fluid/momentum/planes.h"
#include "base/clock.h"
#include "base/memory.h"
#include "base/par_halo.h"
#include "fluid/grid/boundary.h"

#include <stdlib.h>
#include <string.h>

struct fluid_planes {
    struct fluid_momentum_stage stage;
    int group;              /* number of planes computed at once */
    int open;               /* 1: planes of a stage are left */
    double *top[3];         /* [plane] u* of this rank's last plane; the third is in the seam */
    double *seam;           /* [2][plane] w* of the last plane below this rank, then of this rank's own */
    struct par_halo *halos; /* of the seam: its second plane is the rank's only one, the first one its low ghosts */
};

struct fluid_planes *fluid_planes_new(const struct fluid *f) {
    const struct fluid_grid *g = f->grid;
    if (f->in.immersed || f->predicted[0] != f->state.u || g->ranks[1] > 1 || fluid_momentum_group(g) == 0) return NULL;
    struct fluid_planes *p = calloc(1, sizeof *p);
    p->group = fluid_momentum_group(g);
    for (int c = 0; c < 2; c++) p->top[c] = memory_new(MEMORY_FLUID, (size_t)g->plane, sizeof(double));
    p->seam = memory_new(MEMORY_FLUID, 2 * (size_t)g->plane, sizeof(double));
    p->top[2] = p->seam + g->plane;
    const struct par_halo_input in = {.m = {g->m[0], g->m[1], 1},
                                      .halo = 1,
                                      .ranks = {g->ranks[0], g->ranks[1], g->ranks[2]},
                                      .periodic = {g->periodic[0], g->periodic[1], g->periodic[2]},
                                      .first = g->plane,
                                      .row = g->row,
                                      .plane = g->plane,
                                      .lender = g->halos};
    p->halos = par_halo_new(&in);
    return p;
}

void fluid_planes_free(struct fluid_planes *p) {
    if (!p) return;
    par_halo_free(p->halos);
    for (int c = 0; c < 2; c++) memory_free(p->top[c]);
    memory_free(p->seam);
    free(p);
}

static void copy_rows(const struct fluid_grid *g, const double *from, double *to) {
    for (int j = 0; j < g->m[1]; j++) memcpy(to + j * g->row, from + j * g->row, (size_t)g->m[0] * sizeof *to);
}

void fluid_planes_begin(struct fluid *f, const struct fluid_momentum_stage *s) {
    struct fluid_planes *p = f->planes;
    const struct fluid_grid *g = f->grid;
    const struct par_halo_part low = {.layers = 1,
                                      .high = {g->m[0], g->m[1], 1},
                                      .wanted = {{0, 0}, {0, 0}, {1, 0}},
                                      .asked = {{0, 0}, {0, 0}, {0, 1}}};
    p->stage = *s;
    p->open = 1;
    fluid_momentum_predict_top(s, f->predicted, f->state.pi, f->state.rate, p->top);
    par_halo_fill_part(p->halos, 2, 1, &p->seam, &low);
}

int fluid_planes_open(const struct fluid *f) { return f->planes && f->planes->open; }

void fluid_planes_predict(struct fluid *f, int k) {
    struct fluid_planes *p = f->planes;
    const struct fluid_grid *g = f->grid;
    const int end = k + p->group < g->m[2] ? k + p->group : g->m[2];
    struct par_halo_part part = par_halo_whole(g->halos, 1);
    if (k % p->group) return;
    clock_begin(CLOCK_MOMENTUM);
    fluid_momentum_predict_planes(&p->stage, k, end, f->predicted, f->state.pi, f->state.rate, p->top);
    if (k == 0 && !par_halo_at_side(g->halos, 2, 0))
        copy_rows(g, p->seam, f->predicted[2] + fluid_grid_at(g, 0, 0, -1));
    part.low[2] = k > 0 ? k : -1; /* includes the face on a low side */
    part.high[2] = end;
    fluid_boundary_faces(f->boundary, g, f->predicted, &part);
    if (end == g->m[2]) p->open = 0;
    clock_end(CLOCK_MOMENTUM);
}
