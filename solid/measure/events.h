/* Events of fracture: the bonds that broke in a step, put together to clusters.
 *
 * Two bonds of one step belong to one event if an end of one is no farther than `reach` from an end of the other; so do
 * bonds that a chain of such bonds joins. Places are those at the start, X0: an event belongs to the material. All
 * functions are pure but for solid_events_take. */
#pragma once
#include "solid/bonds/breaks.h"

struct solid_event {
    double t; /* s */
    long step, bonds;
    double centre[3]; /* of the bonds' middles, by area, m. The middles are taken at their nearest images to the first;
                       * across a periodic side the centre is in the period */
    double normal[3]; /* of the crack: the principal direction of sum of area xi xi^T/|xi|^2 with the largest value,
                       * length 1, its largest component positive */
    double alignment; /* that value over the sum of all three: 1 for one bond; 1/2 for a plane crack in space, 2/3 in a
                       * plate; 1/3 (1/2) if the bonds have no common direction */
    double area, energy; /* sums, m2, J */
};

/* All ranks' records, which are dropped there: a bond is in the list once, in the order of its step, place and xi, which
 * is the same on any number of ranks. Returns how many; the list is malloc'ed. Collective. */
long solid_events_take(struct solid *s, struct solid_break **list);
/* Sorts n records and puts the halves of each bond together. Returns how many bonds there are. */
long solid_events_join(struct solid_break *list, long n);
/* The events of n joined bonds, in the order of their steps, then of the first bond of each; malloc'ed. Returns how
 * many. */
long solid_events_of(const struct solid_break *bond, long n, double reach, const int periodic[3],
                     const double length[3], struct solid_event **event);
/* The largest horizon of the solid's materials, m: the reach of an event. */
double solid_events_reach(const struct solid_input *in);
