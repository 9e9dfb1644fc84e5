/* The list store of bonds: a list of bonds for each owned particle, in a plate or in 3D. Particles may be at any
 * positions; each may have its own volume and horizon. A family is ordered by xi: z, then y, then x.
 *
 * A bond takes 20 bytes in a plate and 24 in 3D: the index of the record of its other end, xi, and the stiffness, whose
 * sign tells whether the bond is intact. Positions are multiples of 2^-20 spacing (solid/body/cloud.h), so xi is exact
 * in single precision, and has equal size and opposite sign at both ends. Families start at multiples of eight bonds
 * and are padded to a multiple of eight with broken self-bonds. Records hold the displacements of owned particles in
 * their order, then those of ghosts and periodic images. */
#pragma once
#include "solid/bonds/interface.h"
#include "solid/bonds/store.h"

#include <math.h>

enum {
    SOLID_LIST_BLOCK = 8, /* bonds are read in blocks of eight */
    SOLID_LIST_SPEED = 4  /* numbers of a record that is read with damping only: v (2 or 3, m/s), padding, w = V/V0 */
};

struct solid_pair_cache;
struct solid_list_rows;
enum { SOLID_LIST_SCALED = 1, SOLID_LIST_LINKED = 2 }; /* LINKED: also SCALED, with bonds to owned particles only */

struct solid_list {
    struct solid_bond_law law;
    int dim;
    int width;            /* numbers of a record: d in spacings; 2 in a plate, 3 and one of padding in 3D */
    double spacing, unit; /* m; m3 in spacings^dim */
    double period[3];     /* spacings, 0: not periodic */
    long first_id;        /* global id of the body's number 0 */
    long number;          /* number of the first particle on this rank */
    int first, n;         /* local indices first .. first+n-1 */
    int others;           /* number of ghosts and images */
    long bonds, capacity; /* number of bonds; capacity of the arrays */
    long *start, *end;    /* [n] the bonds of a family: start[i] .. end[i]-1 */
    int *at;              /* [capacity] index of the other end in record */
    float *step;          /* [capacity][dim] xi in blocks of eight bonds: x of all eight, y of all, z of all */
    double *stiffness;    /* [capacity] K alpha V_l/(rho |xi|), m/s2; negative: the bond is broken */
    uint8_t *soft;        /* [capacity/8] bits: the bond is intact and softens (solid/bonds/soft.h), and its
                           * stiffness is negative; NULL: brittle */
    uint8_t *large;       /* [n] 1: |eps| of some bond was too large for the series */
    double *eps_limit;    /* [n] the least eps at which a bond of the family breaks */
    double *digit;        /* [n] rounding digit of a plate's sums (solid/force/sweep_family.h): the family's
                           * factor */
    double *power;        /* [n] and the factor of the last sweep */
    /* of families with a dilatation (solid/force/dilatation.h); NULL: bonds alone */
    double *pressure;           /* [n + others] */
    double *plain;              /* [capacity] |stiffness| without alpha */
    double *extension_digit;    /* [n] as digit, of the sums of extensions */
    double *extension_power;    /* [n] as power */
    double *own_volume;         /* [n] V_h = sum of Gamma_h(l) V_l, spacings^dim */
    double *damage;             /* [n] damage, computed when .. */
    int *counted;               /* [n] .. this number, less one, of its bonds were intact; 0: not computed yet */
    long *other_key;            /* [others] ascending: global id and image */
    int *other_local;           /* [others] */
    struct solid_end *particle; /* [n + others] */
    double *w;                  /* [n + others] alpha = 2/(w_h + w_l) */
    double *record;             /* [n + others][width] */
    double *speed;              /* [n + others][SOLID_LIST_SPEED]; NULL before the first damped sweep */
    int interfaces;             /* of the body */
    struct solid_interface_side *interface; /* [interfaces] owned; NULL: none */
    uint8_t *interface_of;                  /* [others] 0: of this body, else 1 + the interface; NULL: no interfaces */
    long *key;                              /* [capacity] during the set-up: global id and image of the other end */
    uint8_t *scaled;                     /* [n] SOLID_LIST_SCALED: the family was copied in a renewal, and its stiffness
                                          * contains alpha */
    struct solid_pair_cache *pair_cache; /* during the set-up; of a plate */
    struct solid_list_rows *rows;        /* of a plate's lattice (solid/bonds/list_rows.h); NULL: none */
};

/* To be called when lambda of bond j has changed, if there are rows. */
void solid_list_rows_changed(struct solid_list *list, long j);

/* The set-up has four steps: find the families of the owned ids; list the ids of others that they need; link both to
 * local particles; compute the surface correction, once V_h of all is known. The cloud is borrowed until the last step.
 * Not collective. */
/* interface [interfaces]: those of the body, owned by the list from then on; NULL: none. */
struct solid_list *solid_list_find_new(const struct solid_cloud *cloud, struct solid_interface_side *interface,
                                       int interfaces, long from, long to, int first);
long solid_list_wanted(const struct solid_list *list, long from, long to, long *id);
void solid_list_link(struct solid_list *list, const struct solid_cloud *cloud, const struct solid_numbering *numbering);
/* V_h of the owned particles, m3.  (001: eq. 3.44) */
void solid_list_volumes(const struct solid_list *list, double *family_volume);
/* V_h/V0 of the owned particles, by local index. */
void solid_list_ratios(const struct solid_list *list, const double *family_volume, double *ratio);
/* Sets w, by local index, from which alpha follows (solid/bonds/correction.h).  (001: eq. 3.43, mended) */
void solid_list_weights(struct solid_list *list, const double *w);
/* The arrays of families with a dilatation, once the stiffnesses are known; and the pressure, by local index. */
void solid_list_pressure_new(struct solid_list *list);
void solid_list_pressure_set(struct solid_list *list, const double *pressure);
void solid_list_free(struct solid_list *list);

