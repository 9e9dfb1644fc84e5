/* Carries a solution from earlier pores to later ones. */
#include "stokes/carry.h"
#include "base/memory.h"
#include "base/par.h"
#include "base/par_exchange.h"
#include "base/sort.h"

#include <string.h>

#define LEAST 0.5        /* share of the cells that must have been pore */
enum { REACH_MAX = 16 }; /* cells from known ones, to which pressures are continued */

/* A cell's values on their way to the rank that has the cell now. */
struct record {
    long number; /* of the later pores */
    float p, u[3];
};

struct stokes_carry *stokes_carry_new(void) {
    return memory_new(MEMORY_FLUID, 1, sizeof(struct stokes_carry));
}

void stokes_carry_free(struct stokes_carry *c) {
    if (!c) return;
    stokes_mask_free(c->mask);
    memory_free(c->first);
    for (int axis = 0; axis < 3; axis++) MEMORY_FREE(c->p[axis], c->u[axis]);
    memory_free(c);
}

void stokes_carry_keep(struct stokes_carry *c, const struct stokes *s, int axis) {
    const int n = c->n = s->cells->n;
    c->p[axis] = memory_renew(MEMORY_FLUID, c->p[axis], (size_t)n + 1, sizeof *c->p[axis]);
    c->u[axis] = memory_renew(MEMORY_FLUID, c->u[axis], (size_t)n + 1, sizeof *c->u[axis]);
    for (int i = 0; i < n; i++) {
        c->p[axis][i] = (float)s->p[i];
        for (int d = 0; d < 3; d++) c->u[axis][i][d] = (float)s->u[i][d];
    }
}

void stokes_carry_end(struct stokes_carry *c, struct stokes *s) {
    if (s->cells) {
        c->first = memory_copy(MEMORY_FLUID, s->cells->first, (size_t)par_size() + 1, sizeof *c->first);
        c->mask = s->mask;
        s->mask = NULL;
    }
    stokes_free(s);
}

/* The records of this rank's earlier cells that are pore now, and the ranks that they go to; returns how many. */
static int collect(const struct stokes_carry *c, const struct stokes *s, int axis, struct record *record, int *dest) {
    int at[3], n = 0;
    if (c->n > 0) stokes_mask_find(c->mask, c->first[par_rank()], at);
    for (int i = 0; i < c->n; i++) {
        if (i > 0) stokes_mask_next(c->mask, at);
        if (!stokes_mask_is(s->mask, at[0], at[1], at[2])) continue;
        const float *u = c->u[axis][i];
        record[n] =
            (struct record){stokes_mask_number(s->mask, at[0], at[1], at[2]), c->p[axis][i], {u[0], u[1], u[2]}};
        dest[n] = (int)sort_find(s->cells->first, par_size(), record[n].number);
        n++;
    }
    return n;
}

/* Brings the records to their cells: known is 1 there. Returns how many cells of all ranks have one. Collective. */
static long bring(const struct stokes_carry *c, struct stokes *s, int axis, float *known) {
    struct record *mine = memory_new(MEMORY_FLUID, (size_t)c->n + 1, sizeof *mine);
    int *dest = memory_new(MEMORY_FLUID, (size_t)c->n + 1, sizeof *dest);
    struct par_exchange *x = par_exchange_new(collect(c, s, axis, mine, dest), dest);
    const int served = par_exchange_count(x);
    struct record *here = memory_new(MEMORY_FLUID, (size_t)served + 1, sizeof *here);
    par_exchange_forward(x, mine, here, sizeof *mine);
    for (int k = 0; k < served; k++) {
        const long i = here[k].number - s->cells->first[par_rank()];
        known[i] = 1;
        s->p[i] = (double)here[k].p;
        for (int d = 0; d < 3; d++)
            if (stokes_faces_is_open(s->faces, (int)i, d)) s->u[i][d] = (double)here[k].u[d];
    }
    par_exchange_free(x);
    MEMORY_FREE(here, dest, mine);
    return par_sum_long(served);
}

/* Cells beside known ones get the mean of their pressures; `next` [n] is which are known then. Returns how many there
 * were. */
static long continue_once(struct stokes *s, const float *known, float *next) {
    const struct stokes_cells *c = s->cells;
    long more = 0;
    for (int i = 0; i < c->n; i++) {
        double sum = 0, weight = 0;
        next[i] = known[i];
        if (known[i] > 0) continue;
        for (int q = 0; q < 6; q++) {
            const int beside = c->next[i][q];
            sum += (double)known[beside] * s->p[beside];
            weight += (double)known[beside];
        }
        if (weight == 0) continue;
        s->p[i] = sum / weight;
        next[i] = 1;
        more++;
    }
    return more;
}

/* Continues the pressure to cells that were solid. known [size], what the ghosts hold is not used. Collective. */
static void continue_pressure(struct stokes *s, float *known) {
    const struct stokes_cells *c = s->cells;
    float *next = memory_new(MEMORY_FLUID, (size_t)c->n + 1, sizeof *next);
    for (int k = 0; k < c->outside; k++) {
        known[c->of_outside[k]] = 1;
        s->p[c->of_outside[k]] = 0;
    }
    for (int reach = 0; reach < REACH_MAX; reach++) {
        stokes_cells_fill(c, sizeof *known, known);
        stokes_cells_fill(c, sizeof *s->p, s->p);
        const long more = continue_once(s, known, next);
        memcpy(known, next, (size_t)c->n * sizeof *known);
        if (par_sum_long(more) == 0) break;
    }
    memory_free(next);
}

int stokes_carry_set(const struct stokes_carry *c, struct stokes *s, int axis) {
    const size_t size = stokes_cells_size(s->cells);
    int fits = c && c->mask && c->p[axis] && s->mask;
    for (int d = 0; d < 3; d++) fits = fits && c->mask->n[d] == s->mask->n[d];
    if (!fits) return 0;
    float *known = memory_new(MEMORY_FLUID, size, sizeof *known);
    memset(s->u, 0, size * sizeof *s->u);
    memset(s->p, 0, size * sizeof *s->p);
    const long all = s->cells->first[par_size()], brought = bring(c, s, axis, known);
    const int enough = (double)brought >= LEAST * (double)all;
    if (enough) {
        continue_pressure(s, known);
        stokes_cells_fill(s->cells, sizeof *s->p, s->p);
        stokes_cells_fill(s->cells, sizeof *s->u, s->u);
    }
    memory_free(known);
    return enough;
}
