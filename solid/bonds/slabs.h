/* Layers of a lattice's segments that threads sweep. A segment adds reactions to later sites, also of the next slab,
 * but of no slab after that. So the even slabs are swept in parallel, then the odd ones. Sums depend on the
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
