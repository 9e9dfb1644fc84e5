/* Keeps copies of the particles in contact's lists. */
#include "solid/contact/ends.h"
#include "base/memory.h"
#include "base/vec_type.h"
#include "solid/contact/pairs.h"
#include "solid/contact/reserve.h"

#include <string.h>

struct solid_contact_ends *solid_contact_ends_new(const struct solid *s) {
    struct solid_contact_ends *t = memory_new(MEMORY_SOLID, 1, sizeof *t);
    t->end_of = memory_new(MEMORY_SOLID, (size_t)(s->n + s->n_ghost) + 1, sizeof *t->end_of);
    return t;
}

void solid_contact_ends_free(struct solid_contact_ends *t) {
    if (!t) return;
    for (int kind = 0; kind < SOLID_CONTACT_KINDS; kind++)
        MEMORY_FREE(t->h[kind], t->l[kind], t->of_pair[kind].radius, t->of_pair[kind].on_h, t->of_pair[kind].on_l);
    MEMORY_FREE(t->end, t->particle, t->end_of, t->of_served, t);
}

void solid_contact_ends_invalidate(struct solid_contact_ends *t) {
    for (int k = 0; k < t->n; k++)
        if (t->end[k].particle >= 0) t->end_of[t->end[k].particle] = 0;
    if (t->served_capacity > 0) memset(t->of_served, 0, (size_t)t->served_capacity * sizeof *t->of_served);
    memset(t->pairs, 0, sizeof t->pairs);
    t->n = 0;
}

/* The end of a particle, which is added if it is new. */
static int end_of(struct solid_contact_ends *t, int *recorded, const struct solid_contact_end *end) {
    if (*recorded > 0) return *recorded - 1;
    t->end = solid_contact_reserve(t->end, &t->capacity, t->n + 1, sizeof *t->end);
    t->particle = solid_contact_reserve(t->particle, &t->particle_capacity, t->n + 1, sizeof *t->particle);
    t->end[t->n] = *end;
    t->particle[t->n] = end->particle;
    *recorded = ++t->n;
    return t->n - 1;
}

static int local_end(const struct solid *s, struct solid_contact_ends *t, int h) {
    const struct solid_contact_end end = {
        .volume = s->volume[h], .particle = h, .body = s->body[h], .material = (uint8_t)solid_particle_material(s, h)};
    return end_of(t, &t->end_of[h], &end);
}

static int served_end(struct solid_contact_ends *t, const struct solid_contact_ghosts *x, int k) {
    const struct solid_contact_end end = {.volume = x->other[k].volume,
                                          .particle = SOLID_CONTACT_SERVED_END - k,
                                          .body = (uint8_t)x->other[k].body,
                                          .material = (uint8_t)x->other[k].material};
    return end_of(t, &t->of_served[k], &end);
}

/* Numbers the particles of this rank's memory in their order, so that they are read in the order of memory. */
static void number(const struct solid *s, struct solid_contact *c) {
    struct solid_contact_ends *t = c->ends;
    for (int kind = 0; kind < SOLID_CONTACT_KINDS; kind++)
        for (int k = 0; k < c->pairs[kind].n; k++) {
            t->end_of[c->pairs[kind].h[k]] = 1;
            if (kind != SOLID_CONTACT_GHOST) t->end_of[c->pairs[kind].l[k]] = 1;
        }
    for (int h = 0; h < s->n + s->n_ghost; h++)
        if (t->end_of[h] > 0) {
            t->end_of[h] = 0;
            local_end(s, t, h);
        }
}

static void ends_add(const struct solid *s, struct solid_contact *c, int kind) {
    struct solid_contact_ends *t = c->ends;
    const struct solid_contact_pairs *p = &c->pairs[kind];
    t->h[kind] = solid_contact_reserve(t->h[kind], &t->pairs_capacity[0][kind], p->n + VEC_LANES, sizeof **t->h);
    t->l[kind] = solid_contact_reserve(t->l[kind], &t->pairs_capacity[1][kind], p->n + VEC_LANES, sizeof **t->l);
    struct solid_contact_constants *constants = &t->of_pair[kind];
    double **const number[3] = {&constants->radius, &constants->on_h, &constants->on_l};
    for (int i = 0; i < 3; i++)
        *number[i] = solid_contact_reserve(*number[i], &constants->capacity[i], p->n + VEC_LANES, sizeof **number[i]);
    for (int k = t->pairs[kind]; k < p->n; k++) {
        t->h[kind][k] = local_end(s, t, p->h[k]);
        t->l[kind][k] = kind == SOLID_CONTACT_GHOST ? served_end(t, &c->ghosts, p->l[k]) : local_end(s, t, p->l[k]);
        const struct solid_contact_touch pair = solid_contact_pairs_touch(s, c, kind, k);
        constants->radius[k] = pair.radius;
        constants->on_h[k] = pair.k * pair.l->volume / c->density[pair.h->material];
        constants->on_l[k] = kind == SOLID_CONTACT_OWNED ? pair.k * pair.h->volume / c->density[pair.l->material] : 0;
    }
    for (int k = p->n; k < p->n + VEC_LANES; k++) t->h[kind][k] = t->l[kind][k] = 0; /* read, but not used */
    t->pairs[kind] = p->n;
}

void solid_contact_ends_list(const struct solid *s, struct solid_contact *c) {
    struct solid_contact_ends *t = c->ends;
    if (c->ghosts.active) solid_contact_ghosts_update(s, &c->ghosts);
    t->of_served = solid_contact_reserve(t->of_served, &t->served_capacity, c->ghosts.served, sizeof *t->of_served);
    for (int kind = 0; kind < SOLID_CONTACT_KINDS; kind++)
        if (t->pairs[kind] > c->pairs[kind].n) solid_contact_ends_invalidate(t);
    if (t->n == 0) number(s, c);
    for (int kind = 0; kind < SOLID_CONTACT_KINDS; kind++)
        if (t->pairs[kind] < c->pairs[kind].n) ends_add(s, c, kind);
}

void solid_contact_ends_update(const struct solid *s, struct solid_contact *c) {
    struct solid_contact_ends *t = c->ends;
    solid_contact_ends_list(s, c);
    for (int k = 0; k < t->n; k++) {
        struct solid_contact_end *e = &t->end[k];
        const int is_served = e->particle < 0, at = is_served ? SOLID_CONTACT_SERVED_END - e->particle : e->particle;
        for (int i = 0; i < s->dim; i++) e->d[i] = (is_served ? c->ghosts.d[i] : s->d[i])[at];
    }
}
