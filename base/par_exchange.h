/* Items that travel between two layouts: each rank names, for each of its items, the rank that serves it; the plan is
 * built once and executed often, there (forward) and back (backward). The item's order is kept: what comes back stands
 * where it was sent from. */
#pragma once
#include <stddef.h>

struct par_exchange; /* opaque, owned by the caller */

/* dest[n]: the rank that serves item i, or -1 for an item that stays out of it. Collective. */
struct par_exchange *par_exchange_new(int n, const int *dest);
/* The same for a plan that changes often, in the memory of the old one (x, may be NULL): copy c of n sends item[c]
 * (NULL: c) to dest[c], so that an item may go to several ranks. Collective. */
struct par_exchange *par_exchange_renew(struct par_exchange *x, int n, const int *item, const int *dest);
void par_exchange_free(struct par_exchange *x);
int par_exchange_count(const struct par_exchange *x); /* items this rank serves */

/* mine [n] items of bytes each -> served [count] items. Collective. */
void par_exchange_forward(struct par_exchange *x, const void *mine, void *served, size_t bytes);
/* served [count] items -> mine [n] items; items that stayed out are left untouched, an item served by several gets what
 * one of them sends. Collective. */
void par_exchange_backward(struct par_exchange *x, const void *served, void *mine, size_t bytes);
