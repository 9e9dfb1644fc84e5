/* The intrinsic permeability of the medium as it is now: that of creeping flow through its box, solved at once on the
 * cells that are pore.  (docs/permeability.md, docs/theory.md) */
#pragma once
#include "base/signals.h"
#include "coupling/medium/medium.h"

struct medium_intrinsic; /* opaque: what the box's sides are, and the last solutions */

struct medium_intrinsic_values {
    double K[3][3];    /* m2, symmetric. Infinite along an axis along which nothing resists the flow, 0 along one along
                        * which no pores lead through, NaN: not measured */
    double porosity;   /* share of the box's cells that are pore */
    double error;      /* of K, relative, by the iteration: the largest of the axes */
    int percolates[3]; /* 1: the pores connect the two sides of the axis */
    int solved;        /* solutions that were found; 0: the pores are those of the last time */
    int carried;       /* of these, from the last ones */
    long pores;        /* pore cells of the box */
    long iterations, products;   /* of all of them: outer ones, and with the viscous operator */
    enum signals_reason stopped; /* why it was given up: nothing is measured; SIGNALS_NONE: it was not */
};

/* m, in: borrowed. Collective. */
struct medium_intrinsic *medium_intrinsic_new(const struct medium *m, const struct fluid_input *in);
void medium_intrinsic_free(struct medium_intrinsic *t); /* may be NULL. Not collective. */
/* Of the solid fraction as it is now. A cell is pore if less than half of it is solid. Cells count whose centre is in
 * the box. Given up at a signal or at the end of the run's time (signals_poll); the next one then starts from nothing.
 * Collective. */
struct medium_intrinsic_values medium_intrinsic_measure(struct medium_intrinsic *t);
/* The next solutions start from nothing. Not collective. */
void medium_intrinsic_reset(struct medium_intrinsic *t);
long medium_intrinsic_cells(const struct medium_intrinsic *t); /* of the box. Not collective. */
/* The box's present pore cells. Collective. */
long medium_intrinsic_pores(const struct medium_intrinsic *t);
/* Memory of all ranks while so many of them are solved, bytes. Not collective. */
double medium_intrinsic_bytes(long pores);
