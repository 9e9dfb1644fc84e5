/* Accelerations by contact in the last substep. */
#include "solid/contact/past.h"
#include "solid/contact/room.h"

#include <string.h>

void solid_contact_past_copy(struct solid_contact_past *to, const struct solid_contact_past *from) {
    to->of = solid_contact_room(to->of, &to->room, from->n, sizeof *to->of);
    to->n = from->n;
    to->missed = from->missed;
    if (from->n > 0) memcpy(to->of, from->of, (size_t)from->n * sizeof *to->of);
}
