/* Contact's lists that are kept with a state (solid/contact/keep.h). For solid/ only. */
#pragma once
#include "solid/contact/list.h"

/* Lists that are kept. Empty while they are still the contact's present lists. */
struct solid_contact_put_away {
    int holders; /* number of kept states that hold them, plus one while they are the contact's present lists */
    double *built[3];
    uint8_t *runs;
    struct solid_contact_pairs pairs[SOLID_CONTACT_KINDS];
    struct solid_crossing crossing;
};

struct solid_contact_put_away *solid_contact_put_away_new(const struct solid *s, struct solid_contact *c);
/* Removes one holder. c: takes over their memory if nobody holds them any more; NULL: the memory is freed. */
void solid_contact_put_away_let_go(struct solid_contact_put_away *p, struct solid_contact *c);
/* Exchanges the contact's present lists with those of p. */
void solid_contact_put_away_exchange(struct solid_contact *c, struct solid_contact_put_away *p);
/* Before new lists are made: moves the present ones aside if a kept state holds them. Not collective. */
void solid_contact_put_away(struct solid_contact *c);
/* The same for a contact that is freed. */
void solid_contact_put_away_free(struct solid_contact *c);
