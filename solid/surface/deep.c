/* Finds from how many intact bonds on a particle counts as deep in its body, and how far such a place is compressed. */
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

double solid_deep_volume_ratio(const struct solid *s, int h) {
    int nearest[6];
    double a[3][3];
    solid_family_nearest(s, h, nearest);
    for (int d = 0; d < 3; d++) {
        double low[3], high[3];
        if (nearest[2 * d] < 0 || nearest[2 * d + 1] < 0) return 0;
        solid_relative(s, h, nearest[2 * d], low);
        solid_relative(s, h, nearest[2 * d + 1], high);
        for (int c = 0; c < 3; c++) a[d][c] = (high[c] - low[c]) / (2 * s->in.spacing);
    }
    return a[0][0] * (a[1][1] * a[2][2] - a[1][2] * a[2][1]) - a[0][1] * (a[1][0] * a[2][2] - a[1][2] * a[2][0]) +
           a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0]);
}
