/* A record of the bonds that break in force sweeps, for those who read it later (solid/measure/events.h). For solid/,
 * coupling/ and program/.
 *
 * Each owner of an end records its own half of a bond; solid_events_join puts the halves together. Initial cracks and
 * bonds that a refinement leaves out are not in it. A state that is kept in memory holds how many records there were:
 * when it is restored, later records are taken back, and those that had been read already are not made again by the
 * steps that follow, which are the same to the bit. */
#pragma once
#include "solid/state.h"

struct solid_break {
    double x[3];         /* X0 of the end that comes first in x, then y, then z, m */
    double xi[3];        /* from there to the other end, across periodic sides, m; z of a plate is 0 */
    double energy, area; /* what the break has added to e_fracture, of a softening bond in all its time, J; to
                          * crack_area, m2 */
    double t;            /* s, at the end of the step */
    long step;
};

struct solid_breaks {
    long n, capacity;
    struct solid_break *record; /* [n] */
    long read;                  /* records taken so far: record[0] is that number */
    long made;                  /* records made so far; stored in snapshots */
    long stamped;               /* records that have their step */
};

/* Begins to record: s->breaks; without effect if that was done before. Not collective, nor is any function here. */
void solid_breaks_begin(struct solid *s);
void solid_breaks_free(struct solid_breaks *b);
/* Records a bond of h, or of h and l where both are owned here. */
void solid_breaks_add(struct solid *s, int h, int l, const double xi[3], double energy, double area);
/* Gives step and t to the records that were made since the last call. */
static inline int solid_breaks_is_due(const struct solid_breaks *b) { return b && b->made != b->stamped; }
void solid_breaks_stamp(struct solid_breaks *b, long step, double t);
/* Goes back to the first `made` records. */
void solid_breaks_restore(struct solid_breaks *b, long made);
/* The records have been read and are dropped. */
void solid_breaks_drop(struct solid_breaks *b);
