/* What a medium is made of: for coupling/medium*.c only. */
#pragma once
#include "coupling/medium/kernels.h"
#include "coupling/medium/medium.h"

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

/* Index of cell i,j,k in the rimmed array. */
static inline int medium_rimmed(const struct fluid_grid *g, int i, int j, int k) {
    return ((k + 1) * (g->m[1] + 2) + j + 1) * (g->m[0] + 2) + i + 1;
}
/* 1: this rank's piece ends where the domain does. */
static inline int medium_at_end(const struct fluid_grid *g, int c, int high) {
    return high ? g->lo[c] + g->m[c] == g->n[c] : g->lo[c] == 0;
}
/* Floods a level on all ranks from the stack's first n cells; over [3]: across the periodic sides of that direction
 * too. Collective. */
void medium_connect_flood(struct medium *m, uint8_t level, int n, const int over[3]);

struct medium_cube {
    double x[3], side; /* centre, wrapped, m */
};
