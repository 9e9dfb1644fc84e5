/* Finds the interface between solid and void and updates it: members, normals, areas.  (001: sec. 3.3.7) */
#include "solid/surface/surface.h"

#include "base/clock.h"
#include "base/memory.h"
#include "base/par.h"
#include "solid/bonds/lattice.h"
#include "solid/surface/counted.h"
#include "solid/surface/normal.h"
#include "solid/surface/exact.h"
#include "solid/surface/area.h"
#include "solid/surface/lists.h"
#include "solid/bonds/broken_tracker.h"
#include "solid/surface/sector.h"
#include "solid/bonds/ghosts.h"

#include <math.h>

static int is_on(const struct solid_cones *w, unsigned open) { return open || w->isolated; }

/* Adds the cones of a particle that has lost a nearest neighbour, or updates them. */
static void add_cones(struct solid_surface *f, const struct solid_cones *w) {
    if (f->cones_of[w->h] < 0) {
        MEMORY_MORE(MEMORY_SOLID, f->cones, f->cones_used, f->cones_capacity);
        f->cones_of[w->h] = f->cones_used++;
    }
    f->cones[f->cones_of[w->h]] = *w;
}

/* Depth below the lattice's face, m. */
static double depth_of(const struct solid *s, const struct solid_surface *f, int h) {
    const struct solid_normal_data *data = &f->normal_data[h];
    const int is_counted = f->counted && !data->two_sided && data->open == f->bare[h] && f->counted[h] >= 0;
    return (is_counted ? f->counted[h] : 0.5) * s->in.spacing;
}

/* Updates entry i. */
static void renew(const struct solid *s, struct solid_surface *f, int i) {
    const struct solid_normal_data *data = &f->normal_data[f->h[i]];
    double shape[3], curvature = 0;
    const int is_shaped = solid_exact_at(f, f->h[i], shape, &f->depth[i], &curvature);
    if (!is_shaped) f->depth[i] = depth_of(s, f, f->h[i]);
    if (f->curvature) f->curvature[i] = curvature;
    for (int c = 0; c < 3; c++) f->normal[c][i] = is_shaped ? shape[c] : data->n[c];
    f->two_sided[i] = data->two_sided;
}

void solid_surface_gather(struct solid *s, struct solid_surface *f) {
    f->n = 0;
    for (int h = 0; h < s->n; h++) {
        if (!(s->flag[h] & SOLID_INTERFACE)) continue;
        const int i = f->n++;
        f->h[i] = h;
        renew(s, f, i);
        f->area[i] = s->flag[h] & SOLID_FIRST ? f->initial_area : solid_surface_area_fresh(s, h);
    }
}

static struct solid_surface *allocate(const struct solid *s) {
    const size_t n = (size_t)s->n + 1;
    struct solid_surface *f = memory_new(MEMORY_SOLID, 1, sizeof *f);
    f->capacity = s->n;
    f->h = memory_new(MEMORY_SOLID, n, sizeof *f->h);
    for (int c = 0; c < 3; c++) f->normal[c] = memory_new(MEMORY_SOLID, n, sizeof(double));
    f->two_sided = memory_new(MEMORY_SOLID, n, 1);
    f->depth = memory_new(MEMORY_SOLID, n, sizeof(double));
    f->area = memory_new(MEMORY_SOLID, n, sizeof(double));
    f->normal_data = memory_new(MEMORY_SOLID, n, sizeof *f->normal_data);
    f->bare = memory_new(MEMORY_SOLID, n, 1);
    f->share = memory_new(MEMORY_SOLID, n, sizeof(double));
    f->faces = memory_new(MEMORY_SOLID, n, 1);
    if (s->in.depth != SOLID_DEPTH_HALF) f->counted = memory_new(MEMORY_SOLID, n, sizeof *f->counted);
    if (s->in.depth == SOLID_DEPTH_SHAPE) f->curvature = memory_new(MEMORY_SOLID, n, sizeof *f->curvature);
    f->cones_of = memory_new(MEMORY_SOLID, n, sizeof *f->cones_of);
    f->tracker = solid_broken_tracker_new(s);
    f->near = memory_new(MEMORY_SOLID, (size_t)s->in.bodies, sizeof *f->near);
    for (int b = 0; b < s->in.bodies; b++)
        if (s->family->lattice[b]) solid_sector_near(s->family->lattice[b]->stencil, f->near[b]);
    return f;
}

