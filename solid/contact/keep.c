/* Contact's pair lists and record of torn bonds as part of a state kept in memory. */
#include "solid/contact/keep.h"

#include "base/memory.h"
#include "solid/contact/contact.h"
#include "solid/bonds/family.h"
#include "solid/bonds/lost.h"

#include <string.h>

/* Lists that are kept. Empty while they are still the contact's present lists. */
struct solid_contact_put_away {
    int holders; /* number of kept states that hold them, plus one while they are the contact's present lists */
    double *built[3];
    struct solid_contact_pairs pairs[SOLID_CONTACT_KINDS];
    struct solid_crossing crossing;
};

static struct solid_contact_put_away *empty(const struct solid *s, struct solid_contact *c) {
    struct solid_contact_put_away *p = c->spare;
    c->spare = NULL;
    if (p) return p;
    p = memory_new(MEMORY_SOLID, 1, sizeof *p);
    for (int k = 0; k < s->dim; k++) p->built[k] = memory_new(MEMORY_SOLID, (size_t)s->n + 1, sizeof(double));
    for (int kind = 0; kind < SOLID_CONTACT_KINDS; kind++) p->pairs[kind].dim = s->dim;
    return p;
}

static void put_away_free(struct solid_contact_put_away *p) {
    if (!p) return;
    for (int k = 0; k < 3; k++) memory_free(p->built[k]);
    for (int kind = 0; kind < SOLID_CONTACT_KINDS; kind++) solid_contact_torn_free(&p->pairs[kind]);
    solid_contact_crossing_free(&p->crossing);
    memory_free(p);
}

/* Removes one holder. c: takes over their memory if nobody holds them any more; NULL: the memory is freed. */
static void let_go(struct solid_contact_put_away *p, struct solid_contact *c) {
    if (!p || --p->holders > 0) return;
    if (c && !c->spare)
        c->spare = p;
    else
        put_away_free(p);
}

static void exchange(struct solid_contact *c, struct solid_contact_put_away *p) {
    const struct solid_contact_put_away was = *p;
    memcpy(p->built, c->built, sizeof p->built);
    memcpy(p->pairs, c->pairs, sizeof p->pairs);
    p->crossing = c->crossing;
    memcpy(c->built, was.built, sizeof c->built);
    memcpy(c->pairs, was.pairs, sizeof c->pairs);
    c->crossing = was.crossing;
}

void solid_contact_keep_put_away(struct solid_contact *c) {
    struct solid_contact_put_away *p = c->present;
    c->present = NULL;
    if (!p) return;
    if (p->holders > 1) exchange(c, p);
    let_go(p, c);
}

void solid_contact_keep_put_away_free(struct solid_contact *c) {
    let_go(c->present, NULL);
    put_away_free(c->spare);
    c->present = c->spare = NULL;
}

static void take_record(struct solid_contact_keep *k, const struct solid *s) {
    const struct solid_contact *c = s->contact;
    const size_t bytes = (size_t)s->n * (size_t)solid_family_bytes(s);
    if (k->known && k->record == c->record) return;
    if (!k->known) k->known = memory_new(MEMORY_OUTPUT, bytes + 1, 1);
    if (!k->lost) k->lost = solid_lost_new(s);
    memcpy(k->known, c->known, bytes);
    solid_lost_copy(k->lost, c->lost, s);
    k->torn = c->torn;
    k->record = c->record;
}

void solid_contact_keep_take(struct solid_contact_keep *k, struct solid *s) {
    struct solid_contact *c = s->contact;
    k->exists = c != NULL;
    if (!c || k->lists != c->present) {
        let_go(k->lists, c);
        k->lists = NULL;
    }
    if (!c) return;
    if (!c->present) {
        c->present = empty(s, c);
        c->present->holders = 1;
    }
    if (!k->lists) {
        k->lists = c->present;
        k->lists->holders++;
    }
    for (int kind = 0; kind < SOLID_CONTACT_KINDS; kind++) k->pairs[kind] = c->pairs[kind].n;
    k->any = c->any;
    take_record(k, s);
}

void solid_contact_keep_restore(struct solid_contact_keep *k, struct solid *s) {
    struct solid_contact *c = s->contact;
    if (!k->exists) {
        solid_contact_free(s);
        return;
    }
    if (k->lists != c->present) {
        solid_contact_keep_put_away(c);
        exchange(c, k->lists);
        c->present = k->lists;
        k->lists->holders++;
    }
    for (int kind = 0; kind < SOLID_CONTACT_KINDS; kind++) c->pairs[kind].n = k->pairs[kind];
    c->any = k->any;
    if (c->record == k->record) return;
    memcpy(c->known, k->known, (size_t)s->n * (size_t)solid_family_bytes(s));
    solid_lost_copy(c->lost, k->lost, s);
    c->torn = k->torn;
    c->record = k->record;
}

void solid_contact_keep_free(struct solid_contact_keep *k) {
    let_go(k->lists, NULL);
    memory_free(k->known);
    solid_lost_free(k->lost);
    *k = (struct solid_contact_keep){0};
}
