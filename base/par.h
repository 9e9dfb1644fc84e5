/* Ranks and reductions. MPI is used in base/ only; everything else calls these. */
#pragma once
#include <stddef.h>

void par_begin(int *argc, char ***argv); /* Collective. */
void par_end(void);                      /* Collective. */
_Noreturn void par_abort(int code);      /* Not collective. */

int par_rank(void);
int par_size(void);

/* Reductions over all ranks, the result on every rank. Collective. */
double par_sum(double value);
double par_min(double value);
double par_max(double value);
long par_sum_long(long value);
void par_sum_array(double *value, int n);
void par_min_array(double *value, int n);
void par_max_array(double *value, int n);
void par_sum_long_array(long *value, int n);
long par_sum_before(long value); /* sum over the ranks below this one */

void par_bcast(void *data, size_t bytes, int root);               /* Collective. */
void par_gather(const void *local, size_t bytes, void *everyone); /* equal pieces to rank 0. Collective. */
void par_all_gather(const void *local, size_t bytes, void *everyone);
/* Unequal pieces, concatenated by rank, on every rank; returns a malloc'ed array, *total its bytes. Collective. */
void *par_all_gather_any(const void *local, size_t bytes, size_t *total);
void par_barrier(void);
double par_seconds(void); /* a wall clock, s. Not collective. */
