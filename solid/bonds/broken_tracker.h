/* Tracks broken bonds: which particles have lost bonds since a reader last asked. s->broke is a set of bits: the force
 * sweep sets SOLID_BROKE_NEW, which stands for all readers; each reader clears its own bit only. */
#pragma once
#include "solid/state.h"

enum solid_broke {
    SOLID_BROKE_NEW = 1,     /* no reader has asked since */
    SOLID_BROKE_SURFACE = 2, /* the surface has not asked since */
    SOLID_BROKE_CONTACT = 4, /* contact has not asked since */
    SOLID_BROKE_PUSH = 8     /* not yet read by what sets the load before each substep (solid/step/push.h) */
};

/* Whether bonds broke since `reader` last asked; clears it for that reader. Not collective. */
int solid_broken_tracker_take(struct solid *s, enum solid_broke reader);

struct solid_broken_tracker {
    int found;             /* number of particles in the last solid_broken_tracker_find */
    int *h;                /* [found] room for s->n */
    uint16_t *intact;      /* [s->n] number of intact bonds at the last check */
    unsigned *row_version; /* of the lattices' rows, one lattice after another: the particles of an unchanged row are
                            * not checked */
};

struct solid_broken_tracker *solid_broken_tracker_new(const struct solid *s); /* Not collective. */
void solid_broken_tracker_free(struct solid_broken_tracker *tracker);
/* Copies all but h. */
void solid_broken_tracker_copy(struct solid_broken_tracker *to, const struct solid_broken_tracker *from,
                               const struct solid *s);
/* Resets the counts, so that the next search finds every particle that can be tested. */
void solid_broken_tracker_reset(struct solid_broken_tracker *tracker, const struct solid *s);
/* Finds the owned particles that have lost bonds since the last call: tracker->h. Returns how many. Not collective. */
int solid_broken_tracker_find(struct solid_broken_tracker *tracker, const struct solid *s);
