/* The bonds that have been stretched beyond the elastic limit of the bilinear law and are not broken yet. For solid/
 * only.
 *
 * They are intact (lambda = 1) for all readers. A bit in their store, solid_lattice.soft or solid_list.soft, takes them
 * out of the store's force sweep; they are swept from the list here (solid/force/sweep_soft.c). As in the stores a bond
 * stands once for each owned end, and both ends' owners find the same history to the bit.
 *
 * The stores have the bits, and a solid this list, only where a material is not brittle. */
#pragma once
#include "solid/state.h"

struct solid_soft_bond {
    int h, l;        /* local indices: an owned particle, and the other end (owned or ghost) */
    int place;       /* its number in h's view (solid/bonds/family.h) */
    long at;         /* lattice: offset of the stencil; list: number of the bond */
    double xi[3];    /* X0_l - X0_h, across periodic sides, m; z of a plate is 0 */
    double length;   /* |xi|, m */
    double weight;   /* Gamma_hl V_l, m3 */
    double elastic;  /* alpha c Gamma V_l, N/m3: the force per volume on h is elastic times share times stretch */
    double most;     /* the largest stretch so far: its history */
    double released; /* energy that this end's half has released so far, J */
};

struct solid_soft {
    int n, capacity;
    struct solid_soft_bond *bond; /* [n] by h, then by place, but for those that the present sweep has added */
    int added;                    /* number of those, at the end */
    int is_hidden;                /* 1: all bonds are whole (solid/step/rates.c) */
};

/* NULL if all materials are brittle. Not collective, nor is any function here. */
struct solid_soft *solid_soft_new(const struct solid *s);
void solid_soft_free(struct solid_soft *soft);

/* The stretches of the material of particle h. */
void solid_soft_limits(const struct solid *s, int h, double *s_e, double *s_c);
/* Takes the bond of owned particle h out of its store's sweep; for a lattice by the offset of the stencil, for a list
 * by the bond's number. The list must be put in order before it is read. */
void solid_soft_add(struct solid *s, int h, long at, double most);
void solid_soft_order(struct solid_soft *soft);
/* The same by the bond's number in h's view, for a state that is read or restored. What the bond has released is taken
 * from the law, which Verlet's steps follow. */
void solid_soft_add_placed(struct solid *s, int h, int place, double most);
/* Breaks the bond for h. The caller takes it off the list. */
void solid_soft_break(struct solid *s, const struct solid_soft_bond *bond);
/* Makes all its bonds elastic again and empties the list. */
void solid_soft_clear(struct solid *s);
/* Sets what the bond of h has released, by its number in h's view; without effect if it does not soften. */
void solid_soft_set_released(struct solid *s, int h, int place, double released);
/* Its part of M_h at full stiffness, c Gamma V_l |xi| without alpha, N/m2 (solid/force/dilatation.h). */
double solid_soft_plain(const struct solid *s, const struct solid_soft_bond *bond);
/* The part of its stiffness that the bond of h has kept: 1 if it does not soften. */
double solid_soft_share(const struct solid *s, int h, int place);
/* Multiplies the values of the bonds of h's view by these parts. */
void solid_soft_weaken(const struct solid *s, int h, double *value);
