/* What this rank has said to others: messages, bytes and collectives, by kind. Counted inside base/par*.c where
 * something is sent; a rank's pieces to itself do not count. */
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
    long bytes;       /* that this rank has put into either */
};

/* Not collective, all of them. */
void par_count_message(enum par_count_kind kind, size_t bytes);
void par_count_collective(enum par_count_kind kind, size_t bytes);
struct par_count par_count_of(enum par_count_kind kind); /* since the start of the program */
const char *par_count_name(enum par_count_kind kind);
