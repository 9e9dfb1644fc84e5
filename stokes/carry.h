/* Solutions through earlier pores, from which those through much the same pores start. */
#pragma once
#include "stokes/stokes.h"

struct stokes_carry {
    struct stokes_mask *mask; /* of the earlier pores that led through; owned */
    long *first;              /* [ranks + 1] the first number of each rank */
    int n;                    /* cells of this rank */
    float *p[3], (*u[3])[3];  /* [n] of the solution along each axis; NULL: there is none */
};

struct stokes_carry *stokes_carry_new(void);    /* Empty. Not collective. */
void stokes_carry_free(struct stokes_carry *c); /* may be NULL. Not collective. */
/* Keeps the last solution as that along the axis. Not collective. */
void stokes_carry_keep(struct stokes_carry *c, const struct stokes *s, int axis);
/* Takes the pores of the solutions that were kept, and frees s. Not collective. */
void stokes_carry_end(struct stokes_carry *c, struct stokes *s);
/* Sets u and p of s by the solution along the axis that was kept of a box of as many cells: cells that were pore then
 * have their values, the others p of those beside them and no velocity. Returns 0 if less than half of the cells were
 * pore, or nothing was kept: then u and p are not set. Collective. */
int stokes_carry_set(const struct stokes_carry *c, struct stokes *s, int axis);
