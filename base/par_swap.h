/* Equal pieces to and from a few ranks: what this rank sends to one of them is as long as what it gets from it. */
#pragma once

struct par_swap; /* opaque, owned by the caller */

struct par_swap *par_swap_new(void);
void par_swap_free(struct par_swap *s);
/* The ranks to swap with (none of them this one), and how many items with each; the same pair of ranks must name the
 * same number. Replaces what was set before; costs no message. */
void par_swap_set(struct par_swap *s, int peers, const int *rank, const int *count);
/* send, received: the items for and from each of the ranks in turn, `doubles` an item. Collective. */
void par_swap(struct par_swap *s, const double *send, double *received, int doubles);
