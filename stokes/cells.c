/* Finds the pore cells of a rank and their neighbours. */
#include "stokes/cells.h"
#include "base/memory.h"
#include "base/par.h"
#include "base/sort.h"

/* Cells of other ranks that were met, each as often as it was. */
struct met {
    int n, capacity;
    long *number;
};

static int meet(struct met *met, long number) {
    MEMORY_MORE(MEMORY_FLUID, met->number, met->n, met->capacity);
    met->number[met->n] = number;
    return met->n++;
}

/* The place of the neighbour; one of another rank: -1 - its place in the list. */
static int place_of(struct stokes_cells *c, struct met *met, const int at[3], int direction) {
    const struct stokes_mask *m = c->g->mask;
    int to[3] = {at[0], at[1], at[2]}, wraps;
    if (stokes_grid_step(c->g, to, direction, &wraps) != STOKES_BEYOND_NONE || !stokes_mask_is(m, to[0], to[1], to[2]))
        return -1;
    const long number = stokes_mask_number(m, to[0], to[1], to[2]), own = number - c->first[par_rank()];
    return own >= 0 && own < c->n ? (int)own : -2 - meet(met, number);
}

/* Numbers the ghosts, and sets their places. */
static void place_ghosts(struct stokes_cells *c, struct met *met) {
    long *sorted = memory_copy(MEMORY_FLUID, met->number, (size_t)met->n, sizeof *sorted);
    c->ghosts = (int)sort_unique(sorted, met->n);
    for (long q = 0; q < 6L * c->n; q++) {
        int *to = &c->next[q / 6][q % 6];
        if (*to == -1) *to = c->n + c->ghosts;
        if (*to < -1) *to = c->n + (int)sort_find(sorted, c->ghosts, met->number[-2 - *to]);
    }
    c->ghost = par_ghost_new(c->first, c->ghosts, sorted);
    MEMORY_FREE(sorted, met->number);
}

static void add_outside(struct stokes_cells *c, int i) {
    const size_t n = (size_t)c->outside;
    if ((n & (n - 1)) == 0) c->of_outside = memory_grown(MEMORY_FLUID, c->of_outside, n, 2 * n + 1, sizeof(int));
    c->of_outside[c->outside++] = i;
}

struct stokes_cells *stokes_cells_new(const struct stokes_grid *g) {
    const struct stokes_mask *m = g->mask;
    const long all = m->before[(long)m->n[1] * m->n[2]];
    const int size = par_size();
    struct stokes_cells *c = memory_new(MEMORY_FLUID, 1, sizeof *c);
    struct met met = {0};
    int at[3];
    c->g = g;
    c->first = memory_new(MEMORY_FLUID, (size_t)size + 1, sizeof *c->first);
    for (int r = 0; r <= size; r++) c->first[r] = (long)((double)all / size * r);
    c->first[size] = all;
    c->n = (int)(c->first[par_rank() + 1] - c->first[par_rank()]);
    c->next = memory_new(MEMORY_FLUID, (size_t)c->n + 1, sizeof *c->next);
    if (c->n > 0) stokes_mask_find(m, c->first[par_rank()], at);
    for (int i = 0; i < c->n; i++) {
        if (i > 0) stokes_mask_next(m, at);
        for (int q = 0; q < 6; q++) c->next[i][q] = place_of(c, &met, at, q);
        if (stokes_grid_is_outside(g, at)) add_outside(c, i);
    }
    place_ghosts(c, &met);
    return c;
}

void stokes_cells_free(struct stokes_cells *c) {
    if (!c) return;
    par_ghost_free(c->ghost);
    MEMORY_FREE(c->first, c->next, c->of_outside, c);
}

void stokes_cells_fill(const struct stokes_cells *c, size_t bytes, void *record) {
    par_ghost_update_records(c->ghost, bytes, record, c->n);
}
