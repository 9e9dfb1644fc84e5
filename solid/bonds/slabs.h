/* Layers of a lattice's segments that threads sweep. A segment adds reactions to sites after its own, also of the next
 * slab, but of none after that: so every other slab can be swept at once, and then the ones between. Sums depend on the
 * number of threads in their last digits, and on nothing else. */
#pragma once

struct solid_lattice;
struct solid_segments;

struct solid_slabs {
    int n;
    int *first;   /* [n+1] places in `segment`; NULL: one thread */
    int *segment; /* the segments, slab by slab, in each in their own order */
};

/* Of the segments from .. to-1: about two slabs for each thread, as far as the layers along z are enough. Not
 * collective. */
struct solid_slabs solid_slabs_new(const struct solid_lattice *lattice, const struct solid_segments *segments, int from,
                                   int to);
void solid_slabs_free(struct solid_slabs *slabs);
