/* Deposits the particles' volume in the cells of the medium, and measures the medium. */
#include "coupling/interface/deposit.h"
#include "base/memory.h"
#include "coupling/run.h"

#include <math.h>

/* Grows the arrays of the run that are too small. */
static void positions_begin(const struct run *r, double *x[3]) {
    const struct solid *s = r->solid;
    for (int c = 0; c < 3; c++) {
        x[c] = r->position[c] ? r->position[c] : memory_new(MEMORY_COUPLING, (size_t)s->n + 1, sizeof *x[c]);
        for (int h = 0; h < s->n; h++) x[c][h] = s->x0[c][h] + s->d[c][h];
    }
}

static void positions_end(const struct run *r, double *x[3]) {
    for (int c = 0; c < 3; c++)
        if (x[c] != r->position[c]) memory_free(x[c]);
}

void deposit_update(struct run *r) {
    double *x[3];
    if (r->deposited >= r->moved) return;
    positions_begin(r, x);
    medium_deposit(r->medium, r->solid->n, (const double *const *)x, r->solid->volume);
    positions_end(r, x);
    r->deposited = r->step;
}

const double *deposit_spread(struct run *r) {
    double *x[3];
    positions_begin(r, x);
    const double *spread = medium_spread(r->medium, r->solid->n, (const double *const *)x, r->solid->volume);
    positions_end(r, x);
    return spread;
}

struct medium_values deposit_measure(struct run *r) {
    deposit_update(r);
    struct medium_values v = medium_measure(r->medium, r->fluid, r->surface->immersed_area);
    if (r->measured.why[0] || v.porosity_effective == 0) v.permeability = v.reynolds = NAN;
    return v;
}
