/* Fragments: connected components of intact bonds. */
#pragma once
#include "solid/state.h"

/* A fragment. id[n]: the smallest global id of its particles, the same name on all ranks. */
struct solid_fragment {
    long id;
    long particles;
    double mass, x[3], v[3]; /* kg, centre of mass m, mean velocity m/s */
    int held;                /* 1: contains a held or driven particle */
};
/* Returns the number of fragments; list (malloc'ed, on every rank, largest first) may be NULL. Collective. */
int solid_fragments_measure(struct solid *s, long *id, struct solid_fragment **list);
