/* The coupling of the pieces of columns that ranks along z hold (fluid/poisson/column.h). A piece gives two numbers of
 * each column, computed from zero: its last y, and the sum S that is minus the q below it; it needs two, the y below
 * and the q above it. For a piece of m planes:
 *     y above = r^m y below + Y          q below = r^m q above - S - (r^2 + .. + r^2m) y below
 * Two pieces of m and n planes, one above the other, are together a piece of the same kind with m + n planes. So the
 * ranks along z are coupled in one level, or in two: first the ranks of a group give their sum, then the groups are
 * coupled, then each group its ranks. Each rank does this for a share of the columns. With P ranks in groups of about
 * sqrt(P), a rank sends some 4 sqrt(P) messages in place of 2 (P - 1). */
#pragma once

struct fluid_column_input; /* fluid/poisson/column.h */
struct fluid_column_ranks; /* opaque, owned by the caller */

struct fluid_column_ranks *fluid_column_ranks_new(const struct fluid_column_input *in); /* Collective. */
void fluid_column_ranks_free(struct fluid_column_ranks *c);
/* Sets lambda [columns] and shift. Not collective. */
void fluid_column_ranks_set(struct fluid_column_ranks *c, const double *lambda, double shift);
/* This rank's first plane, and their number. Not collective. */
void fluid_column_ranks_planes(const struct fluid_column_ranks *c, int *low, int *m);
/* known: Y, S [columns] -> found: y below, q above [columns] of this rank's planes. Collective. */
void fluid_column_ranks_couple(struct fluid_column_ranks *c, const double *const known[2], double *const found[2]);
