/* Columns along z cut over the ranks of one column of the process grid (rank = c_z ranks[1] + c_y): what every rank
 * knows of all columns is brought to the columns' owners, each of which has a share of them, and what they find out is
 * brought back. Each way a rank sends and receives as many values as it has columns, whatever the number of ranks. */
#pragma once

struct par_column; /* opaque, owned by the caller */

/* `columns` on each rank, `values` of each known by every rank. Collective. */
struct par_column *par_column_new(const int ranks[3], int columns, int values);
void par_column_free(struct par_column *c);
/* This rank's place along z, and the first of its own columns and their number. Not collective. */
int par_column_place(const struct par_column *c);
void par_column_own(const struct par_column *c, int *low, int *count);

/* mine [values] arrays of all columns -> of_all [ranks[2]][values][count] of the own ones, by place along z.
 * Collective. */
void par_column_share(struct par_column *c, const double *const *mine, double *of_all);
/* of_all -> mine, the other way. Collective. */
void par_column_return(struct par_column *c, const double *of_all, double *const *mine);
