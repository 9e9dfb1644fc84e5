/* Stores a refined body's particles in a checkpoint, and restores the solid to them. */
#include "base/memory.h"
#include "base/par.h"
#include "base/par_ghost.h"
#include "solid/bonds/cut_bonds.h"
#include "solid/bonds/ghosts.h"
#include "solid/bonds/list.h"
#include "solid/build.h"
#include "solid/contact/contact.h"
#include "solid/force/dilatation.h"
#include "solid/imposed/constraint.h"
#include "solid/imposed/external_loads.h"
#include "solid/refine/parts.h"

#include <math.h>
#include <string.h>

void solid_refine_restore_save(const struct solid *s, int h, uint8_t *level, double place[3]) {
    const struct solid_cloud *cloud = s->family->cloud[s->body[h]];
    const long i = s->first[par_rank()] + h - cloud->first;
    *level = (uint8_t)solid_refine_level(s, h);
    for (int c = 0; c < 2; c++) place[c] = cloud->place[c][i];
    place[2] = cloud->volume[i];
}

/* A cloud of the particles from .. to-1, with the properties of the present cloud. horizon: NULL: found from the
 * positions of all. */
static struct solid_cloud *cloud_of(const struct solid *s, const struct solid_cloud *t, long from, long to,
                                    const uint8_t *level, const double (*place)[3], const double *horizon) {
    const size_t n = (size_t)(to - from) + 1;
    double *arrays[4];
    for (int k = 0; k < 4; k++) arrays[k] = memory_new(MEMORY_SOLID, n, sizeof **arrays);
    for (long i = from; i < to; i++) {
        for (int c = 0; c < 3; c++) arrays[c][i - from] = place[i][c];
        arrays[3][i - from] = ldexp(1, -level[i]);
    }
    struct solid_cloud_input in = {.name = t->name,
                                   .n = to - from,
                                   .first = from,
                                   .spacing = t->spacing,
                                   .thickness = s->in.thickness,
                                   .place = {arrays[0], arrays[1]},
                                   .volume = arrays[2],
                                   .size = arrays[3],
                                   .horizon = horizon,
                                   .law = t->law};
    for (int c = 0; c < 2; c++) {
        in.origin[c] = t->origin[c];
        in.period[c] = t->period[c] * t->spacing;
    }
    struct solid_cloud *cloud = solid_cloud_new(&in);
    for (int k = 0; k < 4; k++) memory_free(arrays[k]);
    return cloud;
}

/* Replaces the body's cloud. */
static void cloud_replace(struct solid *s, int b, long from, long to, const uint8_t *level, const double (*place)[3]) {
    struct solid_cloud **cloud = &s->family->cloud[b], *was = *cloud;
    struct solid_refine_cells *cells = &s->refine->cells[b];
    if (!cells->area) solid_refine_area_new(cells, was);
    *cloud = cloud_of(s, was, from, to, level, place, NULL);
    struct solid_refine_plan *plan = solid_refine_plan_of(s, b, NULL);
    double *horizon = memory_new(MEMORY_SOLID, (size_t)(to - from) + 1, sizeof *horizon);
    for (long i = 0; i < to - from; i++) horizon[i] = solid_refine_plan_horizon(plan, i);
    solid_refine_plan_free(plan);
    solid_cloud_free(*cloud);
    *cloud = cloud_of(s, was, from, to, level, place, horizon);
    memory_free(horizon);
    solid_cloud_free(was);
}

/* Whether the particles are in the order of the bodies, and sorted within each. first [bodies + 1] */
static int fits(const struct solid *s, long n, const uint8_t *body, const uint8_t *level, const double (*place)[3],
                long *first) {
    for (long i = 0; i < n; i++) {
        if (body[i] >= s->in.bodies || (i > 0 && body[i] < body[i - 1]) || level[i] > s->refine->in.levels ||
            !(place[i][2] > 0))
            return 0;
        first[body[i] + 1] = i + 1;
    }
    for (int b = 0; b < s->in.bodies; b++) {
        const struct solid_cloud *cloud = s->family->cloud[b];
        if (first[b + 1] <= first[b] || (!solid_refine_plan_is_possible(s, b) && first[b + 1] - first[b] != cloud->n))
            return 0;
        for (long i = first[b]; i < first[b + 1]; i++)
            for (int c = 0; c < 2; c++)
                if (!(place[i][c] > cloud->cells.low[c] - 2 &&
                      place[i][c] < cloud->cells.low[c] + cloud->cells.cells[c] * cloud->cells.width + 2))
                    return 0;
    }
    return 1;
}

static void lists_new(struct solid *s) {
    struct solid_family *f = s->family;
    const long from = s->first[par_rank()], to = s->first[par_rank() + 1];
    for (int b = 0; b < f->bodies; b++) {
        solid_list_free(f->list[b]);
        f->list[b] = solid_list_find_new(f->cloud[b], NULL, 0, from, to, f->first[b]);
        f->first[b + 1] = f->first[b] + f->list[b]->n;
    }
    solid_refine_apply_reserve(s, (int)(to - from));
    s->n = (int)(to - from);
}

int solid_refine_restore(struct solid *s, long n, const uint8_t *body, const uint8_t *level, const double (*place)[3]) {
    const int size = par_size();
    long *first = memory_new(MEMORY_SOLID, (size_t)s->in.bodies + 1, sizeof *first);
    const int good = s->refine && fits(s, n, body, level, place, first);
    for (int b = 0; good && b < s->in.bodies; b++)
        if (solid_refine_plan_is_possible(s, b)) cloud_replace(s, b, first[b], first[b + 1], level, place);
    memory_free(first);
    if (!good) return 1;
    solid_contact_free(s);
    for (int r = 0; r <= size; r++) s->first[r] = n * r / size;
    s->n_global = n;
    lists_new(s);
    par_ghost_free(s->ghost);
    solid_build_ghosts(s, NULL, s->family->cloud);
    solid_refine_apply_reserve(s, s->n + s->n_ghost);
    for (int c = 0; c < 2; c++)
        for (int h = 0; h < s->n; h++)
            s->d[c][h] = s->v[c][h] = s->a[c][h] = s->load[c][h] = s->v_old[c][h] = s->a_old[c][h] = 0;
    memset(s->flag, 0, (size_t)s->n);
    for (int h = 0; s->fragment && h < s->n; h++) s->fragment[h] = -1;
    solid_build_places(s, NULL, s->family->cloud);
    solid_dilatation_renew(s);
    solid_cut_bonds(s, s->family->cloud);
    solid_build_edges(s);
    solid_external_loads_free(s->external_loads);
    s->external_loads = NULL;
    solid_external_loads_new(s, NULL, solid_refine_area_lengths);
    solid_constraint_flags(s);
    par_ghost_update_bytes(s->ghost, s->flag, s->n);
    solid_ghosts_update(s);
    solid_build_counts(s);
    s->a_holds = 0;
    s->refine->events++;
    return 0;
}
