/* The Verlet lists of pairs that may touch. For solid/ only.
 *
 * Broken-bond pair: two particles of one family whose bond has broken. Non-bonded pair: two particles that never shared
 * a bond. A broken-bond pair is recorded when its bond breaks; the lists hold those recorded pairs that are near.
 * Particles of a non-bonded pair can only meet if one of them has moved by half of their least initial distance, or if
 * the bounds of two bodies are near each other. */
#pragma once
#include "base/vec_type.h"
#include "solid/contact/ghosts.h"

struct solid_broken_tracker;
struct solid_contact_nonbonded;
struct solid_contact_ends;
struct solid_contact_implicit; /* opaque */
struct solid_contact_springs;  /* opaque */
struct solid_contact_retained; /* opaque */

enum { SOLID_CONTACT_BODIES = 256 }; /* solid.body is a byte, and solid.material */

/* Where the ends of a pair are, which decides who computes it. */
enum solid_contact_kind {
    SOLID_CONTACT_OWNED,      /* both owned here: computed once, for both ends */
    SOLID_CONTACT_BOND_GHOST, /* l is a ghost of the families (solid/bonds/ghosts.h): computed for h only */
    SOLID_CONTACT_GHOST,      /* l is the k-th contact ghost (solid/contact/ghosts.h): computed for h only */
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
    int starts_near;     /* 1: particles of one body may stand nearer than r_c at the start */
    double radius, skin; /* r_c; the distance beyond r_c up to which pairs are listed, m */
    double c0[SOLID_CONTACT_BODIES], density[SOLID_CONTACT_BODIES]; /* by material: N/m6, kg/m3; 0: of no particle */
    double *listed_d[3];                                            /* [s->n] d when the lists were built, m */
    uint8_t *is_fast;             /* [s->n + s->n_ghost] 1: a fast particle, whose skin is wider */
    uint8_t *is_fast_next;        /* work: is_fast of the next lists */
    double fast_skin;             /* the additional skin of a fast particle, m */
    int has_fast;                 /* some rank has a fast particle, when lists are built */
    solid_contact_bounds *bounds; /* [bodies] */
    struct solid_contact_pairs pairs[SOLID_CONTACT_KINDS];
    int any, reaches_ghosts;                /* 1: some rank has pairs; some rank has pairs with ghosts */
    struct solid_contact_retained *present; /* their holders; NULL: no snapshot */
    struct solid_contact_retained *spare;   /* memory for the next retained lists, NULL: none */
    /* broken-bond pairs */
    struct solid_broken_tracker *tracker;
    uint8_t *recorded;           /* [s->n][bytes] bonds in the record (solid_family_newly_broken) */
    int broken, broken_capacity; /* length and capacity of the record */
    long record;                 /* version number of the record */
    int *broken_h, *broken_l;    /* [broken] an owned particle; the other one: owned (once, h < l) or ghost */
    /* non-bonded pairs */
    struct solid_contact_nonbonded *nonbonded;
    struct solid_contact_ghosts ghosts;
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
static inline double solid_contact_list_reach(const struct solid_contact *c, int is_fast_h, int is_fast_l) {
    return c->radius + c->skin + (is_fast_h + is_fast_l) * c->fast_skin;
}

/* Broken-bond pairs. scan: records all of them, at the start. update: records the pairs whose bonds have broken since
 * the last check, and lists those that are nearer than the usual distance plus `further`, plus the distance that fast
 * particles may have moved. list: lists the recorded pairs that are near. Ghosts must be current. Not collective. */
void solid_contact_broken_scan(struct solid *s, struct solid_contact *c);
void solid_contact_broken_update(struct solid *s, struct solid_contact *c, double further);
void solid_contact_broken_list(const struct solid *s, struct solid_contact *c);

struct solid_contact_nonbonded *solid_contact_nonbonded_new(const struct solid *s);
void solid_contact_nonbonded_free(struct solid_contact_nonbonded *nonbonded);
/* Lists the near non-bonded pairs. Bounds must be current. Collective. */
void solid_contact_nonbonded_list(struct solid *s, struct solid_contact *c);

/* Present bounds of the bodies. Collective. */
void solid_contact_bounds_of(const struct solid *s, solid_contact_bounds *bounds);
/* Whether two bodies' bounds are within reach of each other, also across periodic sides. */
int solid_contact_bounds_near(const struct solid *s, const double *a, const double *b, double reach);
/* Whether a bond has broken, or two bodies are within reach, or a body is so deformed that a non-bonded pair in it may
 * be within reach. */
int solid_contact_bounds_touch(const struct solid *s, const solid_contact_bounds *bounds, double reach);
/* Least initial distance of two particles of a body that share no bond, m. */
double solid_contact_bounds_least_unbonded(const struct solid *s, int body);

/* X0 of one particle minus that of another, m, rounded to 2^-32 spacing as in the bonds, so that mirror images
 * agree. */
static inline double solid_contact_list_initial_offset(const struct solid *s, double x0, double other) {
    return s->in.spacing * (0x1p-32 * __builtin_rint(0x1p32 * ((x0 - other) / s->in.spacing)));
}

/* Rounds to a multiple of the quantum, by the last digit of a number of suitable size. */
static inline double solid_contact_list_rounded(double x, double quantum) {
    const double magic = 0x1.8p52 * quantum;
    return (x + magic) - magic;
}
static inline vec solid_contact_list_rounded_vec(vec x, vec quantum) {
    const vec magic = 0x1.8p52 * quantum;
    return (x + magic) - magic;
}