long solid_surface_count(struct solid_surface *f, long also) {
    long all[3] = {f->n, 0, also};
    for (int i = 0; i < f->n; i++) all[1] += f->two_sided[i] == SOLID_ISOLATED;
    par_sum_long_array(all, 3);
    f->total = all[0];
    f->isolated = all[1];
    return all[2];
}

struct solid_surface *solid_surface_new(struct solid *s) {
    clock_begin(CLOCK_INTERFACE);
    solid_ghosts_update(s);
    struct solid_surface *f = allocate(s);
    struct solid_family_view view;
    for (int h = 0; h < s->n; h++) {
        const int b = s->body[h], is_lattice = s->family->lattice[b] != NULL;
        struct solid_cones w;
        if (is_lattice) { /* inside a body the view is not needed */
            solid_sector_classify_lattice(s, h, f->near[b], solid_family_intact_bonds(s, h), &w);
        } else {
            solid_family_view(s, h, &view);
            solid_sector_classify(s, h, &view, &w);
        }
        const unsigned open = solid_sector_void(s, &w);
        const int is_bare = w.bare || solid_family_initial_bonds(s, h) == 0;
        if (is_lattice && (is_bare || is_on(&w, open))) solid_family_view(s, h, &view);
        s->flag[h] &= (uint8_t) ~(SOLID_INTERFACE | SOLID_FIRST);
        f->cones_of[h] = -1;
        f->bare[h] = w.bare;
        if (is_bare) {
            struct solid_normal_data start;
            solid_normal_compute_initial(s, h, &view, w.bare, &start);
            s->flag[h] |= SOLID_FIRST;
            f->share[h] = solid_surface_area_share(s, h, &view, &start);
            f->faces[h] = start.two_sided ? 2 : 1;
            if (f->counted) f->counted[h] = solid_counted_depth(s, h, &view);
        }
        if (w.broken || w.isolated) add_cones(f, &w);
        if (!is_on(&w, open)) continue;
        s->flag[h] |= SOLID_INTERFACE;
        solid_normal_compute(s, h, &view, open, &f->normal_data[h]);
    }
    solid_broken_tracker_take(s, SOLID_BROKE_SURFACE);
    if (s->in.depth == SOLID_DEPTH_SHAPE) f->exact = solid_exact_new(s, f);
    solid_surface_gather(s, f);
    solid_surface_area_restrict(s, f, (double[]){-INFINITY, -INFINITY, -INFINITY},
                                (double[]){INFINITY, INFINITY, INFINITY});
    solid_surface_count(f, 0);
    clock_end(CLOCK_INTERFACE);
    return f;
}

/* Frees what only an update reads. */
static void forget(struct solid_surface *f) {
    MEMORY_FREE(f->normal_data, f->bare, f->share, f->faces, f->counted, f->cones, f->cones_of);
    solid_broken_tracker_free(f->tracker);
    solid_exact_free(f->exact);
    f->normal_data = NULL;
    f->bare = f->faces = NULL;
    f->share = NULL;
    f->counted = NULL;
    f->cones = NULL;
    f->cones_of = NULL;
    f->cones_used = f->cones_capacity = 0;
    f->tracker = NULL;
    f->exact = NULL;
}

/* Only the first f->n items of an array, which is freed. */
static void *shrunk(const struct solid_surface *f, void *array, size_t size) {
    void *items = memory_copy(MEMORY_SOLID, array, (size_t)f->n, size);
    memory_free(array);
    return items;
}

void solid_surface_freeze(struct solid_surface *f) {
    forget(f);
    f->h = shrunk(f, f->h, sizeof *f->h);
    for (int c = 0; c < 3; c++) f->normal[c] = shrunk(f, f->normal[c], sizeof *f->normal[c]);
    f->two_sided = shrunk(f, f->two_sided, sizeof *f->two_sided);
    f->depth = shrunk(f, f->depth, sizeof *f->depth);
    if (f->curvature) f->curvature = shrunk(f, f->curvature, sizeof *f->curvature);
    f->area = shrunk(f, f->area, sizeof *f->area);
    f->capacity = f->n;
}

