/* Divides the global particle ids over the ranks by work, and finds a particle's local index. */
#include "solid/body/number.h"
#include "base/par.h"

#include <stdlib.h>

/* cost of a particle of the list store in a sweep, in units of a particle of a full row */
enum { LIST_COST = 4 };

/* Walks over the indivisible units (rows, points) in the order of the ids. */
static long cost_of(const struct solid_sites *sites, long unit, int general_bonds) {
    if (!sites->is_lattice) return LIST_COST;
    return general_bonds ? LIST_COST * __builtin_popcount(sites->bits[sites->order[unit]]) : SOLID_ROW;
}

static long id_of(const struct solid_sites *sites, long unit) {
    return sites->is_lattice ? sites->start[sites->order[unit]] : sites->first + unit;
}

static long units(const struct solid_sites *t) { return t->is_lattice ? t->filled : t->count; }

void solid_number_divide(struct solid_sites *const *sites, int bodies, int general_bonds, long *first) {
    const int size = par_size();
    long total = 0, sum = 0, n = 0;
    for (int b = 0; b < bodies; b++) {
        for (long u = 0; u < units(sites[b]); u++) total += cost_of(sites[b], u, general_bonds);
        n += sites[b]->count;
    }
    int rank = 0;
    for (int b = 0; b < bodies; b++)
        for (long u = 0; u < units(sites[b]); u++) {
            while (rank < size && (double)sum * size >= (double)total * rank) first[rank++] = id_of(sites[b], u);
            sum += cost_of(sites[b], u, general_bonds);
        }
    while (rank <= size) first[rank++] = n;
}

static int ascending(const void *a, const void *b) {
    const long x = *(const long *)a, y = *(const long *)b;
    return x < y ? -1 : x > y;
}

int solid_number_unique(long *id, long n) {
    long kept = 0;
    if (n > 0) qsort(id, (size_t)n, sizeof *id, ascending);
    for (long i = 0; i < n; i++)
        if (i == 0 || id[i] != id[i - 1]) id[kept++] = id[i];
    return (int)kept;
}

int solid_number_local(const struct solid_numbering *numbering, long id) {
    if (id >= numbering->from && id < numbering->to) return (int)(id - numbering->from);
    long low = 0, high = numbering->ghosts - 1;
    while (low <= high) {
        const long middle = (low + high) / 2;
        if (numbering->ghost_id[middle] == id) return (int)(numbering->to - numbering->from + middle);
        if (numbering->ghost_id[middle] < id)
            low = middle + 1;
        else
            high = middle - 1;
    }
    return -1;
}
