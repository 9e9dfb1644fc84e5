/* Solves creeping flow through the present pores of the medium's box. */
#include "coupling/medium/intrinsic.h"
#include "base/memory.h"
#include "coupling/medium/parts.h"
#include "stokes/carry.h"
#include "stokes/solve.h"

#include <math.h>
#include <string.h>

#define TOLERANCE                                                                                                      \
    5e-3 /* of k, by a bound of the iteration that is some five times the error; cells leave several per cent */

struct medium_intrinsic {
    const struct medium *m;        /* borrowed */
    int first[3], n[3];            /* the cells of the box, of the domain's */
    enum stokes_side across[3][2]; /* what the box's sides are for a force across them */
    struct stokes_mask *mask;      /* the pores that the values belong to; NULL: none yet */
    struct stokes_carry *carry[3]; /* by the first axis of each problem; NULL: none */
    struct medium_intrinsic_values last;
};

/* Across the flow the box ends at a wall where the domain does, else at a plane of symmetry, as if the sample went on
 * with its mirror image. */
static enum stokes_side across_of(const struct medium_intrinsic *t, const struct fluid_input *in, int c, int high) {
    const int at_end = high ? t->first[c] + t->n[c] == t->m->g->n[c] : t->first[c] == 0;
    if (t->m->whole_period[c]) return STOKES_SIDE_PERIODIC;
    return at_end && in->side[c][high].type == FLUID_WALL ? STOKES_SIDE_WALL : STOKES_SIDE_SLIP;
}

struct medium_intrinsic *medium_intrinsic_new(const struct medium *m, const struct fluid_input *in) {
    struct medium_intrinsic *t = memory_new(MEMORY_COUPLING, 1, sizeof *t);
    t->m = m;
    for (int c = 0; c < 3; c++) {
        const double d = m->g->d[c];
        const int low = (int)ceil(m->low[c] / d - 0.5 - MEDIUM_SNAP),
                  high = (int)ceil(m->high[c] / d - 0.5 - MEDIUM_SNAP);
        t->first[c] = high > low ? low : m->first[c]; /* a box thinner than a cell may hold no centre */
        t->n[c] = high > low ? high - low : 1;
        for (int e = 0; e < 2; e++) t->across[c][e] = across_of(t, in, c, e);
    }
    return t;
}

void medium_intrinsic_reset(struct medium_intrinsic *t) {
    stokes_mask_free(t->mask);
    t->mask = NULL;
    for (int c = 0; c < 3; c++) {
        stokes_carry_free(t->carry[c]);
        t->carry[c] = NULL;
    }
}

void medium_intrinsic_free(struct medium_intrinsic *t) {
    if (!t) return;
    medium_intrinsic_reset(t);
    memory_free(t);
}

long medium_intrinsic_cells(const struct medium_intrinsic *t) { return (long)t->n[0] * t->n[1] * t->n[2]; }

/* The present pores. Each rank sets those of its cells. Collective. */
static struct stokes_mask *pores_of(const struct medium_intrinsic *t) {
    const struct fluid_grid *g = t->m->g;
    struct stokes_mask *mask = stokes_mask_new(t->n);
    int from[3], to[3];
    for (int c = 0; c < 3; c++) {
        from[c] = t->first[c] > g->lo[c] ? t->first[c] - g->lo[c] : 0;
        to[c] = t->first[c] + t->n[c] - g->lo[c] < g->m[c] ? t->first[c] + t->n[c] - g->lo[c] : g->m[c];
    }
    for (int k = from[2]; k < to[2]; k++)
        for (int j = from[1]; j < to[1]; j++)
            for (int i = from[0]; i < to[0]; i++)
                if (medium_kernels_is_pore(t->m->fraction[fluid_grid_at(g, i, j, k)]))
                    stokes_mask_set(mask, i + g->lo[0] - t->first[0], j + g->lo[1] - t->first[1],
                                    k + g->lo[2] - t->first[2]);
    stokes_mask_count(mask);
    return mask;
}

static long pores_in(const struct stokes_mask *mask) { return mask->before[(long)mask->n[1] * mask->n[2]]; }

long medium_intrinsic_pores(const struct medium_intrinsic *t) {
    struct stokes_mask *mask = pores_of(t);
    const long pores = pores_in(mask);
    stokes_mask_free(mask);
    return pores;
}

double medium_intrinsic_bytes(long pores) {
    const double kept = 3 * 4 * sizeof(float); /* u and p of three solutions */
    return (double)pores * (STOKES_BYTES + kept);
}

static int is_same(const struct stokes_mask *a, const struct stokes_mask *b) {
    return a && !memcmp(a->pore, b->pore, (size_t)a->words * (size_t)a->n[1] * (size_t)a->n[2] * sizeof *a->pore);
}

