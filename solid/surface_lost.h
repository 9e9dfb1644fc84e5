/* Which particles have lost bonds since somebody last asked. s->broke is a set of bits: the force sweep sets it to
 * SOLID_BROKE_NEW; each reader takes its own note of it, so that none hides the news from the other. */
#pragma once
#include "solid/solid.h"

enum solid_broke {
    SOLID_BROKE_NEW = 1,     /* nobody has looked yet */
    SOLID_BROKE_SURFACE = 2, /* the surface has yet to look */
    SOLID_BROKE_CONTACT = 4  /* contact has yet to look */
};

/* Whether bonds broke since `reader` last took it; clears it for that reader. Not collective. */
int solid_lost_take(struct solid *s, enum solid_broke reader);

struct solid_lost {
    uint16_t *intact; /* [s->n] intact bonds when last asked */
    uint8_t *bits;
    int bytes;
};

struct solid_lost *solid_lost_new(const struct solid *s); /* Not collective. */
void solid_lost_free(struct solid_lost *lost);
/* 1 if owned particle h has lost a bond since this was last asked of it. Not collective. */
int solid_lost_since(struct solid_lost *lost, const struct solid *s, int h);
