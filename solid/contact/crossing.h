/* Particles near other ranks' particles, seen from there: strangers on different ranks. Inside the room only. */
#pragma once
#include "solid/state.h"

struct par_exchange;

/* Another rank's particle. */
struct solid_other {
    double x0[3], x[3]; /* m */
    double volume;      /* m3 */
    long id;
    int body, seeks;
};

struct solid_crossing {
    int active; /* something is served on some rank */
    struct par_exchange *exchange;
    int sent, sent_capacity;
    int *h, *dest;            /* [sent] owned particle, the rank it goes to */
    struct solid_other *mine; /* [sent] */
    double (*sent_d)[3];      /* [sent] m */
    int served;
    struct solid_other *other; /* [served] */
    double (*arrived)[3];      /* [served] m */
    double *d[3];              /* [served] displacement now, m */
    uint8_t *used, *wanted;    /* [served], [sent] work */
    int *at;                   /* [served] work */
    int room_sent[4], room_served[7];
};

/* Particle h goes to a rank. Not collective. */
void solid_contact_crossing_send(struct solid_crossing *x, int h, int rank, const struct solid_other *it);
/* Everybody's particles to where they go: other [served]. Collective. */
void solid_contact_crossing_begin(struct solid_crossing *x);
/* Keeps only what is used there: used [served] as set by the caller; renumbers: at[k] is the new place of served k.
 * Collective. */
void solid_contact_crossing_keep(struct solid_crossing *x);
/* d of the served particles. Collective. */
void solid_contact_crossing_update(const struct solid *s, struct solid_crossing *x);
void solid_contact_crossing_free(struct solid_crossing *x);