/* Called once an iteration. */
struct interrupt {
    struct signals_poll_state poll;
    enum signals_reason reason;
};

static int stops(void *with) {
    struct interrupt *h = with;
    if (h->reason == SIGNALS_NONE) h->reason = signals_poll(&h->poll);
    return h->reason != SIGNALS_NONE;
}

static struct stokes_input input_of(const struct medium_intrinsic *t, int axis, struct interrupt *interrupt) {
    struct stokes_input in = {.smooth = 1,
                              .tolerance = TOLERANCE,
                              .stops = stops,
                              .with = interrupt}; /* a moving solid is cut into cells again */
    for (int c = 0; c < 3; c++) {
        in.d[c] = t->m->g->d[c];
        for (int e = 0; e < 2; e++)
            in.side[c][e] = c == axis && !t->m->whole_period[c] ? STOKES_SIDE_PRESSURE : t->across[c][e];
    }
    return in;
}

/* 1: every cell is pore, and no side is a wall. */
static int is_free(const struct stokes_mask *mask, const struct stokes_input *in) {
    int walls = 0;
    for (int c = 0; c < 3; c++)
        for (int e = 0; e < 2; e++) walls |= in->side[c][e] == STOKES_SIDE_WALL;
    return !walls && pores_in(mask) == (long)mask->n[0] * mask->n[1] * mask->n[2];
}

/* Solves along an axis, and keeps the solution. */
static void solve(struct stokes *s, int axis, const struct stokes_carry *before, struct stokes_carry *now,
                  struct medium_intrinsic_values *v) {
    const int carried = stokes_carry_set(before, s, axis);
    const struct stokes_effort effort = carried ? stokes_solve_on(s, axis) : stokes_solve(s, axis);
    stokes_carry_keep(now, s, axis);
    v->solved++;
    v->carried += carried;
    v->iterations += effort.outer;
    v->products += effort.products;
    v->error = fmax(v->error, effort.error);
}

/* The axes from `first` on that share a problem: all periodic ones, or one alone. */
static int shares(const struct medium_intrinsic *t, int first, int axis) {
    return axis == first || (t->m->whole_period[first] && t->m->whole_period[axis]);
}

/* Solves the problem of an axis and of those that share it. */
static void solve_problem(struct medium_intrinsic *t, const struct stokes_mask *mask, int first,
                          struct interrupt *interrupt, struct medium_intrinsic_values *v) {
    const struct stokes_input in = input_of(t, first, interrupt);
    if (is_free(mask, &in)) {
        for (int c = 0; c < 3; c++)
            if (shares(t, first, c)) v->K[c][c] = INFINITY, v->percolates[c] = 1;
        return;
    }
    struct stokes *s = stokes_new(mask, &in);
    struct stokes_carry *now = stokes_carry_new();
    for (int c = first; c < 3; c++) {
        if (!shares(t, first, c)) continue;
        v->percolates[c] = s->pieces.percolates[c];
        if (v->percolates[c] && interrupt->reason == SIGNALS_NONE) solve(s, c, t->carry[first], now, v);
    }
    for (int a = 0; a < 3; a++)
        for (int b = 0; b < 3; b++)
            if (shares(t, first, a) && shares(t, first, b)) v->K[a][b] = s->tensor[a][b];
    stokes_carry_end(now, s);
    stokes_carry_free(t->carry[first]);
    t->carry[first] = now;
}

struct medium_intrinsic_values medium_intrinsic_measure(struct medium_intrinsic *t) {
    struct stokes_mask *mask = pores_of(t);
    if (is_same(t->mask, mask)) {
        stokes_mask_free(mask);
        t->last.solved = t->last.carried = 0;
        t->last.iterations = t->last.products = 0;
        return t->last;
    }
    struct medium_intrinsic_values v = {.pores = pores_in(mask)};
    v.porosity = (double)v.pores / (double)medium_intrinsic_cells(t);
    for (int i = 0; i < 9; i++) v.K[i / 3][i % 3] = NAN;
    struct interrupt interrupt = {.reason = SIGNALS_NONE};
    for (int c = 0; c < 3 && interrupt.reason == SIGNALS_NONE; c++) {
        int is_first = 1;
        for (int q = 0; q < c; q++) is_first = is_first && !shares(t, q, c);
        if (is_first) solve_problem(t, mask, c, &interrupt, &v);
    }
    if (interrupt.reason != SIGNALS_NONE) {
        stokes_mask_free(mask);
        medium_intrinsic_reset(t);
        return (struct medium_intrinsic_values){.stopped = interrupt.reason};
    }
    stokes_mask_free(t->mask);
    t->mask = mask;
    return t->last = v;
}
