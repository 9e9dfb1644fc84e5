/* Finds from how many intact bonds on a particle counts as deep in its body. */
#include "solid/surface/deep.h"
#include "solid/bonds/family.h"
#include "solid/bonds/store.h"
#include "solid/law/stencil.h"

#include <math.h>

static const double FILLED = 0.9; /* of a full family's volume */

void solid_deep_least_bonds(const struct solid *s, uint16_t *least) {
    for (int h = 0; h < s->n; h++) {
        const int b = s->body[h], is_lattice = s->family->lattice[b] != NULL;
        const double full = s->family->stencil[s->in.body[b].material]->full_volume, has = s->family_volume[h];
        const int initial = solid_family_initial_bonds(s, h);
        const double wanted = has > 0 && is_lattice ? ceil(FILLED * full / has * initial) : INFINITY;
        least[h] = wanted <= initial ? (uint16_t)wanted : UINT16_MAX;
    }
}