void solid_surface_free(struct solid_surface *f) {
    if (!f) return;
    forget(f);
    MEMORY_FREE(f->h, f->normal[0], f->normal[1], f->normal[2], f->two_sided, f->depth, f->area, f->curvature, f->near,
                f);
}

/* The data for the interface test of a particle that has lost bonds, after solid_broken_tracker_find has counted them.
 */
void solid_surface_classify(struct solid *s, struct solid_surface *f, int h, struct solid_cones *w) {
    struct solid_family_view view;
    if (s->family->lattice[s->body[h]]) {
        solid_sector_classify_lattice(s, h, f->near[s->body[h]], f->tracker->intact[h], w);
    } else {
        solid_family_view(s, h, &view);
        solid_sector_classify(s, h, &view, w);
    }
    if (w->broken || w->isolated) add_cones(f, w);
}

/* Updates the particles that have lost bonds since the last call. Returns the number of normals computed. */
static int update_broken(struct solid *s, struct solid_surface *f) {
    struct solid_family_view view;
    const int found = solid_broken_tracker_find(f->tracker, s);
    int normals = 0;
    for (int k = 0; k < found; k++) {
        const int h = f->tracker->h[k];
        struct solid_cones w;
        solid_surface_classify(s, f, h, &w);
        if (!(s->flag[h] & SOLID_INTERFACE)) continue;
        solid_family_view(s, h, &view);
        solid_normal_compute(s, h, &view, solid_sector_void(s, &w), &f->normal_data[h]);
        normals++;
    }
    return normals;
}

/* Updates the particles that have lost bonds, whose cracks may have opened or closed. Returns the number that joined or
 * left the interface, and adds to the number of normals computed. */
static int update_open(struct solid *s, struct solid_surface *f, int *normals) {
    struct solid_family_view view;
    int changes = 0;
    for (int k = 0; k < f->cones_used; k++) {
        const struct solid_cones *w = &f->cones[k];
        const int h = w->h;
        const unsigned open = solid_sector_void(s, w);
        const int was = (s->flag[h] & SOLID_INTERFACE) != 0, is = is_on(w, open);
        if (is && (!was || open != f->normal_data[h].open)) {
            solid_family_view(s, h, &view);
            solid_normal_compute(s, h, &view, open, &f->normal_data[h]);
            ++*normals;
        }
        if (is == was) continue;
        s->flag[h] ^= SOLID_INTERFACE;
        changes++;
    }
    return changes;
}

void solid_surface_renew(const struct solid *s, struct solid_surface *f) {
    for (int i = 0; i < f->n; i++) renew(s, f, i);
}

/* Updates the normals of particles whose family has rotated. */
static void update_turned(struct solid *s, struct solid_surface *f) {
    struct solid_family_view view;
    for (int i = 0; i < f->n; i++) {
        const int h = f->h[i];
        if (!solid_normal_has_turned(s, h, &f->normal_data[h])) continue;
        solid_family_view(s, h, &view);
        solid_normal_compute(s, h, &view, f->normal_data[h].open, &f->normal_data[h]);
        renew(s, f, i);
    }
}

int solid_surface_update(struct solid *s, struct solid_surface *f) {
    clock_begin(CLOCK_SOLID); /* includes the time that ranks wait for the slowest one */
    solid_ghosts_update(s);
    clock_end(CLOCK_SOLID);
    clock_begin(CLOCK_INTERFACE);
    int normals = solid_broken_tracker_take(s, SOLID_BROKE_SURFACE) ? update_broken(s, f) : 0;
    const int changes = update_open(s, f, &normals);
    if (changes)
        solid_surface_gather(s, f);
    else if (normals)
        solid_surface_renew(s, f); /* the members are the same: only normals change */
    update_turned(s, f);
    const long changed = solid_surface_count(f, changes);
    clock_end(CLOCK_INTERFACE);
    return changed > 0;
}
