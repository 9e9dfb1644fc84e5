/* Bricks of 8 x 8 x 8 lattice sites, 64 rows each: how a body's sites are stored and numbered. */
#pragma once
#include "solid/body/sites.h"

/* The number of sites by which bricks along y or z begin before the box, so that the plane that halves the body lies
 * between two bricks. layer [n]: sites of the body in each layer of the box. */
int solid_bricks_shift(const long *layer, int n);
/* The direction of the first cut of a body of so many particles. ghosts: of two ranks by the direction of the cut; -1:
 * it cannot be cut. Returns -1 if no direction can. */
int solid_bricks_first_cut(const long ghosts[3], long particles);
/* Makes the bricks of the box, all empty; its rows are known. Not collective, as all functions here but those that say
 * so. */
void solid_bricks_new(struct solid_sites *sites);
/* The same, with one copy for all ranks of a node. Collective; solid_bricks_number is then collective too. */
void solid_bricks_share(struct solid_sites *sites);
/* Numbers the rows brick by brick, by halves of the body (solid/geometry/bisect.h), once the bits, base and wrap are
 * set. */
void solid_bricks_number(struct solid_sites *sites);
/* The global id of the site at this place in the box; -1: not in the body. */
long solid_bricks_id(const struct solid_sites *sites, const int at[3]);

/* Index in bits of row i along x at the lines j and k of the box. */
static inline size_t solid_bricks_row(const struct solid_sites *sites, int i, int j, int k) {
    const size_t brick =
        ((size_t)(k / SOLID_ROW) * (size_t)sites->bricks[1] + (size_t)(j / SOLID_ROW)) * (size_t)sites->bricks[0] +
        (size_t)i;
    return brick * SOLID_BRICK + (size_t)(k % SOLID_ROW * SOLID_ROW + j % SOLID_ROW);
}

/* A walk over the rows that hold a particle, in the order of their numbers. */
struct solid_bricks_walk {
    int brick, row; /* the next one to look at; 0 at first */
    /* the row found */
    int site[3]; /* lattice index of its first site */
    unsigned bits;
    long id; /* of its first particle */
    long next;
};
/* Finds the next row. Returns 0 when there is none. */
int solid_bricks_next(const struct solid_sites *sites, struct solid_bricks_walk *walk);
