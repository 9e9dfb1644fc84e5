/* Exchange of equal pieces with a few ranks: this rank sends as many items to each of them as it receives from it. */
#pragma once

struct par_swap; /* opaque, owned by the caller */

struct par_swap *par_swap_new(void);
void par_swap_free(struct par_swap *s);
/* Sets the ranks to exchange with (not this one) and the number of items for each. Both ranks of a pair must give the
 * same number. Replaces what was set before; sends no message. */
void par_swap_set(struct par_swap *s, int peers, const int *rank, const int *count);
/* send, received: the items for and from each of the ranks in turn, `doubles` doubles each. Collective. */
void par_swap(struct par_swap *s, const double *send, double *received, int doubles);
