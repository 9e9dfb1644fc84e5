/* Records the bonds that break or soften in a sweep, from each end. */
#include "solid/force/dilatation_loss.h"
#include "solid/force/dilatation.h"

void solid_dilatation_loss_add(struct solid *s, const struct solid_dilatation_loss *loss) {
    struct solid_dilatation *d = s->dilatation;
    if (!d || !d->of_body[s->body[loss->h]]) return;
    MEMORY_MORE(MEMORY_SOLID, d->loss, d->losses, d->capacity);
    d->loss[d->losses++] = *loss;
}
