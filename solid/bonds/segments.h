/* A lattice's bonds in the order of the force sweep. The particles of a line of the lattice are covered by segments of
 * eight sites; a segment begins at the first particle not yet covered. The bonds of a segment at one offset form an
 * entry: the offset, and one bit for each site. An entry whose bits lie within four sites is a narrow one. The entries
 * with the same sites form a strip:
 *
 *      strip 0, 1     h h h h h h h h            wide
 *      strip 2, 3     h h h h                    narrow, from site 0; 4, 5: from site 1; ... 10, 11: from site 4
 *
 * Only a machine whose vecs have eight lanes (base/vec_type.h) has wide strips; others have two narrow ones for them.
 *
 * Even strips hold bonds with both ends owned here. Such a bond is stored once, in the later half of the family's
 * order, and its reaction is added to the other end. Odd strips hold bonds to ghosts and periodic images, without a
 * reaction. All of this follows from lambda; a segment is packed again after one of its bonds has broken. */
#pragma once
#include "base/vec_type.h"
#include "solid/bonds/slabs.h"

#include <stdint.h>

enum { SOLID_STRIPS = 12, SOLID_STRIPS_WIDE = VEC_LANES == 8, SOLID_SEGMENTS_LATER = 2 };

struct solid_lattice;

struct solid_segments {
    int n, inner;    /* the first `inner` segments have no bonds to ghosts or images */
    int *cell, *at;  /* [n] dense index of the first site, and its index in the field arrays */
    uint8_t *owned;  /* [n] bits of the sites that it covers */
    uint8_t *stale;  /* [n] lambda has changed since it was packed */
    uint8_t *large;  /* [n] 1: |eps| beyond the series occurred in the last sweep; and SOLID_SEGMENTS_LATER, which
                      * the first thread clears in the same sweep */
    uint8_t *bulk;   /* [n] alpha = 1 for all its bonds */
    float *high;     /* [n] the largest eps of the last sweep */
    long *first;     /* [n+1] index of its first entry */
    uint32_t *entry; /* offset << 8 | bits from the strip's first site; strip by strip */
    int *far;        /* [entries] index in the field arrays of the other end of the strip's first site */
    uint16_t (*count)[SOLID_STRIPS]; /* [n] present number of entries of each strip */
    int *segment_of;                 /* [lattice's n] the segment of a particle */
    uint16_t *order;                 /* [offsets] order of the entries */
    struct solid_slabs slabs[2];     /* of the inner segments, of the others */
};

static inline int solid_segments_strip_site(int strip) { return strip < 4 ? 0 : strip / 2 - 1; }

struct solid_segments *solid_segments_new(const struct solid_lattice *lattice);
void solid_segments_free(struct solid_segments *segments);
/* To be called once w is known. Not collective. */
void solid_segments_weigh(const struct solid_lattice *lattice);
/* Resets what a sweep leaves for the next one: which bonds are tested first, and in which form they are computed.
 * The next sweep tests all segments. Not collective. */
void solid_segments_reset(const struct solid_lattice *lattice);
/* Packs the entries of segment g from lambda. Not collective. */
void solid_segments_pack(const struct solid_lattice *lattice, int g);
