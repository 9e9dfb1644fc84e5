/* Exchanges values of columns along z. The ranks of one column of the process grid (rank = c_z ranks[1] + c_y) each
 * hold a part of every column; the columns are shared out among these ranks, so that each column has one owner. share:
 * all ranks send their values of a column to its owner. return: the owner sends results back. Each way a rank sends and
 * receives as many values as it has columns, whatever the number of ranks. */
#pragma once

struct par_column; /* opaque, owned by the caller */

/* Each rank has `columns` columns and gives `values` values of each. Collective. */
struct par_column *par_column_new(const int ranks[3], int columns, int values);
void par_column_free(struct par_column *c);
/* This rank's place along z; the first of the columns that it owns, and their number. Not collective. */
int par_column_place(const struct par_column *c);
void par_column_own(const struct par_column *c, int *low, int *count);

/* mine [values] arrays of all columns -> of_all [ranks[2]][values][count] of the columns owned here, by place along z.
 * Collective. */
void par_column_share(struct par_column *c, const double *const *mine, double *of_all);
/* of_all -> mine: the results return. Collective. */
void par_column_return(struct par_column *c, const double *of_all, double *const *mine);
