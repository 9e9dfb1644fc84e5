/* Exchanges values of columns along z among ranks that each hold a part of every column. The columns are shared out
 * among these ranks, or the first of them, so that each column has one owner. share: all ranks send their values of a
 * column to its owner. return: the owner sends results back. Each way a rank sends and receives as many values as it
 * has columns, whatever the number of ranks. */
#pragma once
#include <stddef.h>

struct par_column; /* opaque, owned by the caller */

struct par_column_input {
    int parts, place; /* ranks that hold parts of the same columns; which of them this one is */
    const int *rank;  /* [parts], borrowed during the call */
    int owners;       /* the first so many of them own columns */
    int columns;      /* number of columns */
    int values;       /* number of values given of each column */
    double *work; /* [capacity] borrowed memory that others may write between the calls; used if it is large enough */
    size_t capacity;
};

/* Not collective. */
struct par_column *par_column_new(const struct par_column_input *in);
void par_column_free(struct par_column *c);
/* The first of the columns that this rank owns, and their number. Not collective. */
void par_column_own(const struct par_column *c, int *low, int *count);

/* local [values] arrays of all columns -> of_all [parts][values][count] of the columns owned here. Collective among the
 * parts. */
void par_column_share(struct par_column *c, const double *const *local, double *of_all);
/* of_all -> local: the results return. Collective among the parts. */
void par_column_return(struct par_column *c, const double *of_all, double *const *local);
