/* The lists of pairs that may touch. Inside the room only. */
#pragma once
#include "solid/solid.h"

struct par_exchange;
struct solid_lost;

struct solid_contact_pairs {
    int n, capacity;
    int *h; /* [n] owned particle */
    int *l; /* [n] the other: owned or ghost; of strangers n + k: the k-th served from another rank */
};

/* Another rank's particle. */
struct solid_contact_other {
    double x0[3], x[3]; /* m */
    double volume;      /* m3 */
    double c0;          /* N/m6 */
    long id;
    int body;
};

struct solid_contact {
    double radius, skin; /* r_c and how far beyond it pairs are listed, m */
    struct solid_lost *lost;
    uint8_t *again;   /* [s->n] scratch, 0 */
    double *built[3]; /* [s->n] displacement when the lists were made, m */
    double *id;       /* [n + n_ghost] global ids */
    struct solid_contact_pairs broken, strangers;
    int any;                          /* pairs on some rank */
    int crossing;                     /* strangers on different ranks somewhere */
    struct par_exchange *exchange;    /* our particles near other ranks' */
    int sent, sent_capacity, *sent_h; /* [sent] which */
    double (*sent_x)[3];
    int served;
    struct solid_contact_other *other; /* [served] */
    double (*other_x)[3];              /* [served] X now, m */
};

void solid_contact_pairs_add(struct solid_contact_pairs *pairs, int h, int l);
/* c0 of particle h's material, N/m6. */
double solid_contact_stiffness_of(const struct solid *s, int body);
/* Makes both lists from scratch. Collective. */
void solid_contact_list(struct solid *s, struct solid_contact *c);
/* Adds the bonds that broke since the last look to the list of broken pairs. Not collective. */
void solid_contact_list_broken(struct solid *s, struct solid_contact *c);
/* Positions of strangers on other ranks, into other_x. Collective. */
void solid_contact_exchange(struct solid *s, struct solid_contact *c);

static inline int solid_contact_is_candidate(const struct solid *s, int h) {
    return (s->flag[h] & (SOLID_INTERFACE | SOLID_BROKEN)) != 0;
}
