/* Exchange of values of the listed particles that other ranks own, ghosts and served ones in one message. For solid/
 * only. */
#pragma once
#include "solid/contact/list.h"

struct par_exchange;

struct solid_contact_remote {
    long listing; /* the lists that it was made for; 0: none */
    int any;      /* 1: some rank asks for a particle */
    struct par_exchange *exchange;
    int asked, served;
    int *ask;    /* [asked] an end here whose particle another rank owns */
    int *serve;  /* [served] an end here whose values another rank asks for */
    double *out; /* [served][doubles] set by the caller */
    double *in;  /* [asked][doubles] */
    int *dest;   /* [asked] work: owners */
    long *id;    /* [asked], then [served]: work */
    int room_ask, room_dest, room_id, room_serve, room_out, room_in;
};

enum { SOLID_CONTACT_REMOTE_DOUBLES = 6 }; /* at most, of an end */

/* Makes the plan anew if the lists have changed. May add ends. Collective. */
void solid_contact_remote_renew(const struct solid *s, struct solid_contact *c, struct solid_contact_remote *r);
/* in <- the owners' out, so many doubles an end. Collective. */
void solid_contact_remote_update(struct solid_contact_remote *r, int doubles);
void solid_contact_remote_free(struct solid_contact_remote *r);
