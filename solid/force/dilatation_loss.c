/* Records the bonds that break or soften in a sweep, from each end. */
#include "solid/force/dilatation_loss.h"
#include "solid/force/dilatation.h"

void solid_dilatation_loss_add(struct solid *s, const struct solid_dilatation_loss *loss) {
    struct solid_dilatation *d = s->dilatation;
    if (!d || !d->of_body[s->body[loss->h]]) return;
    if (d->losses == d->capacity) {
        const size_t old = (size_t)d->capacity;
        d->capacity = 2 * d->capacity + 64;
        d->loss = memory_grown(MEMORY_SOLID, d->loss, old, (size_t)d->capacity, sizeof *d->loss);
    }
    d->loss[d->losses++] = *loss;
}
