/* Fragments: connected components of intact bonds. */
#pragma once
#include "solid/state.h"

/* Connected components of intact bonds. id[n]: the smallest global id of the fragment, a name that all ranks share. */
struct solid_fragment {
    long id;
    long particles;
    double mass, x[3], v[3]; /* kg, centre of mass m, mean velocity m/s */
    int held;                /* has a held or driven particle */
};
/* Returns the number of fragments; list (malloc'ed, on every rank, largest first) may be NULL. Collective. */
int solid_fragments_measure(struct solid *s, long *id, struct solid_fragment **list);
