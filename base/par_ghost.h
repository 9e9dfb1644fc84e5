/* Ghosts: each rank owns the ids first[rank] .. first[rank+1]-1 and wants copies of others'. */
#pragma once
#include <stddef.h>

struct par_ghost; /* opaque, owned by the caller */

/* first [size+1]; id [n] wanted ids, not owned here, in the order in which they are to arrive. Collective. */
struct par_ghost *par_ghost_new(const long *first, int n, const long *id);
void par_ghost_free(struct par_ghost *g);
/* How many copies other ranks have of items here; index: which these are, an item once for each copy, borrowed. Not
 * collective. */
int par_ghost_served(const struct par_ghost *g, const int **index);
/* For each of the fields: field[f][n_owned .. n_owned+n-1] <- the owners' values. Collective. */
void par_ghost_update(struct par_ghost *g, int fields, double *const *field, int n_owned);
/* The same in two halves, with computation between them. The values sent are those at begin; the values received are in
 * the fields after end. end does nothing if no update was begun, and does not wait for this rank's own messages to
 * leave. Collective. */
void par_ghost_begin(struct par_ghost *g, int fields, double *const *field, int n_owned);
void par_ghost_end(struct par_ghost *g);
/* The adjoint: field[f][i] += the values of all ghosts of i on other ranks. Collective. */
void par_ghost_add(struct par_ghost *g, int fields, double *const *field, int n_owned);
/* The same of records of so many bytes each, record [n_owned + n]. Collective. */
void par_ghost_update_records(struct par_ghost *g, size_t bytes, void *record, int n_owned);
void par_ghost_update_bytes(struct par_ghost *g, unsigned char *field, int n_owned);
