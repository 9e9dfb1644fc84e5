/* Conjugate gradients for the viscous operator. */
#include "stokes/viscous.h"
#include "base/memory.h"
#include "base/par.h"
#include "stokes/blocks.h"
#include "stokes/kernels.h"

#include <string.h>

enum { PRODUCTS_MAX = 300 }; /* of one solve */

struct stokes_viscous *stokes_viscous_new(const struct stokes_cells *cells, const struct stokes_faces *faces) {
    struct stokes_viscous *v = memory_new(MEMORY_FLUID, 1, sizeof *v);
    const size_t size = stokes_cells_size(cells);
    v->cells = cells;
    v->faces = faces;
    v->e = memory_new(MEMORY_FLUID, size, sizeof *v->e);
    v->r = memory_new(MEMORY_FLUID, size, sizeof *v->r);
    v->s = memory_new(MEMORY_FLUID, size, sizeof *v->s);
    v->v = memory_new(MEMORY_FLUID, size, sizeof *v->v);
    v->blocks = stokes_blocks_new(cells, faces);
    return v;
}

void stokes_viscous_free(struct stokes_viscous *v) {
    if (!v) return;
    MEMORY_FREE(v->e, v->r, v->s, v->v);
    stokes_blocks_free(v->blocks);
    memory_free(v);
}

/* v = A s, and the parts of s.v of all ranks. */
static void product(struct stokes_viscous *v, double dot[3]) {
    const struct stokes_cells *c = v->cells;
    const struct stokes_faces *f = v->faces;
    const double *d = c->g->in.d;
    const int(*next)[6] = (const int(*)[6])c->next;
    const uint8_t(*kind)[3] = (const uint8_t(*)[3])f->kind;
    const float(*s)[3] = (const float(*)[3])v->s, (*diagonal)[256] = (const float(*)[256])f->single;
    stokes_cells_fill(c, sizeof *v->s, v->s);
    stokes_kernels_viscous(0, c->n, next, kind, diagonal, d, s, v->v);
    stokes_kernels_viscous_halves(f->halves, f->half, c->g->axis, next, diagonal, kind, d, s, v->v);
    memset(dot, 0, 3 * sizeof *dot);
    stokes_kernels_dots(c->n, s, (const float(*)[3])v->v, dot);
    par_sum_array(dot, 3);
    v->products++;
}

/* z = B r by a cycle, and the parts of r.z of all ranks. z stands where A s was, which is used up. */
static void precondition(struct stokes_viscous *v, double rho[3]) {
    stokes_blocks_cycle(v->blocks, (const float(*)[3])v->r, v->v);
    memset(rho, 0, 3 * sizeof *rho);
    stokes_kernels_dots(v->cells->n, (const float(*)[3])v->r, (const float(*)[3])v->v, rho);
    par_sum_array(rho, 3);
}

double stokes_viscous_solve(struct stokes_viscous *v, double tolerance) {
    const struct stokes_cells *cells = v->cells;
    double rho[3], beta[3] = {0};
    precondition(v, rho);
    const double start = rho[0] + rho[1] + rho[2];
    double energy = 0;
    const double enough = tolerance * tolerance * start;
    static double gained[PRODUCTS_MAX]; /* by each step */
    int k = 0;
    memset(v->e, 0, stokes_cells_size(cells) * sizeof *v->e);
    memset(v->s, 0, stokes_cells_size(cells) * sizeof *v->s);
    for (; k < PRODUCTS_MAX && rho[0] + rho[1] + rho[2] > enough; k++) {
        double dot[3], alpha[3], now[3] = {0};
        stokes_kernels_direction(cells->n, beta, (const float(*)[3])v->v, v->s);
        product(v, dot);
        for (int c = 0; c < 3; c++) alpha[c] = dot[c] > 0 ? rho[c] / dot[c] : 0;
        stokes_kernels_advance(cells->n, alpha, (const float(*)[3])v->s, (const float(*)[3])v->v, v->e, v->r);
        precondition(v, now);
        gained[k] = alpha[0] * rho[0] + alpha[1] * rho[1] + alpha[2] * rho[2];
        energy += gained[k];
        for (int c = 0; c < 3; c++) {
            beta[c] = rho[c] > 0 ? now[c] / rho[c] : 0;
            rho[c] = now[c];
        }
    }
    stokes_cells_fill(cells, sizeof *v->e, v->e);
    v->left = 0;
    for (int last = k - k / 4 - 1; last >= 0 && last < k; last++) v->left += gained[last];
    return energy;
}
