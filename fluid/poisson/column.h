/* The last direction of the Poisson equation: for every column along z the system
 *     (q[k-1] - 2 q[k] + q[k+1])/d^2 + lambda q[k] = b[k] ,   k = 0 .. n-1 ,   lambda <= 0 ,
 * with z divided over ranks. The operator is a product of two recurrences with one constant, r + 1/r = 2 - lambda d^2,
 * r <= 1:
 *     up    y[k] = d^2 b[k] + r y[k-1]          down    q[k] = r (q[k+1] - y[k])
 * Each rank runs up from y = 0 below, plane by plane, and sums what q at its first plane would be. From these two
 * values of each column and rank follow the true y below and q above the planes of each rank (geometric sums, closed by
 * the end conditions; fluid/poisson/column_ranks.h); this takes one exchange of two values a column, there and back, or
 * two such exchanges with fewer messages. The run down adds the y from below times r^(k+1). Between faces
 * (FLUID_END_FACE) q is zero at k = -1 and at k = n-1, whatever b is there. The cost is reading and writing the planes:
 * no elimination, no transpose. */
#pragma once
#include "fluid/poisson/transform.h"
#include <stddef.h>

struct fluid_column_input {
    int n;          /* cells of z */
    int ranks[3];   /* process grid */
    const int *cut; /* [ranks[2] + 1] first planes of the pieces (par_piece_cut), borrowed; NULL: even ones */
    int groups;     /* of ranks along z (fluid/poisson/column_ranks.h); 0: as many as pays, 1: one level */
    double d;       /* m */
    double scale;   /* factor of the right-hand side */
    enum fluid_end low, high;
    int columns;          /* number of columns of this rank: [columns] in each plane */
    const double *lambda; /* [columns], 1/m2, borrowed during the call */
    double shift;         /* subtracted from every lambda, 1/m2, not negative */
    double *work;         /* [capacity] borrowed memory that fluid_column_couple overwrites; NULL: its own */
    size_t capacity;
    int free_mean; /* 1: some rank has a column with lambda = 0 between periodic or Neumann ends, whose mean is
                    * free */
};

struct fluid_column; /* opaque: factors, sums, exchange */

struct fluid_column *fluid_column_new(const struct fluid_column_input *in); /* Collective. */
void fluid_column_free(struct fluid_column *c);
/* Sets another lambda and shift, for columns without a free mean. Not collective. */
void fluid_column_set(struct fluid_column *c, const double *lambda, double shift);

/* Plane k = 0, 1, .. of this rank in turn, columns from .. to-1: replaces b [columns] by the y computed from zero;
 * below is plane k-1 (k > 0). copy [columns]: NULL, or gets the same y, which is not read soon. Not collective. */
void fluid_column_up(struct fluid_column *c, int k, int from, int to, const double *below, double *b, double *copy);
/* Once y of all planes (at y, y + plane, ..) is computed: finds the y below and the q above each rank. A free mean of q
 * becomes `mean`; the mean of b is then ignored. Collective. */
void fluid_column_couple(struct fluid_column *c, double *y, ptrdiff_t plane, double mean);
/* Before that call: if the mean is free, q at the last cell of the whole column (side 1) or the first (side 0) for mean
 * zero, on the ranks that hold the column; 0 on others. Collective. */
double fluid_column_free_end(struct fluid_column *c, const double *y, ptrdiff_t plane, int side);
/* Plane k = m, m-1, .. 0 in turn, columns from .. to-1: finds q. Plane m lies beyond this rank's last plane: it is the
 * next rank's first, or follows from the end condition, and needs no y. Not collective. */
void fluid_column_down(struct fluid_column *c, int k, int from, int to, const double *y);
/* q of plane k [columns], borrowed; of as many planes as there are threads. Not collective. */
const double *fluid_column_found(const struct fluid_column *c, int k);
