/* Puts a problem together: the pores that lead through, the faces between them, and the operators. */
#include "stokes/stokes.h"
#include "base/memory.h"
#include "base/par.h"
#include "stokes/darcy.h"
#include "stokes/viscous.h"

#include <math.h>
#include <string.h>

#define PHI_TOLERANCE 0.01 /* of phi = A^-1 1 */

/* The cells whose pieces lead through, as a mask of their own. */
static struct stokes_mask *connected_mask(const struct stokes_cells *c, const struct stokes_pieces *p) {
    struct stokes_mask *m = stokes_mask_new(c->g->mask->n);
    int at[3];
    if (c->n > 0) stokes_mask_find(c->g->mask, c->first[par_rank()], at);
    for (int i = 0; i < c->n; i++) {
        if (i > 0) stokes_mask_next(c->g->mask, at);
        if (p->stays[i]) stokes_mask_set(m, at[0], at[1], at[2]);
    }
    stokes_mask_count(m);
    return m;
}

/* Leaves the pores that lead nowhere out. */
static void choose_pores(struct stokes *s, const struct stokes_mask *mask) {
    struct stokes_mask *all = s->g.axis >= 0 ? stokes_mask_extended(mask, s->g.axis) : NULL;
    s->g.mask = all ? all : mask;
    struct stokes_cells *cells = stokes_cells_new(&s->g);
    struct stokes_pieces *p = stokes_pieces_new(cells);
    s->mask = connected_mask(cells, p);
    s->pieces = *p;
    s->pieces.stays = NULL;
    stokes_pieces_free(p);
    s->g.mask = s->mask;
    stokes_cells_free(cells);
    stokes_mask_free(all);
}

/* phi = A^-1 1, at least 1/diagonal as the exact one is. */
static float (*phi_new(struct stokes *s))[3] {
    struct stokes_viscous *v = s->viscous;
    const size_t size = stokes_cells_size(s->cells);
    float(*phi)[3] = memory_new(MEMORY_FLUID, size, sizeof *phi);
    memset(v->r, 0, size * sizeof *v->r);
    for (int i = 0; i < s->cells->n; i++)
        for (int c = 0; c < 3; c++)
            if (stokes_faces_is_open(s->faces, i, c))
                v->r[i][c] = stokes_faces_is_half(s->faces->kind[i][c]) ? 0.5F : 1;
    stokes_viscous_solve(v, PHI_TOLERANCE);
    for (size_t i = 0; i < size; i++)
        for (int c = 0; c < 3; c++) {
            const int kind = s->faces->kind[i][c];
            phi[i][c] = fmaxf(v->e[i][c], s->faces->inverse[c][kind]) * (stokes_faces_is_half(kind) ? 2 : 1);
        }
    return phi;
}

struct stokes *stokes_new(const struct stokes_mask *mask, const struct stokes_input *in) {
    struct stokes *s = memory_new(MEMORY_FLUID, 1, sizeof *s);
    s->g.in = *in;
    s->g.axis = -1;
    for (int c = 0; c < 3; c++)
        if (in->side[c][0] == STOKES_SIDE_PRESSURE) s->g.axis = c;
    for (int i = 0; i < 9; i++) s->tensor[i / 3][i % 3] = NAN;
    s->volume = (double)mask->n[0] * mask->n[1] * mask->n[2];
    s->pores = mask->before[(long)mask->n[1] * mask->n[2]];
    choose_pores(s, mask);
    for (int c = 0; c < 3; c++)
        for (int t = 0; t < 3 && !s->pieces.percolates[c]; t++) s->tensor[c][t] = s->tensor[t][c] = 0;
    if (s->pieces.cells == 0) return s;
    s->cells = stokes_cells_new(&s->g);
    s->through = s->pieces.cells - par_sum_long(s->cells->outside);
    s->faces = stokes_faces_new(s->cells);
    s->viscous = stokes_viscous_new(s->cells, s->faces);
    s->darcy = stokes_darcy_new(s->cells, phi_new(s));
    s->u = memory_new(MEMORY_FLUID, stokes_cells_size(s->cells), sizeof *s->u);
    s->p = memory_new(MEMORY_FLUID, stokes_cells_size(s->cells), sizeof *s->p);
    return s;
}

void stokes_free(struct stokes *s) {
    if (!s) return;
    stokes_darcy_free(s->darcy);
    stokes_viscous_free(s->viscous);
    stokes_faces_free(s->faces);
    stokes_cells_free(s->cells);
    stokes_mask_free(s->mask);
    for (int c = 0; c < 3; c++) memory_free(s->pressure[c]);
    MEMORY_FREE(s->u, s->p, s);
}
