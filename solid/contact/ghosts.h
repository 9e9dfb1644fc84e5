/* Contact ghosts: copies of other ranks' particles that may touch a particle here and are not ghosts of its family. For
 * solid/ only. */
#pragma once
#include "solid/state.h"

struct par_exchange;

/* A particle of another rank. */
struct solid_contact_ghost {
    double x0[3], x[3]; /* m */
    double volume;      /* m3 */
    long id;
    short body, material;
    uint8_t is_candidate, is_fast;
};

struct solid_contact_ghosts {
    int active; /* 1: some rank has contact ghosts */
    struct par_exchange *exchange;
    int sent, sent_capacity;
    int *h, *dest;                     /* [sent] owned particle, the rank it goes to */
    struct solid_contact_ghost *local; /* [sent] */
    double (*sent_d)[3];               /* [sent] m */
    int served;
    struct solid_contact_ghost *other; /* [served] */
    double (*arrived)[3];              /* [served] m */
    double *d[3];                      /* [served] displacement now, m */
    uint8_t *used, *wanted;            /* [served], [sent] work */
    int *at;                           /* [served] work */
    int pack_capacity[4], served_capacity[7];
};

/* Adds particle h to those sent to a rank. Not collective. */
void solid_contact_ghosts_send(struct solid_contact_ghosts *x, int h, int rank, const struct solid_contact_ghost *it);
/* Sends all ranks' particles: other [served]. Collective. */
void solid_contact_ghosts_begin(struct solid_contact_ghosts *x);
/* Discards the ghosts that are not used: the caller has set used [served]. at[k] becomes the new index of ghost k.
 * Collective. */
void solid_contact_ghosts_keep(struct solid_contact_ghosts *x);
/* Updates d of the ghosts. Collective. */
void solid_contact_ghosts_update(const struct solid *s, struct solid_contact_ghosts *x);
void solid_contact_ghosts_free(struct solid_contact_ghosts *x);
