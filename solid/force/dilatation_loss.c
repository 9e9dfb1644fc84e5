/* Records the bonds that break in a sweep, from each end. */
#include "solid/force/dilatation_loss.h"
#include "solid/force/dilatation.h"

void solid_dilatation_loss_add(struct solid *s, int h, int l, const double xi[3], double stiffness, double now,
                               double before) {
    struct solid_dilatation *d = s->dilatation;
    if (!d || !d->of_body[s->body[h]]) return;
    if (d->losses == d->room) {
        const size_t old = (size_t)d->room;
        d->room = 2 * d->room + 64;
        d->loss = memory_grown(MEMORY_SOLID, d->loss, old, (size_t)d->room, sizeof *d->loss);
    }
    d->loss[d->losses++] = (struct solid_dilatation_loss){h, l, {xi[0], xi[1], xi[2]}, stiffness, now, before};
}
