/* Exchange of items between two layouts. Each rank names the rank that serves each of its items. The plan is built once
 * and executed often: to the serving ranks (forward) and back (backward). The order is kept: an item comes back to the
 * place that it was sent from. */
#pragma once
#include <stddef.h>

struct par_exchange; /* opaque, owned by the caller */

/* dest[n]: the rank that serves item i; -1: the item is not exchanged. Collective. */
struct par_exchange *par_exchange_new(int n, const int *dest);
/* The same for a plan that changes often. It reuses the memory of the old plan x (may be NULL). Copy c of n sends
 * item[c] (item NULL: c) to dest[c], so that an item may go to several ranks. Collective. */
struct par_exchange *par_exchange_renew(struct par_exchange *x, int n, const int *item, const int *dest);
void par_exchange_free(struct par_exchange *x);
int par_exchange_count(const struct par_exchange *x); /* items this rank serves */

/* local [n] items of bytes each -> served [count] items. Collective. */
void par_exchange_forward(struct par_exchange *x, const void *local, void *served, size_t bytes);
/* served [count] items -> local [n] items. Items with dest -1 are left untouched; an item served by several ranks gets
 * the value of one of them. Collective. */
void par_exchange_backward(struct par_exchange *x, const void *served, void *local, size_t bytes);
