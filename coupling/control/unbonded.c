/* Counts the particles that cracks have cut from all others. */
#include "coupling/control/unbonded.h"
#include "base/par.h"
#include "coupling/run.h"
#include "solid/bonds/family.h"

#include <stdio.h>

int unbonded_of(const struct run *r, char sentence[UNBONDED_SENTENCE]) {
    if (!r->solid || !r->needs.bonds || r->solid->in.cuts == 0) return 0;
    long loose = 0;
    for (int h = 0; h < r->solid->n; h++)
        loose += solid_family_initial_bonds(r->solid, h) > 0 && solid_family_intact_bonds(r->solid, h) == 0;
    loose = par_sum_long(loose);
    if (loose > 0)
        snprintf(
            sentence, UNBONDED_SENTENCE,
            "the cracks of the scene leave %ld particles without a bond: a crack that runs along a row of particles "
            "cuts all their bonds, and each is a fragment from the start. Move it between two rows, by half a "
            "spacing (%.4g m)",
            loose, 0.5 * r->solid->in.spacing);
    return loose > 0;
}
