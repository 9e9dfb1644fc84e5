/* Global ids: the ranks that own them, and the copies that a rank needs. For solid/ only. */
#pragma once
#include "solid/body/sites.h"

/* first [size+1]: divides the ids so that ranks have equal work; rows of eight sites are not divided. Collective. */
void solid_number_divide(struct solid_sites *const *sites, int bodies, int general_bonds, long *first);

/* Local index of a global id: owned 0..n-1, ghosts n.. (ghost ids ascend), -1: not on this rank. */
struct solid_numbering {
    long from, to; /* owned ids */
    int ghosts;
    const long *ghost_id;
};
int solid_number_local(const struct solid_numbering *numbering, long id);
