/* Connected pieces of pores, and the ways through them. */
#include "stokes/pieces.h"
#include "base/memory.h"
#include "base/par.h"

#include <stdlib.h>
#include <string.h>

/* A forest of items. An item's parent is in the period that is `periods` away from its own. A root has the axes along
 * which a way through its tree returns in another period, as bits. */
struct tree {
    long parent;
    int periods[3], axes;
};

/* The root; periods: from the item to it. Items on the way become its children. */
static long root_of(struct tree *t, long i, int periods[3]) {
    long root = i;
    memset(periods, 0, 3 * sizeof *periods);
    while (t[root].parent != root) {
        for (int c = 0; c < 3; c++) periods[c] += t[root].periods[c];
        root = t[root].parent;
    }
    int left[3] = {periods[0], periods[1], periods[2]};
    while (t[i].parent != root && i != root) {
        const long up = t[i].parent;
        for (int c = 0; c < 3; c++) {
            const int step = t[i].periods[c];
            t[i].periods[c] = left[c];
            left[c] -= step;
        }
        t[i].parent = root;
        i = up;
    }
    return root;
}

/* Item b is next to a, in the period that is `periods` away from a's. */
static void join(struct tree *t, long a, long b, const int periods[3]) {
    int from_a[3], from_b[3];
    const long root_a = root_of(t, a, from_a), root_b = root_of(t, b, from_b);
    for (int c = 0; c < 3; c++) from_a[c] -= periods[c] + from_b[c]; /* from b's root to a's */
    if (root_a == root_b) {
        for (int c = 0; c < 3; c++) t[root_a].axes |= (from_a[c] != 0) << c;
        return;
    }
    t[root_b].parent = root_a;
    t[root_a].axes |= t[root_b].axes;
    memcpy(t[root_b].periods, from_a, sizeof from_a);
}

static struct tree *trees_new(long n) {
    struct tree *t = memory_new(MEMORY_FLUID, (size_t)n + 1, sizeof *t);
    for (long i = 0; i < n; i++) t[i].parent = i;
    return t;
}

/* The joints between pieces of several ranks. */
struct joint {
    long a, b;
    int periods[3], axes; /* the axes of a */
};

struct joints {
    struct joint *joint;
    long n, capacity;
};

static void add(struct joints *j, const struct joint *one) {
    if (j->n > 0 && !memcmp(&j->joint[j->n - 1], one, sizeof *one)) return;
    MEMORY_MORE(MEMORY_FLUID, j->joint, j->n, j->capacity);
    j->joint[j->n++] = *one;
}

static int order(const void *a, const void *b) { return memcmp(a, b, sizeof(struct joint)); }

/* Joins this rank's cells. */
static void join_own(const struct stokes_cells *cells, struct tree *t) {
    const struct stokes_grid *g = cells->g;
    int at[3];
    if (cells->n > 0) stokes_mask_find(g->mask, cells->first[par_rank()], at);
    for (int i = 0; i < cells->n; i++) {
        if (i > 0) stokes_mask_next(g->mask, at);
        for (int c = 0; c < 3; c++) {
            int to[3] = {at[0], at[1], at[2]}, wraps, periods[3] = {0};
            if (cells->next[i][2 * c + 1] >= cells->n) continue;
            stokes_grid_step(g, to, 2 * c + 1, &wraps);
            periods[c] = wraps;
            join(t, i, cells->next[i][2 * c + 1], periods);
        }
    }
}

/* Joins the cells in layers of given pressure to item n, which stands for the outside and stays a root. */
static void join_outside(const struct stokes_cells *cells, struct tree *t) {
    const struct stokes_grid *g = cells->g;
    int at[3];
    for (int k = 0; k < cells->outside; k++) {
        int periods[3] = {0};
        stokes_mask_find(g->mask, cells->first[par_rank()] + cells->of_outside[k], at);
        periods[g->axis] = at[g->axis] == 0;
        join(t, cells->n, cells->of_outside[k], periods);
    }
}

/* A cell of another rank: its piece, and the periods from the cell to the piece's root. */
struct cell_piece {
    long piece;
    int periods[3], unused;
};

