/* Divides the global particle ids over the ranks by work, and finds a particle's local index. */
#include "solid/body/bricks.h"
#include "solid/body/number.h"
#include "base/par.h"
#include "base/sort.h"

/* cost of a particle of the list store in a sweep, in units of a particle of a full row */
enum { LIST_COST = 4 };

/* Ids and cost of the indivisible units (rows, points) in turn. */
struct units {
    const struct solid_sites *sites;
    struct solid_bricks_walk walk;
    long point, id, cost;
};

static int next_unit(struct units *u, int general_bonds) {
    const struct solid_sites *sites = u->sites;
    if (!sites->is_lattice) {
        u->id = sites->first + u->point;
        u->cost = LIST_COST;
        return u->point++ < sites->count;
    }
    if (!solid_bricks_next(sites, &u->walk)) return 0;
    u->id = u->walk.id;
    u->cost = general_bonds ? LIST_COST * __builtin_popcount(u->walk.bits) : SOLID_ROW;
    return 1;
}

void solid_number_divide(struct solid_sites *const *sites, int bodies, int general_bonds, long *first) {
    const int size = par_size();
    long total = 0, sum = 0, n = 0;
    for (int b = 0; b < bodies; b++) {
        for (struct units u = {.sites = sites[b]}; next_unit(&u, general_bonds);) total += u.cost;
        n += sites[b]->count;
    }
    int rank = 0;
    for (int b = 0; b < bodies; b++)
        for (struct units u = {.sites = sites[b]}; next_unit(&u, general_bonds);) {
            while (rank < size && (double)sum * size >= (double)total * rank) first[rank++] = u.id;
            sum += u.cost;
        }
    while (rank <= size) first[rank++] = n;
}

int solid_number_local(const struct solid_numbering *numbering, long id) {
    if (id >= numbering->from && id < numbering->to) return (int)(id - numbering->from);
    const long at = sort_find(numbering->ghost_id, numbering->ghosts, id);
    if (numbering->ghosts == 0 || numbering->ghost_id[at] != id) return -1;
    return (int)(numbering->to - numbering->from + at);
}
