/* The next coarser level of a matrix: rows are joined in pairs of strong coupling, and the pairs in pairs again; the
 * coarse matrix is P^T M P with P constant on each aggregate  (Notay 2010, double pairwise aggregation). */
#pragma once
#include "stokes/level.h"

/* Sets fine->coarse and returns the coarse level. Aggregates do not cross ranks. Collective. */
struct stokes_level *stokes_aggregate(struct stokes_level *fine);
void stokes_aggregate_free(struct stokes_level *level); /* one that was made here; may be NULL. Not collective. */
