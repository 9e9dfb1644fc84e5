/* Says which bodies of points have particles outside the domain. */
#include "coupling/interface/outside.h"

#include <stdio.h>

int outside_of(const struct solid *s, int body, int has_fluid, char sentence[OUTSIDE_SENTENCE]) {
    const struct solid_body *b = &s->in.body[body];
    char third[32] = "";
    if (b->outside == 0) return 0;
    if (s->dim == 3) snprintf(third, sizeof third, ", %g", b->outside_at[2]);
    snprintf(sentence, OUTSIDE_SENTENCE,
             "%ld of the %ld particles of %s lie outside the domain, the first in line %ld of its file at (%g, %g%s) "
             "m: %s",
             b->outside, b->points, b->name, b->outside_line, b->outside_at[0], b->outside_at[1], third,
             has_fluid ? "the fluid exerts no force on them, nor they on it"
                       : "the sides of the domain do not stop particles");
    return 1;
}
