/* Contact lists that are retained because a snapshot refers to them (solid/contact/snapshot.h). For solid/ only. */
#pragma once
#include "solid/contact/list.h"

/* Retained lists, with a count of references. Empty while they are still the contact's present lists. */
struct solid_contact_retained {
    int holders; /* number of snapshots that hold them, plus one while they are the contact's present lists */
    double *listed_d[3];
    uint8_t *is_fast;
    struct solid_contact_pairs pairs[SOLID_CONTACT_KINDS];
    struct solid_contact_ghosts ghosts;
};

struct solid_contact_retained *solid_contact_retain_new(const struct solid *s, struct solid_contact *c);
/* Removes one holder. c: takes over their memory if nobody holds them any more; NULL: the memory is freed. */
void solid_contact_retain_release(struct solid_contact_retained *p, struct solid_contact *c);
/* Exchanges the contact's present lists with those of p. */
void solid_contact_retain_exchange(struct solid_contact *c, struct solid_contact_retained *p);
/* Before new lists are built: retains the present ones if a snapshot refers to them. Not collective. */
void solid_contact_retain(struct solid_contact *c);
/* The same for a contact that is freed. */
void solid_contact_retain_free(struct solid_contact *c);
