/* Moves the implicit forcing's starting guess between markers and particles, for checkpoints and rejected steps. */
#include "coupling/interface/forcing_guess.h"
#include "base/memory.h"

#include <string.h>

int forcing_guess_is_part_of(const struct run *r) { return r->ibm && ibm_demand_is_kept(r->ibm); }

void forcing_guess_take(struct run *r, double (*all)[3]) {
    const size_t bytes = (size_t)r->solid->n * sizeof *all;
    if (r->demand) {
        memcpy(all, r->demand, bytes);
        return;
    }
    memset(all, 0, bytes);
    if (!ibm_demand_is_set(r->ibm)) return;
    ibm_demand(r->ibm, r->markers.force);
    for (int i = 0; i < r->markers.n; i++)
        for (int c = 0; c < 3; c++) all[r->surface->h[i]][c] = r->markers.force[c][i];
}

/* In the order of the markers. */
static const double *const *by_marker(struct run *r, const double (*all)[3]) {
    for (int i = 0; i < r->markers.n; i++)
        for (int c = 0; c < 3; c++) r->markers.force[c][i] = all[r->surface->h[i]][c];
    return (const double *const *)r->markers.force;
}

void forcing_guess_put(struct run *r, const double (*all)[3]) {
    const int at_rest = r->scene->stage[r->stage].solid == SCENE_SOLID_RIGID;
    if (at_rest && ibm_demand_is_set(r->ibm)) {
        ibm_demand_set(r->ibm, by_marker(r, all));
        return;
    }
    if (!r->demand) r->demand = memory_new(MEMORY_COUPLING, (size_t)r->solid->n + 1, sizeof *r->demand);
    memcpy(r->demand, all, (size_t)r->solid->n * sizeof *all);
}

void forcing_guess_hand_on(struct run *r) {
    if (!r->demand) return;
    ibm_demand_set_next(r->ibm, r->markers.n, by_marker(r, (const double(*)[3])r->demand));
    memory_free(r->demand);
    r->demand = NULL;
}

void forcing_guess_keep(struct run *r) {
    if (!r->load_kind->keeps_force) return;
    double(*all)[3] = memory_new(MEMORY_COUPLING, (size_t)r->solid->n + 1, sizeof *all);
    forcing_guess_take(r, all);
    for (int i = 0; i < r->surface->n; i++)
        for (int c = 0; c < 3 && r->surface->two_sided[i] == SOLID_SET_FREE; c++) all[r->surface->h[i]][c] = 0;
    r->demand = all;
}

static void make(void *keep, void *owner) {
    double(**demand)[3] = keep;
    *demand = memory_new(MEMORY_OUTPUT, (size_t)((struct run *)owner)->solid->n + 1, sizeof **demand);
}

static void take(void *keep, void *owner) { forcing_guess_take(owner, *(double(**)[3])keep); }
static void restore(void *keep, void *owner) { forcing_guess_put(owner, (const double(*)[3]) * (double(**)[3])keep); }
static void drop(void *keep) { memory_free(*(double(**)[3])keep); }

const struct state_kept forcing_guess_kept = {make, take, restore, drop};
