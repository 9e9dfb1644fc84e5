/* The lists of pairs that may touch. For solid/ only.
 *
 * Torn pair: two particles of one family whose bond has broken. Stranger pair: two particles that never shared a bond.
 * A torn pair is recorded when its bond breaks, and the pairs near each other are selected from the record. Strangers
 * can only meet if one of them has moved by half of their least initial distance, or if two bodies' bounds are near
 * each other. */
#pragma once
#include "base/vec.h"
#include "solid/contact/crossing.h"

struct solid_broken_tracker;
struct solid_strangers;
struct solid_contact_ends;
struct solid_contact_implicit; /* opaque */
struct solid_contact_springs;  /* opaque */
struct solid_contact_put_away; /* opaque */

enum { SOLID_CONTACT_BODIES = 256 }; /* solid.body is a byte, and solid.material */

/* Where the ends of a pair are, which decides who computes it. */
enum solid_contact_kind {
    SOLID_CONTACT_OWNED,  /* both owned here: computed once, for both ends */
    SOLID_CONTACT_GHOST,  /* l is a ghost: computed for h only */
    SOLID_CONTACT_SERVED, /* l is the k-th particle served by another rank: computed for h only */
    SOLID_CONTACT_KINDS
};

struct solid_contact_pairs {
    int dim, n, capacity;
    int *h, *l;    /* [n] an owned particle, and the other one */
    double *xi[3]; /* [n] X0_h - X0_l for the image nearest at listing, m; two components in a plate */
};

/* Bounds of a body over all ranks, lowest and negated highest: positions (0-5), displacements (6-11), m; 12: 0 if a
 * bond has broken; 13: 0 if a particle of it is held. */
typedef double solid_contact_bounds[14];

struct solid_contact {
    int begins_near;     /* 1: particles of one body may stand nearer than r_c at the start */
    double radius, skin; /* r_c; the distance beyond r_c up to which pairs are listed, m */
    double c0[SOLID_CONTACT_BODIES], density[SOLID_CONTACT_BODIES]; /* by material: N/m6, kg/m3; 0: of no particle */
    double *built[3];                                               /* [s->n] d when the lists were made, m */
    uint8_t *runs;      /* [s->n + s->n_ghost] 1: a runner, a particle that is so fast that its skin is wider */
    uint8_t *runs_next; /* work: those of the next lists */
    double wider;       /* by so much, m */
    int has_runners;    /* some rank has one, when lists are made */
    solid_contact_bounds *bounds; /* [bodies] */
    struct solid_contact_pairs pairs[SOLID_CONTACT_KINDS];
    int any, reaches_ghosts;                /* 1: some rank has pairs; some rank has pairs with ghosts */
    struct solid_contact_put_away *present; /* holders of the present lists (solid/contact/keep.h), NULL: no kept
                                             * state */
    struct solid_contact_put_away *spare;   /* memory for the next lists moved aside, NULL: none */
    /* torn pairs */
    struct solid_broken_tracker *tracker;
    uint8_t *known;          /* [s->n][bytes] bonds in the record (solid_family_torn) */
    int torn, torn_capacity; /* length and capacity of the record */
    long record;             /* version number of the record */
    int *torn_h, *torn_l;    /* [torn] an owned particle; the other one: owned (once, h < l) or ghost */
    /* stranger pairs */
    struct solid_strangers *strangers;
    struct solid_crossing crossing;
    struct solid_contact_springs *springs;   /* work of solid_contact_rate_bound */
    struct solid_contact_ends *ends;         /* copies of the particles in the lists (solid/contact/ends.h) */
    struct solid_contact_implicit *implicit; /* work of solid/contact/implicit.h, NULL: not yet used */
    double quantum; /* of accelerations, m/s2: they are summed as multiples of it, the same in any order */
};

void solid_contact_implicit_free(struct solid_contact_implicit *m);
struct solid_contact_springs *solid_contact_rate_springs_new(const struct solid *s);
void solid_contact_rate_springs_free(struct solid_contact_springs *springs);
/* The largest eigenvalue of a symmetric tensor xx, yy, zz, xy, xz, yz that is not negative, at most 2 % high. */
double solid_contact_rate_largest(const double tensor[6]);

/* Two particles are listed if they are nearer than this, m. */
static inline double solid_contact_list_reach(const struct solid_contact *c, int runs_h, int runs_l) {
    return c->radius + c->skin + (runs_h + runs_l) * c->wider;
}

/* scan: records all torn pairs of a solid, at the start. news: records those torn since the last check, and lists them
 * if they are nearer than usual by `further`, and by as much as runners may have moved more. list: lists the recorded
 * pairs that are near. Ghosts must be current. Not collective. */
void solid_contact_torn_scan(struct solid *s, struct solid_contact *c);
void solid_contact_torn_news(struct solid *s, struct solid_contact *c, double further);
void solid_contact_torn_list(const struct solid *s, struct solid_contact *c);

struct solid_strangers *solid_contact_strangers_new(const struct solid *s);
void solid_contact_strangers_free(struct solid_strangers *strangers);
/* Lists the near pairs of strangers. Bounds must be current. Collective. */
void solid_contact_strangers_list(struct solid *s, struct solid_contact *c);

/* Present bounds of the bodies. Collective. */
void solid_contact_bounds_of(const struct solid *s, solid_contact_bounds *of);
/* Whether two bodies' bounds are within reach of each other, also across periodic sides. */
int solid_contact_bounds_near(const struct solid *s, const double *a, const double *b, double reach);
/* Whether a bond has broken, or two bodies are within reach, or one is so deformed that strangers in it may be. */
int solid_contact_bounds_touch(const struct solid *s, const solid_contact_bounds *of, double reach);
/* Least initial distance of two particles of a body that share no bond, m. */
double solid_contact_bounds_apart(const struct solid *s, int body);

/* X0 of one particle minus that of another, m, rounded to 2^-32 spacing as in the bonds, so that mirror images
 * agree. */
static inline double solid_contact_list_between(const struct solid *s, double x0, double other) {
    return s->in.spacing * (0x1p-32 * __builtin_rint(0x1p32 * ((x0 - other) / s->in.spacing)));
}

/* Rounds to a multiple of the quantum, by the last digit of a number of suitable size. */
static inline double solid_contact_list_rounded(double x, double quantum) {
    const double magic = 0x1.8p52 * quantum;
    return (x + magic) - magic;
}
static inline vec solid_contact_list_rounded_some(vec x, vec quantum) {
    const vec magic = 0x1.8p52 * quantum;
    return (x + magic) - magic;
}
