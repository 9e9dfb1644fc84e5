/* Makes the lowest failing rank's status everybody's. */
#include "base/step_status.h"
#include "base/par.h"

int step_status_agree(struct step_status *status) {
    const int size = par_size();
    int first = (int)par_min(status->failed ? par_rank() : size);
    if (first == size) return 0;
    par_bcast(status, sizeof *status, first);
    return 1;
}
