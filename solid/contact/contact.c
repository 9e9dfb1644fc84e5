/* Creates contact when particles can touch, renews its pair lists, frees it. */
#include "solid/contact/contact.h"

#include "base/clock.h"
#include "base/memory.h"
#include "base/par.h"
#include "base/par_ghost.h"
#include "solid/contact/pairs.h"
#include "solid/contact/retain.h"
#include "solid/bonds/family.h"
#include "solid/geometry/shape.h"
#include "solid/law/material.h"
#include "solid/bonds/broken_tracker.h"
#include "solid/bonds/ghosts.h"

#include <math.h>
#include <string.h>

/* The Verlet skin of the lists and the displacements that it allows, in spacings. Second neighbours of the lattice are
 * 1.41 spacings apart: pairs of them that have not moved are in no list after their bond has broken. When
 * solid_contact_update is called a particle may have moved by rebuild_distance + distance_per_update since the lists
 * were built, and twice this sum is at most the skin. */
static const double skin = 0.35, rebuild_distance = 0.125, distance_per_update = 0.05;
/* In a crushed block a few loose particles move ten times as far as all others. These are fast particles: until the
 * lists are rebuilt they may move by `fast_skin` more than others, and the skin of the lists is that much wider for
 * them. Particles are fast if they have moved by more than 1/2, 1/4, 1/8 or 1/16 of the largest displacement since the
 * last lists: the smallest of these fractions at which at most the share `few` of all particles are fast. */
static const double fast_skin = 0.5, few = 0.01;
enum { PARTS = 4 };

/* The quantum of accelerations: 2^-46 of the acceleration by a neighbour at half of r_c. Sums of up to about thirty
 * such accelerations are exact. */
static double quantum_of(const struct solid *s, const struct solid_contact *c) {
    double most = 0, volume = 0;
    for (int h = 0; h < s->n; h++) volume = fmax(volume, s->volume[h]);
    for (int m = 0; m < s->in.materials; m++)
        if (c->density[m] > 0) most = fmax(most, s->in.contact_stiffness * c->c0[m] / c->density[m]);
    most *= par_max(volume);
    return most > 0 ? ldexp(1, ilogb(most) - 46) : 1;
}

static struct solid_contact *contact_new(struct solid *s) {
    struct solid_contact *c = memory_new(MEMORY_SOLID, 1, sizeof *c);
    const size_t n = (size_t)s->n + 1;
    c->radius = s->in.contact_radius * s->in.spacing;
    c->skin = skin * s->in.spacing;
    c->fast_skin =
        fmin(fast_skin * s->in.spacing, 0.5 * (c->radius + c->skin)); /* two cells cover a pair of fast particles */
    c->is_fast = memory_new(MEMORY_SOLID, n + (size_t)s->n_ghost, 1);
    c->is_fast_next = memory_new(MEMORY_SOLID, n + (size_t)s->n_ghost, 1);
    c->starts_near = s->in.contact_radius > 1;
    for (int b = 0; b < s->in.bodies; b++) {
        const struct solid_body *body = &s->in.body[b];
        c->starts_near |= solid_shape_of(body)->places == SOLID_PLACES_POINTS || body->perturbation > 0;
        for (int k = 0; k < (body->image_materials > 0 ? body->image_materials : 1); k++) {
            const int m = body->image_materials > 0 ? body->image_material[k] : body->material;
            c->c0[m] = solid_material_c0(&s->in, &s->in.material[m]);
            c->density[m] = s->in.material[m].density;
        }
    }
    for (int k = 0; k < s->dim; k++) c->listed_d[k] = memory_new(MEMORY_SOLID, n, sizeof(double));
    for (int kind = 0; kind < SOLID_CONTACT_KINDS; kind++) c->pairs[kind].dim = s->dim;
    c->quantum = quantum_of(s, c);
    c->bounds = memory_new(MEMORY_SOLID, (size_t)s->in.bodies, sizeof *c->bounds);
    c->tracker = solid_broken_tracker_new(s);
    c->record = ++s->versions;
    c->recorded = memory_new(MEMORY_SOLID, n * (size_t)solid_family_bytes(s), 1);
    c->springs = solid_contact_rate_springs_new(s);
    c->nonbonded = solid_contact_nonbonded_new(s);
    c->ends = solid_contact_ends_new(s);
    return c;
}

