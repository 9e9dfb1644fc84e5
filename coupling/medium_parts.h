/* What a medium is made of: for coupling/medium*.c only. */
#pragma once
#include "coupling/medium.h"
#include "coupling/medium_kernels.h"

struct par_exchange;

struct medium {
    const struct fluid_grid *g; /* borrowed */
    double low[3], high[3];     /* the box within the domain, m */
    double total;               /* sum of the weights over all ranks: its volume in cells */
    int whole_period;           /* x is periodic and the box is all of it */
    double *weight[3];          /* [m[c]] part of this rank's cell within the box, along c */
    double *fraction;           /* [g->size] */
    double effective;           /* connected porosity of this fraction, -1: not known */
    /* work */
    double *carry;   /* [g->size] cells' states on their way between ranks */
    uint8_t *cell;   /* [mz+2][my+2][mx+2] as the last flood has left them */
    int *stack;      /* [mx my mz] */
    double *section; /* [n[0]] mean pressures */
    /* the particles' way to the ranks that hold their cells: planned anew only when one goes elsewhere */
    struct par_exchange *exchange;
    int particles, capacity, served_capacity;
    int *dest;                  /* [particles] */
    struct medium_cube *mine;   /* [particles] */
    struct medium_cube *served; /* those this rank deposits */
};

struct medium_cube {
    double x[3], side; /* centre, wrapped, m */
};
