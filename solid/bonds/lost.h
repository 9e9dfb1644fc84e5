/* Which particles have lost bonds since somebody last asked. s->broke is a set of bits: the force sweep sets it to
 * SOLID_BROKE_NEW; each reader takes its own note of it, so that none hides the news from the other. */
#pragma once
#include "solid/state.h"

enum solid_broke {
    SOLID_BROKE_NEW = 1,     /* nobody has looked yet */
    SOLID_BROKE_SURFACE = 2, /* the surface has yet to look */
    SOLID_BROKE_CONTACT = 4  /* contact has yet to look */
};

/* Whether bonds broke since `reader` last took it; clears it for that reader. Not collective. */
int solid_lost_take(struct solid *s, enum solid_broke reader);

struct solid_lost {
    int found;        /* of the last solid_lost_find */
    int *h;           /* [found] room for s->n */
    uint16_t *intact; /* [s->n] intact bonds when last looked at */
    int *row_intact; /* of the lattices' rows, one lattice after another: a row that has lost none is not looked into */
};

struct solid_lost *solid_lost_new(const struct solid *s); /* Not collective. */
void solid_lost_free(struct solid_lost *lost);
void solid_lost_copy(struct solid_lost *to, const struct solid_lost *from, const struct solid *s); /* not h */
/* Whoever has lost a bond is found again. */
void solid_lost_forget(struct solid_lost *lost, const struct solid *s);
/* The owned particles that have lost bonds since this was last called, into lost->h; returns how many. Not collective.
 */
int solid_lost_find(struct solid_lost *lost, const struct solid *s);
