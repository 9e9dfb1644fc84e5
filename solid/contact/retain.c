/* Retains contact's lists in memory while a snapshot refers to them. */
#include "solid/contact/retain.h"
#include "base/memory.h"
#include "solid/contact/pairs.h"

#include <string.h>

struct solid_contact_retained *solid_contact_retain_new(const struct solid *s, struct solid_contact *c) {
    struct solid_contact_retained *p = c->spare;
    c->spare = NULL;
    if (p) return p;
    p = memory_new(MEMORY_SOLID, 1, sizeof *p);
    for (int k = 0; k < s->dim; k++) p->listed_d[k] = memory_new(MEMORY_SOLID, (size_t)s->n + 1, sizeof(double));
    p->is_fast = memory_new(MEMORY_SOLID, (size_t)(s->n + s->n_ghost) + 1, 1);
    for (int kind = 0; kind < SOLID_CONTACT_KINDS; kind++) p->pairs[kind].dim = s->dim;
    return p;
}

static void retained_free(struct solid_contact_retained *p) {
    if (!p) return;
    for (int k = 0; k < 3; k++) memory_free(p->listed_d[k]);
    memory_free(p->is_fast);
    for (int kind = 0; kind < SOLID_CONTACT_KINDS; kind++) solid_contact_pairs_free(&p->pairs[kind]);
    solid_contact_ghosts_free(&p->ghosts);
    memory_free(p);
}

void solid_contact_retain_release(struct solid_contact_retained *p, struct solid_contact *c) {
    if (!p || --p->holders > 0) return;
    if (c && !c->spare)
        c->spare = p;
    else
        retained_free(p);
}

void solid_contact_retain_exchange(struct solid_contact *c, struct solid_contact_retained *p) {
    const struct solid_contact_retained was = *p;
    memcpy(p->listed_d, c->listed_d, sizeof p->listed_d);
    memcpy(p->pairs, c->pairs, sizeof p->pairs);
    p->is_fast = c->is_fast;
    p->ghosts = c->ghosts;
    memcpy(c->listed_d, was.listed_d, sizeof c->listed_d);
    memcpy(c->pairs, was.pairs, sizeof c->pairs);
    c->is_fast = was.is_fast;
    c->ghosts = was.ghosts;
}

void solid_contact_retain(struct solid_contact *c) {
    struct solid_contact_retained *p = c->present;
    c->present = NULL;
    if (!p) return;
    if (p->holders > 1) solid_contact_retain_exchange(c, p);
    solid_contact_retain_release(p, c);
}

void solid_contact_retain_free(struct solid_contact *c) {
    solid_contact_retain_release(c->present, NULL);
    retained_free(c->spare);
    c->present = c->spare = NULL;
}