void solid_contact_free(struct solid *s) {
    struct solid_contact *c = s->contact;
    s->contact = NULL;
    if (!c) return;
    for (int k = 0; k < 3; k++) memory_free(c->listed_d[k]);
    solid_contact_retain_free(c);
    for (int kind = 0; kind < SOLID_CONTACT_KINDS; kind++) solid_contact_pairs_free(&c->pairs[kind]);
    MEMORY_FREE(c->is_fast, c->is_fast_next, c->bounds, c->recorded, c->broken_h, c->broken_l);
    solid_broken_tracker_free(c->tracker);
    solid_contact_nonbonded_free(c->nonbonded);
    solid_contact_ends_free(c->ends);
    solid_contact_implicit_free(c->implicit);
    solid_contact_rate_springs_free(c->springs);
    solid_contact_ghosts_free(&c->ghosts);
    memory_free(c);
}

/* The square of the largest displacement of a particle since the lists were built, over the square of the displacement
 * at which they are rebuilt. */
static double moved2(const struct solid *s, const struct solid_contact *c) {
    const int plane = s->dim == 2; /* in a plate the third component is 0: the second array stands for it, times 0 */
    const double *restrict x = s->d[0], *restrict y = s->d[1], *restrict z = s->d[s->dim - 1];
    const double *restrict x0 = c->listed_d[0], *restrict y0 = c->listed_d[1], *restrict z0 = c->listed_d[s->dim - 1];
    const uint8_t *restrict is_fast = c->is_fast;
    const double limit = rebuild_distance * s->in.spacing, third = !plane,
                 less = 1 - pow(limit / (limit + c->fast_skin), 2);
    double most = 0;
    for (int h = 0; h < s->n; h++) {
        const double dx = x[h] - x0[h], dy = y[h] - y0[h], dz = third * (z[h] - z0[h]);
        const double r2 = (dx * dx + dy * dy + dz * dz) * (1 - less * is_fast[h]);
        most = r2 > most ? r2 : most;
    }
    return most / (limit * limit);
}

static double distance2(const struct solid *s, const struct solid_contact *c, int h) {
    double r2 = 0;
    for (int k = 0; k < s->dim; k++) r2 += (s->d[k][h] - c->listed_d[k][h]) * (s->d[k][h] - c->listed_d[k][h]);
    return r2;
}

/* Finds the fast particles of the next lists, by the displacements since the present ones. Collective. */
static void find_fast(const struct solid *s, struct solid_contact *c) {
    double most = 0, count[PARTS + 1] = {0}, limit = INFINITY;
    for (int h = 0; h < s->n; h++) most = fmax(most, distance2(s, c, h));
    most = par_max(most);
    for (int h = 0; h < s->n; h++) {
        double part = 0.25;
        const double of_most = distance2(s, c, h);
        for (int k = 0; k < PARTS; k++, part *= 0.25) count[k] += of_most > part * most;
    }
    count[PARTS] = s->n;
    par_sum_array(count, PARTS + 1);
    for (int k = 0; k < PARTS && count[k] <= few * count[PARTS]; k++) limit = most * pow(0.25, k + 1);
    c->has_fast = isfinite(limit);
    for (int h = 0; h < s->n; h++) c->is_fast_next[h] = distance2(s, c, h) > limit;
    par_ghost_update_bytes(s->ghost, c->is_fast_next, s->n);
}

