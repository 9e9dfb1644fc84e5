/* The general store: for each owned particle a list of bonds, in a plate or in space. Nothing is assumed of where
 * particles stand; volume and horizon may differ from one to the next. Order of a family: by xi, z, then y, then x.
 *
 * A bond is 20 bytes in a plate and 24 in space: where the record of its other end is, xi, the stiffness, and whether
 * it is intact in the stiffness's sign. Places are multiples of 2^-20 spacing (solid/body/cloud.h), so xi is exact in
 * single precision, and the same from both ends but for its sign. Families start at multiples of eight bonds and are
 * filled up with broken bonds of a particle with itself. Records hold the displacements of owned particles in their
 * order, then of ghosts and periodic images. */
#pragma once
#include "base/vec.h"
#include "solid/body/cloud.h"
#include "solid/bonds/store.h"

#include <math.h>

enum {
    SOLID_LIST_BLOCK = 8, /* bonds are read by eights */
    SOLID_LIST_SPEED =
        4 /* numbers of a record read with damping only: v (2 or 3, m/s), nothing; the last is w = V/V0 */
};

struct solid_pairs_kept;
enum { SOLID_LIST_SCALED = 1, SOLID_LIST_LINKED = 2 }; /* linked: as well, and to owned particles only */

struct solid_list {
    struct solid_bond_law law;
    int dim;
    int width;                     /* numbers of a record: d in spacings, 2 in a plate, 3 and nothing in space */
    double spacing, unit;          /* m; m3 in spacings^dim */
    double period[3];              /* spacings, 0: not periodic */
    long first_id;                 /* global id of the body's number 0 */
    long number;                   /* of the first particle here */
    int first, n;                  /* local indices first .. first+n-1 */
    int others;                    /* ghosts and images */
    long bonds, room;              /* bonds there are, places for them */
    long *start, *end;             /* [n] the family's: start[i] .. end[i]-1 */
    int *at;                       /* [room] where in the records the other end's starts */
    float *step;                   /* [room][dim] xi by eights of bonds: x of all, y of all, z of all */
    double *stiffness;             /* [room] K alpha V_l/(rho |xi|), m/s2; its sign is set when the bond is broken */
    uint8_t *large;                /* [n] 1: a bond's |eps| was too large for the series */
    double *limit;                 /* [n] the least eps at which a bond of the family breaks */
    double *digit;                 /* [n] a plate's sums (solid/force/sweep_family.h): of the family */
    double *power;                 /* [n] and of the last sweep */
    double *own_volume;            /* [n] V_h = sum of Gamma_h(l) V_l, spacings^dim */
    double *damage;                /* [n] as found when .. */
    int *counted;                  /* [n] .. one less of its bonds were intact; 0: not found yet */
    long *other_key;               /* [others] ascending: global id and image */
    int *other_local;              /* [others] */
    struct solid_end *particle;    /* [n + others] */
    double *w;                     /* [n + others] V/V0 */
    double *record;                /* [n + others][width] */
    double *speed;                 /* [n + others][SOLID_LIST_SPEED] */
    long *key;                     /* [room] of the other end: its global id and image; while being set up */
    uint8_t *scaled;               /* [n] SOLID_LIST_SCALED: of before the last renewal, alpha is in the stiffness */
    struct solid_pairs_kept *kept; /* while being set up */
};

/* Set up in four steps: the families of the owned ids; the ids of others that they need; where these are known here;
 * the surface correction, once V_h is known of all. The cloud is borrowed until the last. Not collective. */
struct solid_list *solid_list_find_new(const struct solid_cloud *cloud, long from, long to, int first);
long solid_list_wanted(const struct solid_list *list, long from, long to, long *id);
void solid_list_link(struct solid_list *list, const struct solid_cloud *cloud, const struct solid_numbering *numbering);
void solid_list_volumes(const struct solid_list *list, double *family_volume); /* m3, of the owned */
void solid_list_weights(struct solid_list *list, const double *family_volume, int surface_correction);
void solid_list_free(struct solid_list *list);

