/* The family of a particle of a lattice: its bonds and their weights. */
#include "solid/law/stencil.h"
#include "base/die.h"
#include "base/memory.h"
#include "solid/input.h"
#include "solid/law/weight.h"

#include <math.h>
#include <stdlib.h>

enum { CELLS = 400 }; /* columns along a side of a cube's face: fractions accurate to 1e-6 */

static double fraction_of_step(const struct solid_stencil *stencil, const int step[3]) {
    /* the fraction is equal for all permutations and signs: checks whether it is known already */
    for (int o = 0; o < stencil->n; o++) {
        const int *other = stencil->offset[o].step;
        const int same2 = other[0] * other[0] + other[1] * other[1] + other[2] * other[2] ==
                          step[0] * step[0] + step[1] * step[1] + step[2] * step[2];
        const int same4 = other[0] * other[0] * other[1] * other[1] * other[2] * other[2] ==
                          step[0] * step[0] * step[1] * step[1] * step[2] * step[2];
        const int sum = abs(other[0]) + abs(other[1]) + abs(other[2]);
        if (same2 && same4 && sum == abs(step[0]) + abs(step[1]) + abs(step[2]))
            return stencil->offset[o].weight / (stencil->spacing * stencil->spacing * stencil->spacing);
    }
    const double xi[3] = {step[0], step[1], step[2]};
    return solid_weight_fraction(xi, 1, stencil->horizon / stencil->spacing, CELLS);
}

struct solid_stencil *solid_stencil_new(double spacing, double m) {
    struct solid_stencil *stencil = memory_new(MEMORY_SOLID, 1, sizeof *stencil);
    stencil->spacing = spacing;
    stencil->horizon = m * spacing;
    const double limit = (m + 0.5) * (m + 0.5) * (1 - 1e-12), volume = spacing * spacing * spacing;
    const int reach = (int)floor(m + 0.5);
    stencil->offset = memory_new(MEMORY_SOLID, SOLID_FAMILY_MAX, sizeof *stencil->offset);
    for (int k = -reach; k <= reach; k++)
        for (int j = -reach; j <= reach; j++)
            for (int i = -reach; i <= reach; i++) {
                const int step2 = i * i + j * j + k * k;
                if (step2 == 0 || step2 >= limit) continue;
                if (stencil->n == SOLID_FAMILY_MAX)
                    die_all(EXIT_CODE_SCENE, "horizon_ratio = %g: a particle would have more than %d bonds", m,
                            SOLID_FAMILY_MAX);
                const int step[3] = {i, j, k};
                const double fraction = fraction_of_step(stencil, step);
                struct solid_offset *o = &stencil->offset[stencil->n++];
                for (int c = 0; c < 3; c++) {
                    o->step[c] = step[c];
                    o->xi[c] = step[c] * spacing;
                    if (abs(step[c]) > stencil->reach) stencil->reach = abs(step[c]);
                }
                o->length = sqrt(step2) * spacing;
                o->inv_length2 = 1 / (step2 * spacing * spacing);
                o->weight = fraction * volume;
                stencil->full_volume += o->weight;
            }
    return stencil;
}

void solid_stencil_free(struct solid_stencil *stencil) {
    if (!stencil) return;
    MEMORY_FREE(stencil->offset, stencil);
}
