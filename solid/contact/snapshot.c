/* Contact's pair lists and record of broken bonds as part of a state kept in memory. */
#include "solid/contact/snapshot.h"

#include "base/memory.h"
#include "solid/contact/contact.h"
#include "solid/contact/ends.h"
#include "solid/bonds/family.h"
#include "solid/bonds/broken_tracker.h"
#include "solid/contact/retain.h"

#include <string.h>

static void take_record(struct solid_contact_snapshot *k, const struct solid *s) {
    const struct solid_contact *c = s->contact;
    const size_t bytes = (size_t)s->n * (size_t)solid_family_bytes(s);
    if (k->recorded && k->record == c->record) return;
    if (!k->recorded) k->recorded = memory_new(MEMORY_OUTPUT, bytes + 1, 1);
    if (!k->tracker) k->tracker = solid_broken_tracker_new(s);
    memcpy(k->recorded, c->recorded, bytes);
    solid_broken_tracker_copy(k->tracker, c->tracker, s);
    k->broken = c->broken;
    k->record = c->record;
}

void solid_contact_snapshot_take(struct solid_contact_snapshot *k, struct solid *s) {
    struct solid_contact *c = s->contact;
    k->exists = c != NULL;
    if (!c || k->lists != c->present) {
        solid_contact_retain_release(k->lists, c);
        k->lists = NULL;
    }
    if (!c) return;
    if (!c->present) {
        c->present = solid_contact_retain_new(s, c);
        c->present->holders = 1;
    }
    if (!k->lists) {
        k->lists = c->present;
        k->lists->holders++;
    }
    for (int kind = 0; kind < SOLID_CONTACT_KINDS; kind++) k->pairs[kind] = c->pairs[kind].n;
    k->any = c->any;
    k->reaches_ghosts = c->reaches_ghosts;
    take_record(k, s);
}

void solid_contact_snapshot_restore(struct solid_contact_snapshot *k, struct solid *s) {
    struct solid_contact *c = s->contact;
    if (!k->exists) {
        solid_contact_free(s);
        return;
    }
    solid_contact_ends_invalidate(c->ends);
    if (k->lists != c->present) {
        solid_contact_retain(c);
        solid_contact_retain_exchange(c, k->lists);
        c->present = k->lists;
        k->lists->holders++;
    }
    for (int kind = 0; kind < SOLID_CONTACT_KINDS; kind++) c->pairs[kind].n = k->pairs[kind];
    c->any = k->any;
    c->reaches_ghosts = k->reaches_ghosts;
    if (c->record == k->record) return;
    memcpy(c->recorded, k->recorded, (size_t)s->n * (size_t)solid_family_bytes(s));
    solid_broken_tracker_copy(c->tracker, k->tracker, s);
    c->broken = k->broken;
    c->record = k->record;
}

void solid_contact_snapshot_free(struct solid_contact_snapshot *k) {
    solid_contact_retain_release(k->lists, NULL);
    memory_free(k->recorded);
    solid_broken_tracker_free(k->tracker);
    *k = (struct solid_contact_snapshot){0};
}
