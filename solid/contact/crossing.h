/* Particles sent to other ranks because they may touch a particle there. For solid/ only. */
#pragma once
#include "solid/state.h"

struct par_exchange;

/* A particle of another rank. */
struct solid_other {
    double x0[3], x[3]; /* m */
    double volume;      /* m3 */
    long id;
    short body, material;
    uint8_t seeks, runs;
};

struct solid_crossing {
    int active; /* 1: some rank serves a particle of another rank */
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

/* Adds particle h to those sent to a rank. Not collective. */
void solid_contact_crossing_send(struct solid_crossing *x, int h, int rank, const struct solid_other *it);
/* Sends all ranks' particles: other [served]. Collective. */
void solid_contact_crossing_begin(struct solid_crossing *x);
/* Keeps only the particles that are used: used [served] is set by the caller. at[k] is the new index of served particle
 * k. Collective. */
void solid_contact_crossing_keep(struct solid_crossing *x);
/* Updates d of the served particles. Collective. */
void solid_contact_crossing_update(const struct solid *s, struct solid_crossing *x);
void solid_contact_crossing_free(struct solid_crossing *x);
