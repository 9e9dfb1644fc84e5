/* Moves the force that markers keep between markers and particles, for checkpoints, rejected steps and new markers. */
#include "coupling/interface/marker_force.h"
#include "base/memory.h"

#include <string.h>

int marker_force_is_kept(const struct run *r) { return r->ibm && ibm_marker_force_is_kept(r->ibm); }

void marker_force_by_particle(struct run *r, double (*all)[3]) {
    const size_t bytes = (size_t)r->solid->n * sizeof *all;
    if (r->marker_force) {
        memcpy(all, r->marker_force, bytes);
        return;
    }
    memset(all, 0, bytes);
    if (!ibm_marker_force_is_set(r->ibm)) return;
    ibm_marker_force_get(r->ibm, r->markers.force);
    for (int i = 0; i < r->markers.n; i++)
        for (int c = 0; c < 3; c++) all[r->surface->h[i]][c] = r->markers.force[c][i];
}

/* In the order of the markers. */
static const double *const *by_marker(struct run *r, const double (*all)[3]) {
    for (int i = 0; i < r->markers.n; i++)
        for (int c = 0; c < 3; c++) r->markers.force[c][i] = all[r->surface->h[i]][c];
    return (const double *const *)r->markers.force;
}

void marker_force_from_particles(struct run *r, const double (*all)[3]) {
    const int at_rest = r->scene->stage[r->stage].solid == SCENE_SOLID_RIGID;
    if (at_rest && ibm_marker_force_is_set(r->ibm)) {
        ibm_marker_force_set(r->ibm, by_marker(r, all));
        return;
    }
    if (!r->marker_force)
        r->marker_force = memory_new(MEMORY_COUPLING, (size_t)r->solid->n + 1, sizeof *r->marker_force);
    memcpy(r->marker_force, all, (size_t)r->solid->n * sizeof *all);
}

void marker_force_assign(struct run *r) {
    if (!r->marker_force) return;
    ibm_marker_force_set_next(r->ibm, r->markers.n, by_marker(r, (const double(*)[3])r->marker_force));
    memory_free(r->marker_force);
    r->marker_force = NULL;
}

void marker_force_hold(struct run *r) {
    if (!r->load_kind->keeps_force) return;
    double(*all)[3] = memory_new(MEMORY_COUPLING, (size_t)r->solid->n + 1, sizeof *all);
    marker_force_by_particle(r, all);
    for (int i = 0; i < r->surface->n; i++)
        for (int c = 0; c < 3 && r->surface->two_sided[i] == SOLID_ISOLATED; c++) all[r->surface->h[i]][c] = 0;
    r->marker_force = all;
}
