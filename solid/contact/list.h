/* The lists of pairs that may touch. Inside the room only.
 *
 * Two sorts of pairs, found in different ways. Torn: two particles of one family whose bond is broken; each goes on
 * record when its bond breaks, and what is near is taken from the record. Strangers: two that never were of one family;
 * they can only meet where one of them has moved by half of what lay between them, or where two bodies' bounds are
 * near. */
#pragma once
#include "solid/contact/crossing.h"

struct solid_lost;
struct solid_strangers;
struct solid_contact_springs;  /* opaque */
struct solid_contact_put_away; /* opaque */

enum { SOLID_CONTACT_BODIES = 256 }; /* solid.body is a byte */

/* Where the ends of a pair are, and so who computes what. */
enum solid_contact_kind {
    SOLID_CONTACT_OWNED,  /* both here: once, for both ends */
    SOLID_CONTACT_GHOST,  /* l is a ghost: for h alone */
    SOLID_CONTACT_SERVED, /* l is the k-th particle served by another rank: for h alone */
    SOLID_CONTACT_KINDS
};

struct solid_contact_pairs {
    int dim, n, capacity;
    int *h, *l;    /* [n] an owned particle and the other */
    double *xi[3]; /* [n] X0_h - X0_l by the image that was nearest when listed, m; two in a plate */
};

/* Of each body, lowest and negated highest: positions (0-5), displacements (6-11), m; 12: 0 if a bond has broken; 13: 0
 * if something of it is held. Over all ranks. */
typedef double solid_contact_bounds[14];

struct solid_contact {
    double radius, skin;                                            /* r_c, how far beyond it pairs are listed, m */
    double c0[SOLID_CONTACT_BODIES], density[SOLID_CONTACT_BODIES]; /* by body: N/m6, kg/m3 */
    double *built[3];                                               /* [s->n] d when the lists were made, m */
    solid_contact_bounds *bounds;                                   /* [bodies] */
    struct solid_contact_pairs pairs[SOLID_CONTACT_KINDS];
    int any;                                /* pairs on some rank */
    struct solid_contact_put_away *present; /* who keeps these lists (solid/contact/keep.h), NULL: nobody */
    struct solid_contact_put_away *spare;   /* memory for them, NULL: none */
    /* torn */
    struct solid_lost *lost;
    uint8_t *known;          /* [s->n][bytes] bonds on record, bit b of the view */
    int torn, torn_capacity; /* the record */
    long record;             /* number of the record as it is */
    int *torn_h, *torn_l;    /* [torn] owned particle; the other: owned (once, h < l) or ghost */
    /* strangers */
    struct solid_strangers *strangers;
    struct solid_crossing crossing;
    struct solid_contact_springs *springs; /* work of solid_contact_rate_bound */
    /* work of solid_contact_force: accelerations, [s->n] m/s2, as multiples of a quantum: sums are the same in any
     * order */
    double *push[3], quantum;
};

struct solid_contact_springs *solid_contact_rate_springs_new(const struct solid *s);
void solid_contact_rate_springs_free(struct solid_contact_springs *springs);

/* scan: puts all torn bonds of a solid just met on record. news: those torn since the last look, into the lists as well
 * if nearer than reach. list: those on record that are near. Ghosts must be current. Not collective. */
void solid_contact_torn_scan(struct solid *s, struct solid_contact *c);
void solid_contact_torn_news(struct solid *s, struct solid_contact *c, double reach);
void solid_contact_torn_list(const struct solid *s, struct solid_contact *c);

struct solid_strangers *solid_contact_strangers_new(const struct solid *s);
void solid_contact_strangers_free(struct solid_strangers *strangers);
/* The near pairs of strangers, onto the lists. Bounds must be current. Collective. */
void solid_contact_strangers_list(struct solid *s, struct solid_contact *c);

/* Bounds of the bodies as they are now. Collective. */
void solid_contact_bounds_of(const struct solid *s, solid_contact_bounds *of);
/* Whether two bodies' bounds are within reach of each other, across periodic sides too. */
int solid_contact_bounds_near(const struct solid *s, const double *a, const double *b, double reach);
/* Whether a bond has broken, or two bodies are within reach, or one is so deformed that strangers of it might be. */
int solid_contact_bounds_touch(const struct solid *s, const solid_contact_bounds *of, double reach);
/* How far apart two of the body that are not of one family were at least at the start, m. */
double solid_contact_bounds_apart(const struct solid *s, int body);

/* X0 of one particle less that of another, m, as the places of bonds are: to 2^-32 spacing, so that mirror images
 * agree. */
static inline double solid_contact_list_between(const struct solid *s, double x0, double other) {
    return s->in.spacing * (0x1p-32 * __builtin_rint(0x1p32 * ((x0 - other) / s->in.spacing)));
}