/* Rebuilds all lists. Collective. */
static void list(struct solid *s, struct solid_contact *c) {
    solid_contact_retain(c);
    solid_contact_ends_invalidate(c->ends);
    for (int kind = 0; kind < SOLID_CONTACT_KINDS; kind++) c->pairs[kind].n = 0;
    memcpy(c->is_fast, c->is_fast_next, (size_t)(s->n + s->n_ghost));
    for (int k = 0; k < s->dim; k++) memcpy(c->listed_d[k], s->d[k], (size_t)s->n * sizeof(double));
    solid_contact_bounds_of(s, c->bounds);
    solid_contact_broken_list(s, c);
    solid_contact_nonbonded_list(s, c);
    for (int kind = 0; kind < SOLID_CONTACT_KINDS; kind++)
        if (c->pairs[kind].n > 0) solid_contact_pairs_order(&c->pairs[kind], s->n);
}

/* Finds which sorts of pairs exist on any rank. Collective. */
static void count(struct solid_contact *c) {
    double listed[2] = {0, c->pairs[SOLID_CONTACT_BOND_GHOST].n};
    for (int kind = 0; kind < SOLID_CONTACT_KINDS; kind++) listed[0] += c->pairs[kind].n;
    par_max_array(listed, 2);
    c->any = listed[0] > 0;
    c->reaches_ghosts = listed[1] > 0;
}

/* Makes the first lists, if anything can touch. Collective. */
static void begin(struct solid *s) {
    solid_contact_bounds bounds[SOLID_CONTACT_BODIES];
    solid_contact_bounds_of(s, bounds);
    if (!solid_contact_bounds_touch(s, bounds, (s->in.contact_radius + skin) * s->in.spacing)) return;
    struct solid_contact *c = s->contact = contact_new(s);
    solid_ghosts_update(s);
    solid_contact_broken_scan(s, c);
    list(s, c);
    count(c);
}

/* Updates the lists. Both ends of a bond that has broken since the lists were built may have moved by rebuild_distance
 * since then, so such a pair is listed at a larger distance. Collective. */
static void update(struct solid *s, struct solid_contact *c, int broke) {
    double now[2] = {moved2(s, c), broke}; /* the same decision on every rank */
    par_max_array(now, 2);
    const int is_stale = now[0] > 1, has_broken = now[1] > 0;
    if (!is_stale && !has_broken) return;
    solid_ghosts_update(s);
    if (has_broken) solid_contact_broken_update(s, c, 2 * rebuild_distance * s->in.spacing);
    if (is_stale) {
        find_fast(s, c);
        list(s, c);
    }
    count(c);
}

void solid_contact_update(struct solid *s) {
    if (!s->in.contact) return;
    clock_begin(CLOCK_CONTACT);
    const int broke = solid_broken_tracker_take(s, SOLID_BROKE_CONTACT);
    if (s->contact)
        update(s, s->contact, broke);
    else
        begin(s);
    clock_end(CLOCK_CONTACT);
}

void solid_contact_update_broken(struct solid *s) {
    if (!s->in.contact || !s->stage.breakage) return;
    if (par_max(s->broke & (SOLID_BROKE_NEW | SOLID_BROKE_CONTACT)) > 0) solid_contact_update(s);
}

int solid_contact_is_fast(const struct solid *s, double time) {
    const double limit = distance_per_update * s->in.spacing / time;
    double most = 0;
    for (int h = 0; h < s->n; h++) {
        double v2 = 0;
        for (int c = 0; c < s->dim; c++) v2 += s->v[c][h] * s->v[c][h];
        most = v2 > most ? v2 : most;
    }
    return par_max(most) > limit * limit;
}

int solid_contact_is_possible(const struct solid *s) {
    if (!s->in.contact) return 0;
    unsigned flags = 0;
    for (int h = 0; h < s->n; h++) flags |= s->flag[h];
    return s->stage.breakage || s->in.bodies > 1 || par_max(flags & SOLID_BROKEN ? 1 : 0) > 0;
}
