/* Gives all ranks the status of the lowest rank that failed. */
#include "base/step_status.h"
#include "base/par.h"

int step_status_agree(struct step_status *status) {
    const int size = par_size();
    int first = (int)par_min(status->failed ? par_rank() : size);
    if (first == size) return 0;
    par_bcast(status, sizeof *status, first);
    return 1;
}
