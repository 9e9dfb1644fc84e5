/* Contact's lists that are kept with a state (solid/contact/keep.h). Inside the room only. */
#pragma once
#include "solid/contact/list.h"

/* Lists that are kept: empty as long as they are the contact's present ones. */
struct solid_contact_put_away {
    int holders; /* who keeps them, and the contact where they are its present ones */
    double *built[3];
    struct solid_contact_pairs pairs[SOLID_CONTACT_KINDS];
    struct solid_crossing crossing;
};

struct solid_contact_put_away *solid_contact_put_away_new(const struct solid *s, struct solid_contact *c);
/* One holder less; c: whose memory they may become, NULL: nobody's. */
void solid_contact_put_away_let_go(struct solid_contact_put_away *p, struct solid_contact *c);
/* The contact's present lists and those put away change places. */
void solid_contact_put_away_exchange(struct solid_contact *c, struct solid_contact_put_away *p);
/* Before new lists are made: the present ones go where somebody keeps them. Not collective. */
void solid_contact_put_away(struct solid_contact *c);
/* Of a contact that is given up. */
void solid_contact_put_away_free(struct solid_contact *c);