/* The first step, when the cloud has changed: old is the list (set up to the end) of the cloud before, was [n of the
 * cloud] the numbers there, -1: new. A rank's old particles keep their order, and its new ones stand behind them.
 * Families within reach of a particle that is new, gone, or has another place, size, volume or horizon are found anew,
 * and a pair that existed keeps its lambda; the others are copied. Not collective. */
struct solid_list *solid_list_renew(const struct solid_list *old, const struct solid_cloud *before,
                                    const struct solid_cloud *cloud, const long *was, long from, long to, int first);

int solid_list_longest(const struct solid_list *list);
long solid_list_intact(const struct solid_list *list); /* directed bonds */
/* Exchanges lambda of all bonds with that of intact [room]. */
void solid_list_swap(struct solid_list *list, uint8_t *intact);
/* The bond opposite to bond j of particle h, whose other end is owned here, or -1. */
long solid_list_reverse(const struct solid_list *list, int h, long j);

/* Local index of a record's particle. */
static inline int solid_list_local(const struct solid_list *t, int record) {
    return record < t->n ? t->first + record : t->other_local[record - t->n];
}

/* The record of bond j's other end, and its local index. */
static inline int solid_list_record(const struct solid_list *t, long j) { return t->at[j] / t->width; }
static inline int solid_list_other(const struct solid_list *t, long j) {
    return solid_list_local(t, solid_list_record(t, j));
}

static inline int solid_list_is_intact(const struct solid_list *t, long j) { return !signbit(t->stiffness[j]); }
/* The same of eight bonds from j, the first of a block: bit k of bond j + k. What fills a family up counts as broken.
 */
static inline unsigned solid_list_block_intact(const struct solid_list *t, long j) {
    return ~vec_signs(vec_load(t->stiffness + j)) & 0xffu;
}
static inline void solid_list_set(struct solid_list *t, long j, int intact) {
    t->stiffness[j] = copysign(t->stiffness[j], intact ? 1 : -1);
}

/* X0_l - X0_h of bond j in direction c, spacings. */
static inline float *solid_list_step(const struct solid_list *t, long j, int c) {
    return t->step + (j / SOLID_LIST_BLOCK * t->dim + c) * SOLID_LIST_BLOCK + j % SOLID_LIST_BLOCK;
}

/* All of it, spacings; the third is 0 in a plate. Returns |xi|. */
static inline double solid_list_steps(const struct solid_list *t, long j, double xi[3]) {
    double xi2 = 0;
    xi[2] = 0;
    for (int c = 0; c < t->dim; c++) {
        xi[c] = *solid_list_step(t, j, c);
        xi2 += xi[c] * xi[c];
    }
    return sqrt(xi2);
}

/* The same, m. */
static inline void solid_list_xi(const struct solid_list *t, long j, double xi[3]) {
    solid_list_steps(t, j, xi);
    for (int c = 0; c < 3; c++) xi[c] *= t->spacing;
}

/* Surface correction of bond j of particle h. */
static inline double solid_list_alpha(const struct solid_list *t, int h, long j) {
    return 2 / (t->w[h - t->first] + t->w[solid_list_record(t, j)]);
}

/* Its micromodulus, N/m6, and Gamma V_l, m3: their product is K V_l (solid/law/pair.h). */
double solid_list_micromodulus(const struct solid_list *list, int h, long j);
double solid_list_weight(const struct solid_list *list, int h, long j, double micromodulus);
/* 1 - sum(lambda Gamma V)/sum(Gamma V) of particle h. */
double solid_list_damage(struct solid_list *list, int h);
/* eps at which it breaks. */
double solid_list_limit(const struct solid_list *list, int h, long j);

/* Room for a plate's sums of the i-th family (solid/force/sweep_family.h). 1.5 2^L, 2^L at least the number of bonds:
 * the shift in powers of two above all components, halved. */
static inline double solid_list_room(const struct solid_list *b, int i) {
    const unsigned blocks = (unsigned)((b->end[i] - b->start[i] + VEC_LANES - 1) / VEC_LANES);
    return 1.5 * VEC_LANES * (blocks > 1 ? 1u << (32 - __builtin_clz(blocks - 1)) : 1);
}
