/* A lattice's bonds in the order in which a sweep takes them. Particles along a line of the lattice are covered by
 * segments of eight sites that start wherever the first uncovered particle is, and a segment's bonds at one offset are
 * an entry: the offset and a bit a site. An entry whose bits lie within four sites is a narrow one; the ones with the
 * same four sites make up a strip:
 *
 *      strip 0, 1     h h h h h h h h            wide
 *      strip 2, 3     h h h h                    narrow, from site 0; 4, 5: from site 1; ... 10, 11: from site 4
 *
 * Even strips hold bonds with both ends owned here (once, at the half of the family that is later in its order):
 * whoever computes them gives the reaction to the other end. Odd ones hold bonds to ghosts and periodic images, which
 * have no one to give it to. All of it follows from lambda, and is packed anew where a bond was cut. */
#pragma once
#include <stdint.h>

enum { SOLID_STRIPS = 12 };

struct solid_lattice;

struct solid_segments {
    int n, inner;    /* the first of them, inner, have no bonds to ghosts or images */
    int *cell, *at;  /* [n] dense index of the first site, and where it stands in the boxes */
    uint8_t *owned;  /* [n] which of the eight sites it covers */
    uint8_t *stale;  /* [n] lambda has changed since it was packed */
    uint8_t *large;  /* [n] |eps| beyond the series was seen at the last sweep */
    uint8_t *bulk;   /* [n] alpha = 1 for all its bonds */
    float *high;     /* [n] the largest eps of the last sweep */
    long *first;     /* [n+1] where its entries stand */
    uint32_t *entry; /* offset << 8 | bits, those of a strip from its first site; first strip by strip */
    int *far;        /* [entries] where the other end of the strip's first site stands in the boxes */
    uint16_t (*count)[SOLID_STRIPS]; /* [n] entries of each strip now */
    int *of;                         /* [lattice's n] a particle's segment */
    uint16_t *order;                 /* [offsets] the order of entries: x step slowest */
};

static inline int solid_segments_strip_site(int strip) { return strip < 4 ? 0 : strip / 2 - 1; }

struct solid_segments *solid_segments_new(const struct solid_lattice *lattice);
void solid_segments_free(struct solid_segments *segments);
/* Once w is known. Not collective. */
void solid_segments_weigh(const struct solid_lattice *lattice);
/* Entries of segment g anew from lambda. Not collective. */
void solid_segments_pack(const struct solid_lattice *lattice, int g);
