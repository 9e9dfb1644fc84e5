/* Counters of what this rank has sent: messages, bytes and collective calls, by kind. Counted in base/par*.c where
 * something is sent; copies that stay on the rank do not count. */
#pragma once
#include <stddef.h>

enum par_count_kind {
    PAR_COUNT_EXCHANGE,  /* items between two layouts: markers, probes, contact */
    PAR_COUNT_GHOST,     /* copies of particles */
    PAR_COUNT_HALO,      /* ghost layers of the grid */
    PAR_COUNT_TRANSPOSE, /* pencils, and the interface values of the direct solve */
    PAR_COUNT_REDUCTION, /* sums, extremes, gatherings over all ranks */
    PAR_COUNT_KINDS
};

struct par_count {
    long messages;    /* to one other rank each */
    long collectives; /* calls that all ranks of a communicator take part in */
    long bytes;       /* sent by this rank in both */
};

/* Not collective, all of these. */
void par_count_message(enum par_count_kind kind, size_t bytes);
void par_count_collective(enum par_count_kind kind, size_t bytes);
void par_count_clear(void);                              /* a new run begins: all counts are 0 */
struct par_count par_count_of(enum par_count_kind kind); /* since then, or since the start of the program */
const char *par_count_name(enum par_count_kind kind);