/* The first step after the cloud has changed. old: the complete list of the cloud before. was [n of the cloud]: numbers
 * in that cloud, -1: new. A rank's old particles keep their order, and its new ones come after them. Families within
 * reach of a particle that is new, was removed, or has another position, size, volume or horizon are found again, and a
 * bond that existed keeps its lambda. The other families are copied. Not collective. */
struct solid_list *solid_list_renew(const struct solid_list *old, const struct solid_cloud *before,
                                    const struct solid_cloud *cloud, const long *was, long from, long to, int first);

int solid_list_longest(const struct solid_list *list);
long solid_list_intact(const struct solid_list *list); /* number of directed bonds */
/* Exchanges lambda of all bonds with the values in intact [capacity]. */
void solid_list_swap(struct solid_list *list, uint8_t *intact);
/* The bond of the other end that is opposite to bond j of particle h, in the list of the other end's body, or -1 if
 * that end is not owned here. */
long solid_list_reverse(const struct solid_list *list, const struct solid_list *other, int h, long j);

/* Local index of the particle of a record. */
static inline int solid_list_local(const struct solid_list *list, int record) {
    return record < list->n ? list->first + record : list->other_local[record - list->n];
}

/* Record of the other end of bond j; and its local index. */
static inline int solid_list_record(const struct solid_list *t, long j) { return t->at[j] / t->width; }
static inline int solid_list_other(const struct solid_list *list, long j) {
    return solid_list_local(list, solid_list_record(list, j));
}

/* Whether the sweep computes bond j: it is intact and does not soften. */
static inline int solid_list_is_swept(const struct solid_list *t, long j) { return !signbit(t->stiffness[j]); }
static inline int solid_list_is_soft(const struct solid_list *t, long j) {
    return t->soft && (t->soft[j / SOLID_LIST_BLOCK] >> j % SOLID_LIST_BLOCK & 1);
}
static inline int solid_list_is_intact(const struct solid_list *t, long j) {
    return solid_list_is_swept(t, j) || solid_list_is_soft(t, j);
}
static inline void solid_list_set(struct solid_list *list, long j, int intact) {
    const int was = solid_list_is_swept(list, j);
    list->stiffness[j] = copysign(list->stiffness[j], intact ? 1 : -1);
    if (list->rows && was != (intact != 0)) solid_list_rows_changed(list, j);
}
/* Marks an intact bond as softening, which takes it out of the sweep, or as elastic again. */
static inline void solid_list_soften(struct solid_list *list, long j, int softens) {
    uint8_t *soft = &list->soft[j / SOLID_LIST_BLOCK];
    *soft = (uint8_t)((*soft & ~(1u << j % SOLID_LIST_BLOCK)) | (unsigned)softens << j % SOLID_LIST_BLOCK);
    solid_list_set(list, j, !softens);
}

/* X0_l - X0_h of bond j in direction c, spacings. */
static inline float *solid_list_step(const struct solid_list *list, long j, int c) {
    return list->step + (j / SOLID_LIST_BLOCK * list->dim + c) * SOLID_LIST_BLOCK + j % SOLID_LIST_BLOCK;
}

/* The vector xi, spacings; the third component is 0 in a plate. Returns |xi|. */
static inline double solid_list_steps(const struct solid_list *list, long j, double xi[3]) {
    double xi2 = 0;
    xi[2] = 0;
    for (int c = 0; c < list->dim; c++) {
        xi[c] = *solid_list_step(list, j, c);
        xi2 += xi[c] * xi[c];
    }
    return sqrt(xi2);
}

/* The same in m. */
static inline void solid_list_xi(const struct solid_list *list, long j, double xi[3]) {
    solid_list_steps(list, j, xi);
    for (int c = 0; c < 3; c++) xi[c] *= list->spacing;
}

/* The interface that bond j crosses, or NULL. */
static inline const struct solid_interface_side *solid_list_interface(const struct solid_list *list, long j) {
    const int other = list->interface_of ? solid_list_record(list, j) - list->n : -1;
    return other < 0 || !list->interface_of[other] ? NULL : &list->interface[list->interface_of[other] - 1];
}

/* Surface correction of bond j of particle h. */
static inline double solid_list_alpha(const struct solid_list *list, int h, long j) {
    return 2 / (list->w[h - list->first] + list->w[solid_list_record(list, j)]);
}

/* Micromodulus of the bond, N/m6, and Gamma V_l, m3: their product is K V_l (solid/law/pair.h). */
double solid_list_micromodulus(const struct solid_list *list, int h, long j);
double solid_list_weight(const struct solid_list *list, int h, long j, double micromodulus);
/* 1 - sum(lambda Gamma V)/sum(Gamma V) of particle h. */
double solid_list_damage(struct solid_list *list, int h);
/* eps at which the bond breaks; and the energy per area of all bonds across a crack there (solid/law/material.h). */
double solid_list_limit(const struct solid_list *list, int h, long j);
double solid_list_bonds_energy(const struct solid_list *list, long j);

/* Half of the shift of a plate's sums over the i-th family, in units of the power of two above all components
 * (solid/force/sweep_family.h): 1.5 2^L, with 2^L at least the number of bonds. */
static inline double solid_list_headroom(const struct solid_list *list, int i) {
    const unsigned blocks = (unsigned)((list->end[i] - list->start[i] + SOLID_LIST_BLOCK - 1) / SOLID_LIST_BLOCK);
    return 1.5 * SOLID_LIST_BLOCK * (blocks > 1 ? 1u << (32 - __builtin_clz(blocks - 1)) : 1);
}
