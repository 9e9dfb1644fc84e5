/* Fragments followed in time: each has a number, the piece it came off from, and the time at which it came off.
 *
 * When a piece breaks, its part with the most particles (of equally large ones that with the smallest id; in a refined
 * plate, where ids depend on the ranks, that with the particle that is first in x, then in y) keeps the piece's number
 * and time; every other part gets the next free number and the time of the update that finds it. */
#pragma once
#include "solid/measure/fragments.h"

/* Begins to track pieces in s->fragment and s->fragment_since; without effect if they are tracked already. Not
 * collective. */
void solid_detachment_begin(struct solid *s);

struct solid_detachment {
    long number;  /* from 0, without gaps */
    long from;    /* number of the piece that it came off from; -1: it was there at the first update, or is not new */
    double since; /* time of the update that found it, s */
    int is_new;   /* 1: this update found it */
};
/* Measures the fragments and numbers them: list and record, each [n] malloc'ed, the largest first; id [s->n], may be
 * NULL, as there. Returns n. Collective. */
int solid_detachment_update(struct solid *s, double t, long *id, struct solid_fragment **list,
                            struct solid_detachment **record);

/* Volume, and largest extent: the largest of the extents along the directions of a cube's edges, face diagonals and
 * space diagonals, plus a spacing. It is at most 12 % (in a plate 8 %) less than the largest distance of two particles.
 * centre: of mass. A fragment that lies across a periodic side is put together first, if it is shorter than half the
 * period. */
struct solid_detachment_size {
    double volume, extent, centre[3]; /* m3, m, m */
};
/* Of the fragments list[which[k]], k < n; id [s->n] as measured. Collective. */
void solid_detachment_sizes(const struct solid *s, const long *id, const struct solid_fragment *list, int n,
                            const int *which, struct solid_detachment_size *size);
