/* The last direction of the Poisson equation: for every column along z the system
 *     (q[k-1] - 2 q[k] + q[k+1])/d^2 + lambda q[k] = b[k] ,   k = 0 .. n-1 ,   lambda <= 0 ,
 * with z cut over ranks. The operator is a product of two recurrences with one constant, r + 1/r = 2 - lambda d^2, r <=
 * 1: up    y[k] = d^2 b[k] + r y[k-1]          down    q[k] = r (q[k+1] - y[k]) Each rank runs up from y = 0, plane by
 * plane as they come, and adds up what its first q would be; from these two values a column and rank the true y below
 * and q above each rank's planes follow (geometric sums, closed by the ends' conditions), which takes one exchange of
 * two values a column there and back. The run down adds the y from below times r^(k+1). Between faces (FLUID_END_FACE)
 * q is zero at k = -1 and at k = n-1, whatever b is there. Reading and writing is all it costs: no elimination, no
 * transpose, any number of ranks, one round of messages. */
#pragma once
#include "fluid/poisson/transform.h"
#include <stddef.h>

struct fluid_column_input {
    int n;        /* cells of z */
    int ranks[3]; /* process grid */
    double d;     /* m */
    double scale; /* the right-hand side is multiplied by this */
    enum fluid_end low, high;
    int columns;          /* of this rank: [columns] in each plane */
    const double *lambda; /* [columns], 1/m2, borrowed during the call */
    double shift;         /* taken off every lambda, 1/m2, not negative */
    int free_mean;        /* 1: on some rank lambda = 0 between periodic or Neumann ends, and the mean is free */
};

struct fluid_column; /* opaque: factors, sums, exchange */

struct fluid_column *fluid_column_new(const struct fluid_column_input *in); /* Collective. */
void fluid_column_free(struct fluid_column *c);
/* Another lambda and shift, of columns without a free mean. Not collective. */
void fluid_column_set(struct fluid_column *c, const double *lambda, double shift);

/* Plane k = 0, 1, .. of this rank in turn: b [columns] is replaced by y started from zero; below is plane k-1 (k > 0).
 * Not collective. */
void fluid_column_up(struct fluid_column *c, int k, const double *below, double *b);
/* Once all planes y (at y, y + plane, ..) are up. A free mean of q becomes `mean`, and that of b is ignored.
 * Collective. */
void fluid_column_couple(struct fluid_column *c, double *y, ptrdiff_t plane, double mean);
/* Before that: where the mean is free, q at the last cell of the whole column (side 1) or the first (side 0) if its
 * mean is zero, on the ranks that hold it; 0 on others. Collective. */
double fluid_column_free_end(struct fluid_column *c, const double *y, ptrdiff_t plane, int side);
/* q of plane k = m, m-1, .. 0 in turn, borrowed until the next call; m is the plane beyond this rank's last, which is
 * the next rank's first or what the end's condition makes it, and needs no y. Not collective. */
const double *fluid_column_down(struct fluid_column *c, int k, const double *y);