/* The joints of this rank's pieces with those of other ranks' cells. */
static struct joints joints_of(const struct stokes_cells *cells, const struct cell_piece *cell) {
    const struct stokes_grid *g = cells->g;
    struct joints j = {0};
    int at[3];
    if (cells->n > 0) stokes_mask_find(g->mask, cells->first[par_rank()], at);
    for (int i = 0; i < cells->n; i++) {
        if (i > 0) stokes_mask_next(g->mask, at);
        for (int q = 0; q < 6; q++) {
            const int next = cells->next[i][q];
            int to[3] = {at[0], at[1], at[2]}, wraps;
            if (next < cells->n || next == cells->n + cells->ghosts) continue;
            stokes_grid_step(g, to, q, &wraps);
            struct joint one;
            memset(&one, 0, sizeof one);
            one.a = cell[i].piece;
            one.b = cell[next].piece;
            for (int c = 0; c < 3; c++)
                one.periods[c] = (c == q / 2 ? wraps : 0) - cell[i].periods[c] + cell[next].periods[c];
            add(&j, &one);
        }
    }
    return j;
}

/* Unites the pieces of all ranks: trees over them, of which rank 0's outside is item 0. */
static struct tree *unite(struct joints *j, long pieces) {
    size_t bytes;
    long n = 0;
    if (j->n > 0) qsort(j->joint, (size_t)j->n, sizeof *j->joint, order);
    for (long k = 0; k < j->n; k++)
        if (n == 0 || memcmp(&j->joint[k], &j->joint[n - 1], sizeof *j->joint)) j->joint[n++] = j->joint[k];
    struct joint none = {0}, *all = par_all_gather_any(n ? j->joint : &none, (size_t)n * sizeof *j->joint, &bytes);
    struct tree *t = trees_new(pieces);
    for (size_t k = 0; k < bytes / sizeof *all; k++) {
        int away[3];
        t[root_of(t, all[k].a, away)].axes |= all[k].axes;
        join(t, all[k].a, all[k].b, all[k].periods);
    }
    free(all);
    return t;
}

struct stokes_pieces *stokes_pieces_new(const struct stokes_cells *cells) {
    struct stokes_pieces *p = memory_new(MEMORY_FLUID, 1, sizeof *p);
    struct tree *own = trees_new(cells->n + 1L);
    long count = 1, *number = memory_new(MEMORY_FLUID, (size_t)cells->n + 1, sizeof *number);
    int away[3];
    join_own(cells, own);
    join_outside(cells, own);
    for (long i = 0; i < cells->n; i++)
        if (own[i].parent == i) number[i] = count++;
    const long before = par_sum_before(count), pieces = par_sum_long(count); /* each rank's outside is its first */
    struct cell_piece *cell = memory_new(MEMORY_FLUID, stokes_cells_size(cells), sizeof *cell);
    for (int i = 0; i < cells->n; i++) cell[i].piece = before + number[root_of(own, i, cell[i].periods)];
    stokes_cells_fill(cells, sizeof *cell, cell);
    struct joints j = joints_of(cells, cell);
    struct joint one;
    for (long i = 0; i <= cells->n; i++)
        if (own[i].parent == i) {
            memset(&one, 0, sizeof one);
            one.a = one.b = before + number[i];
            one.axes = own[i].axes;
            if (one.axes) add(&j, &one);
        }
    memset(&one, 0, sizeof one);
    one.b = before; /* the outside is the same for all ranks */
    add(&j, &one);
    struct tree *all = unite(&j, pieces);
    p->stays = memory_new(MEMORY_FLUID, (size_t)cells->n + 1, 1);
    for (int i = 0; i < cells->n; i++) {
        const int axes = all[root_of(all, cell[i].piece, away)].axes;
        p->stays[i] = axes != 0;
        p->cells += axes != 0;
    }
    for (long q = 0; q < pieces; q++) {
        const long root = root_of(all, q, away);
        if (root == q) p->all++;
        p->through += root == q && all[q].axes;
        for (int c = 0; c < 3; c++) p->percolates[c] |= all[root].axes >> c & 1;
    }
    if (cells->g->axis < 0) p->all--; /* the outside, which touches nothing */
    p->cells = par_sum_long(p->cells);
    MEMORY_FREE(j.joint, cell, number, own, all);
    return p;
}

void stokes_pieces_free(struct stokes_pieces *p) {
    if (!p) return;
    MEMORY_FREE(p->stays, p);
}
