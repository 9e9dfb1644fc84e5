/* The general store: for each owned particle a list of bonds. Nothing is assumed of where particles stand; volume and
 * horizon may differ from one to the next. Order of a family: by offset on a lattice, by global id otherwise.
 *
 * A bond knows where its other end's record is and what is dear to compute again: 21 bytes. Records hold what a sweep
 * reads of a particle, in a cache line: owned particles in their order, then ghosts and periodic images. Places are
 * rounded to multiples of the last digit of the largest, so that xi = X0_l - X0_h is exact, images included, and the
 * same from both ends but for its sign. */
#pragma once
#include "solid/store.h"

enum {
    SOLID_LIST_PLACE = 8, /* numbers of a record: X0 (3, m), w = V/V0, d (3, m), nothing */
    SOLID_LIST_SPEED = 4, /* and of the other, read with damping only: v (3, m/s), nothing */
    SOLID_LIST_SLACK = 8  /* places behind the last bond: bonds are read by eights */
};

struct solid_list {
    struct solid_law law;
    double full_volume; /* V0, m3 */
    double period[3];   /* m, 0: not periodic */
    int first, n;       /* local indices first .. first+n-1 */
    int others;         /* ghosts and images */
    long bonds;
    long *start;        /* [n+1] */
    long *key;          /* [bonds] of the other end: its global id and image, while being set up */
    int *record;        /* [bonds] of the other end */
    double *inv_length; /* [bonds] 1/|xi| */
    double *weight;     /* [bonds] Gamma V_l, m3 */
    uint8_t *intact;    /* [bonds] */
    uint8_t *large;     /* [n] 1: a bond's |eps| was too large for the series */
    long *other_key;    /* [others] ascending */
    int *other_local;   /* [others] */
    double *place;      /* [n + others][SOLID_LIST_PLACE] */
    double *speed;      /* [n + others][SOLID_LIST_SPEED] */
};

struct solid_list *solid_list_new(const struct solid_input *in, const struct solid_body *body,
                                  const struct solid_sites *sites, const struct solid_stencil *stencil,
                                  struct solid_law law, long from, long to, int first);
void solid_list_free(struct solid_list *list);
long solid_list_wanted(const struct solid_list *list, long from, long to, long *id);
void solid_list_link(struct solid_list *list, const struct solid_numbering *numbering);
void solid_list_volumes(const struct solid_list *list, double *family_volume);
/* Once x0 and family_volume are known, ghosts too. Collective. */
void solid_list_weights(struct solid_list *list, double *const x0[3], const double *family_volume,
                        int surface_correction);
int solid_list_longest(const struct solid_list *list);
/* The bond opposite to bond j of particle h, whose other end is owned here, or -1. */
long solid_list_reverse(const struct solid_list *list, int h, long j);

/* Local index of a record's particle. */
static inline int solid_list_local(const struct solid_list *t, int record) {
    return record < t->n ? t->first + record : t->other_local[record - t->n];
}

/* X0_l - X0_h of bond j of particle h, m. */
static inline void solid_list_xi(const struct solid_list *t, int h, long j, double xi[3]) {
    const double *far = t->place + (long)SOLID_LIST_PLACE * t->record[j],
                 *here = t->place + (long)SOLID_LIST_PLACE * (h - t->first);
    for (int c = 0; c < 3; c++) xi[c] = far[c] - here[c];
}

/* Surface correction of bond j of particle h. */
static inline double solid_list_alpha(const struct solid_list *t, int h, long j) {
    return 2 / (t->place[(long)SOLID_LIST_PLACE * (h - t->first) + 3] +
                t->place[(long)SOLID_LIST_PLACE * t->record[j] + 3]);
}

/* As solid_lattice_force_begin and _end in one. */
double solid_list_force(struct solid *s, struct solid_list *list, const struct solid_sweep *sweep);
