/* Deposits the particles' volume in the cells of the medium, and measures the medium. */
#include "coupling/interface/deposit.h"
#include "base/memory.h"
#include "coupling/run.h"

#include <math.h>

void deposit_update(struct run *r) {
    const struct solid *s = r->solid;
    double *x[3];
    if (r->deposited >= r->moved) return;
    for (int c = 0; c < 3; c++) {
        x[c] = r->position[c] ? r->position[c] : memory_new(MEMORY_COUPLING, (size_t)s->n + 1, sizeof *x[c]);
        for (int h = 0; h < s->n; h++) x[c][h] = s->x0[c][h] + s->d[c][h];
    }
    medium_deposit(r->medium, s->n, (const double *const *)x, s->volume);
    for (int c = 0; c < 3; c++)
        if (x[c] != r->position[c]) memory_free(x[c]);
    r->deposited = r->step;
}

struct medium_values deposit_measure(struct run *r) {
    deposit_update(r);
    struct medium_values v = medium_measure(r->medium, r->fluid, r->surface->immersed_area);
    if (r->measured.why[0] || v.porosity_effective == 0) v.permeability = v.reynolds = NAN;
    return v;
}
