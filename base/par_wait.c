/* Adds up the time that this rank spends inside MPI's calls that wait. */
#include "base/par_wait.h"

#include <time.h>

static double waited;

double par_wait_begin(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

void par_wait_end(double from) { waited += par_wait_begin() - from; }

double par_wait_seconds(void) { return waited; }
