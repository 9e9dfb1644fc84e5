/* Finds prescribed inflows and driven directions from which no path through pore cells leads out. */
#include "coupling/interface/deposit.h"
#include "coupling/control/blocked.h"
#include "base/side.h"
#include "fluid/grid/side.h"

#include <stdio.h>

int blocked_of(struct run *r, char sentence[BLOCKED_MAX][BLOCKED_SENTENCE]) {
    int outlets[3][2], n = 0;
    if (!r->needs.immersed) return 0;
    const struct fluid_input *in = fluid_input_of(r->fluid);
    for (int d = 0; d < 3; d++)
        for (int high = 0; high < 2; high++) outlets[d][high] = fluid_side_flow(&in->side[d][high], d, high) < 0;
    deposit_update(r);
    for (int d = 0; d < 3; d++)
        for (int high = 0; high < 2; high++) {
            if (fluid_side_flow(&in->side[d][high], d, high) <= 0) continue;
            const double part = medium_cut_off(r->medium, d, high, (const int(*)[2])outlets, 1);
            if (part > 0)
                snprintf(sentence[n++], BLOCKED_SENTENCE,
                         "%.3g %% of %s have no way out that the cells resolve: the fluid that enters there is pressed "
                         "through the solid",
                         100 * part, side_name[d][high]);
        }
    if (in->driving.type == FLUID_DRIVING_BULK && in->driving.value != 0) {
        const int d = in->driving.direction;
        int far[3][2] = {{0}};
        far[d][1] = 1;
        if (medium_cut_off(r->medium, d, 0, (const int(*)[2])far, 0) == 1)
            snprintf(sentence[n++], BLOCKED_SENTENCE,
                     "no way along %c that the cells resolve: the prescribed mean flow is pressed through the solid",
                     "xyz"[d]);
    }
    return n;
}
