/* Makes a body's cloud from a refinement plan, and assigns the new particles to ranks. */
#include "base/memory.h"
#include "base/par.h"
#include "solid/refine/parts.h"

#include <math.h>

static int rank_of(const struct solid *s, long id) {
    int rank = 0;
    while (s->first[rank + 1] <= id) rank++;
    return rank;
}

/* The rank of the plan's i-th particle, a new one: the owner of its first parent. rank: [new particles before it] */
static int rank_of_interpolated(const struct solid *s, const struct solid_refine_plan *p, long i, const int *rank) {
    const struct solid_refine_interpolated *b = &p->interpolated[i - p->before];
    long first = b->parent[0];
    for (int k = 1; k < b->parents; k++) first = b->parent[k] < first ? b->parent[k] : first;
    return first < p->before ? rank_of(s, p->cloud->first + first) : rank[first - p->before];
}

/* The plan's numbers in the order of the new cloud. */
static long *order_of(const struct solid *s, const struct solid_refine_plan *p, long *count) {
    const long interpolated = p->n - p->before;
    const int size = par_size();
    long *was = memory_new(MEMORY_SOLID, (size_t)p->n + 1, sizeof *was);
    long *at = memory_new(MEMORY_SOLID, (size_t)size + 1, sizeof *at);
    int *rank = memory_new(MEMORY_SOLID, (size_t)interpolated + 1, sizeof *rank);
    long n = 0, old = 0;
    for (long i = 0; i < interpolated; i++) at[(rank[i] = rank_of_interpolated(s, p, p->before + i, rank)) + 1]++;
    for (int r = 0; r < size; r++) {
        const long start = n, fresh = at[r + 1];
        for (; old < p->before && p->cloud->first + old < s->first[r + 1]; old++) was[n++] = old;
        at[r] = n;
        n += fresh;
        count[r] += n - start;
    }
    for (long i = 0; i < interpolated; i++) was[at[rank[i]]++] = p->before + i;
    MEMORY_FREE(at, rank);
    return was;
}

struct solid_cloud *solid_refine_cloud(const struct solid *s, int body, const struct solid_refine_plan *p, long first,
                                       long **was, long *count) {
    const struct solid_cloud *t = p->cloud;
    const size_t n = (size_t)p->n + 1;
    double *arrays[5], *volume = memory_new(MEMORY_SOLID, n, sizeof *volume);
    const int is_lattice = solid_refine_plan_is_possible(s, body);
    for (int k = 0; k < 5; k++) arrays[k] = memory_new(MEMORY_SOLID, n, sizeof **arrays);
    *was = order_of(s, p, count);
    for (long i = 0; i < p->before; i++) volume[i] = t->volume[i];
    if (p->refined > 0) {
        struct solid_refine_cells *cells = &s->refine->cells[body];
        if (!cells->area) solid_refine_area_new(cells, t);
        solid_refine_area(p, cells, volume);
    }
    for (long k = 0; k < p->n; k++) {
        const long i = (*was)[k];
        for (int c = 0; c < 2; c++)
            arrays[c][k] = i < p->before ? t->place[c][i] : (double)p->at[i][c] / SOLID_REFINE_UNIT;
        arrays[2][k] = is_lattice ? ldexp(1, -p->level[i]) : t->size[i];
        arrays[3][k] = is_lattice ? solid_refine_plan_horizon(p, i) : t->horizon[i];
        arrays[4][k] = volume[i];
    }
    struct solid_cloud_input in = {.name = t->name,
                                   .n = p->n,
                                   .first = first,
                                   .spacing = t->spacing,
                                   .thickness = s->in.thickness,
                                   .place = {arrays[0], arrays[1]},
                                   .size = arrays[2],
                                   .horizon = arrays[3],
                                   .volume = arrays[4],
                                   .law = t->law};
    for (int c = 0; c < 2; c++) {
        in.origin[c] = t->origin[c];
        in.period[c] = t->period[c] * t->spacing;
    }
    struct solid_cloud *cloud = solid_cloud_new(&in);
    for (int k = 0; k < 5; k++) memory_free(arrays[k]);
    memory_free(volume);
    return cloud;
}
