/* Contact as part of a snapshot (solid/snapshot.h). For solid/ only.
 *
 * When new lists are built, lists that belong to a snapshot are retained, not overwritten. Pairs that were appended to
 * them since, because bonds broke, are cut off when the state is restored. So a snapshot costs nothing unless the
 * record of broken-bond pairs has grown. */
#pragma once
#include "solid/contact/list.h"

struct solid_broken_tracker;

struct solid_contact_snapshot {
    int exists;                           /* 1: contact existed */
    struct solid_contact_retained *lists; /* NULL: there are none */
    int pairs[SOLID_CONTACT_KINDS], any, reaches_ghosts, broken;
    long record;
    uint8_t *recorded;                    /* [s->n][bytes], NULL: not yet */
    struct solid_broken_tracker *tracker; /* counts of intact bonds at the contact's last check; NULL: none yet */
};

/* Not collective. */
void solid_contact_snapshot_take(struct solid_contact_snapshot *k, struct solid *s);
void solid_contact_snapshot_restore(struct solid_contact_snapshot *k, struct solid *s);
void solid_contact_snapshot_free(struct solid_contact_snapshot *k);
