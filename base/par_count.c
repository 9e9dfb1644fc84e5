/* Counts messages, collective calls and bytes by kind of communication. */
#include "base/par_count.h"

static struct par_count count[PAR_COUNT_KINDS];

void par_count_message(enum par_count_kind kind, size_t bytes) {
    count[kind].messages++;
    count[kind].bytes += (long)bytes;
}

void par_count_collective(enum par_count_kind kind, size_t bytes) {
    count[kind].collectives++;
    count[kind].bytes += (long)bytes;
}

void par_count_clear(void) {
    for (int k = 0; k < PAR_COUNT_KINDS; k++) count[k] = (struct par_count){0};
}

struct par_count par_count_of(enum par_count_kind kind) {
    return count[kind];
}

const char *par_count_name(enum par_count_kind kind) {
    static const char *const name[PAR_COUNT_KINDS] = {"exchange", "ghost", "halo", "transpose", "reduction"};
    return name[kind];
}
