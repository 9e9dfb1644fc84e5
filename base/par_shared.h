/* Arrays of which each node holds one copy, for all its ranks. Where the ranks of a node cannot share memory, each rank
 * holds a copy of its own, and the same calls do the same. */
#pragma once
#include "base/memory.h"

struct par_shared {
    void *data;            /* zeroed at first; from a multiple of 64 bytes on */
    size_t bytes;          /* of a copy, a multiple of 8 */
    int sharers, copies;   /* ranks that have this copy; copies of all ranks together */
    int is_writer;         /* on one rank of each copy; rank 0 is one */
    int is_mapped;         /* the copy is not this rank's own memory */
    enum memory_part part; /* that the bytes are counted for, on the writer */
    char why[128]; /* what hinders sharing, the same text on all ranks; "": nothing, or no two ranks on a node */
};

/* A rank may write at any time what no other rank of its node writes or reads until the next fence. Bits of one word
 * are set by several ranks with atomic operations. Collective. */
struct par_shared *par_shared_new(enum memory_part part, size_t bytes);
void par_shared_free(struct par_shared *s); /* may be NULL. Not collective: others keep what they share. */
/* What ranks of a node wrote before it, all of them read after it. Collective. */
void par_shared_fence(const struct par_shared *s);
/* The union of the bits that are set in any copy becomes the content of all. Begins and ends with a fence. Collective.
 */
void par_shared_unite(const struct par_shared *s);
/* Rank 0's copy becomes the content of all. Begins and ends with a fence. Collective. */
void par_shared_spread(const struct par_shared *s);
int par_shared_ranks(void); /* number of ranks on this rank's node. Collective. */
/* At most so many ranks of a node share a copy from now on, as if they were on several nodes; 0: all of them. For
 * tests, while there is no such array. Collective. */
void par_shared_limit(int ranks);
