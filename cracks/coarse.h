/* Bricks of wet particles, on which the preconditioner finds what varies slowly in the pressures. A brick is a cube of
 * the lattice, the same on any number of ranks, and every rank holds all of them: a box of bricks around the cracks,
 * with an empty layer on all sides. */
#pragma once
#include "cracks/cracks.h"

struct cracks_border; /* a link from a brick to the next one along an axis */

struct cracks_coarse {
    long version;  /* of the wet particles that they are of */
    int useful;    /* 0: the cracks are too short, or so far apart that the bricks are large */
    int side;      /* of a brick, spacings */
    int longest;   /* most bricks along an axis */
    int stride[3]; /* from a brick to the next one */
    int bricks;    /* of the box */
    int capacity;
    int *brick; /* [n] of a wet particle */
    int borders, borders_capacity;
    struct cracks_border *border;
    double
        *matrix; /* [4][bricks] storage and elastic part, m3/Pa; flow in the substep to the next brick on each axis */
    double *inverse;                      /* [bricks] 1/diagonal; 0: no full particle */
    double *residual, *x, *next, *change; /* [bricks] */
    int terms;                            /* of the polynomial that solves */
    double span;                          /* of its spectrum */
};

/* The bricks of the present wet particles. Collective. */
struct cracks_coarse *cracks_coarse_renew(struct cracks_coarse *b, const struct cracks *c);
void cracks_coarse_free(struct cracks_coarse *b);
/* The matrix between full particles. mass [n]: a particle's storage, elastic part and flow to those that are not full;
 * full [by place]: 1 or 0, with ghosts. Collective. */
void cracks_coarse_begin(struct cracks_coarse *b, const struct cracks *c, double dt, const double *mass,
                         const double *full);
/* x = an approximation of the solution for the residual, which is a sum over this rank's particles. Collective. */
void cracks_coarse_solve(struct cracks_coarse *b);
