/* Keeps contact's lists in memory while a kept state needs them. */
#include "solid/contact/put_away.h"
#include "base/memory.h"
#include "solid/contact/pairs.h"

#include <string.h>

struct solid_contact_put_away *solid_contact_put_away_new(const struct solid *s, struct solid_contact *c) {
    struct solid_contact_put_away *p = c->spare;
    c->spare = NULL;
    if (p) return p;
    p = memory_new(MEMORY_SOLID, 1, sizeof *p);
    for (int k = 0; k < s->dim; k++) p->built[k] = memory_new(MEMORY_SOLID, (size_t)s->n + 1, sizeof(double));
    p->runs = memory_new(MEMORY_SOLID, (size_t)(s->n + s->n_ghost) + 1, 1);
    for (int kind = 0; kind < SOLID_CONTACT_KINDS; kind++) p->pairs[kind].dim = s->dim;
    return p;
}

static void put_away_free(struct solid_contact_put_away *p) {
    if (!p) return;
    for (int k = 0; k < 3; k++) memory_free(p->built[k]);
    memory_free(p->runs);
    for (int kind = 0; kind < SOLID_CONTACT_KINDS; kind++) solid_contact_pairs_free(&p->pairs[kind]);
    solid_contact_crossing_free(&p->crossing);
    memory_free(p);
}

void solid_contact_put_away_let_go(struct solid_contact_put_away *p, struct solid_contact *c) {
    if (!p || --p->holders > 0) return;
    if (c && !c->spare)
        c->spare = p;
    else
        put_away_free(p);
}

void solid_contact_put_away_exchange(struct solid_contact *c, struct solid_contact_put_away *p) {
    const struct solid_contact_put_away was = *p;
    memcpy(p->built, c->built, sizeof p->built);
    memcpy(p->pairs, c->pairs, sizeof p->pairs);
    p->runs = c->runs;
    p->crossing = c->crossing;
    memcpy(c->built, was.built, sizeof c->built);
    memcpy(c->pairs, was.pairs, sizeof c->pairs);
    c->runs = was.runs;
    c->crossing = was.crossing;
}

void solid_contact_put_away(struct solid_contact *c) {
    struct solid_contact_put_away *p = c->present;
    c->present = NULL;
    if (!p) return;
    if (p->holders > 1) solid_contact_put_away_exchange(c, p);
    solid_contact_put_away_let_go(p, c);
}

void solid_contact_put_away_free(struct solid_contact *c) {
    solid_contact_put_away_let_go(c->present, NULL);
    put_away_free(c->spare);
    c->present = c->spare = NULL;
}
