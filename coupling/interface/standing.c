/* Finds bodies that stand on a wall in a fluid with a weight. The fluid inside a body has the pressure of that beside
 * it, and bears the body's foot: so the load by reaction is the buoyancy, as with a film of fluid beneath. Sealed off
 * there, the body would bear the weight of the column above its foot, rho g H A, in addition. */
#include "coupling/interface/standing.h"
#include "base/par.h"
#include "base/side.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Spacings from the wall to the centre of a particle that stands on it: half a one, and what it sinks in. A body that
 * is held in the wall has one such layer, too. */
static const double DEEP = -0.25, NEAR = 0.75;
/* The least part of the buoyancy that is said: a ball touches with less. */
static const double LEAST = 0.05;

/* The wall towards which the fluid's weight points. 0: there is none. */
static int find_floor(const struct fluid_input *in, int *c, int *high) {
    for (*c = 0; *c < 3; ++*c) {
        *high = in->body_force[*c] > 0;
        const enum fluid_side_type type = in->side[*c][*high].type;
        if (in->body_force[*c] != 0 && (type == FLUID_WALL || type == FLUID_SLIP)) return 1;
    }
    return 0;
}

static int is_wanted(const struct run *r, int *c, int *high) {
    return r->fluid && r->reaction && r->solid->dim == 3 && find_floor(fluid_input_of(r->fluid), c, high);
}

void standing_measure(const struct run *r, int at_start, struct standing bodies[]) {
    enum { SUMS = sizeof *bodies / sizeof(double) };
    const struct solid *s = r->solid;
    int c, high;
    if (!is_wanted(r, &c, &high)) return;
    memset(bodies, 0, (size_t)s->in.bodies * sizeof *bodies);
    const double height = r->scene->domain.size[c];
    for (int h = 0; h < s->n; h++) {
        const double x = s->x0[c][h] + (at_start ? 0 : s->d[c][h]);
        const double above = (high ? height - x : x) / s->in.spacing;
        struct standing *body = &bodies[s->body[h]];
        if (above >= DEEP && above < NEAR) body->area += s->in.spacing * s->in.spacing;
        if (above >= DEEP) body->volume += s->volume[h];
    }
    par_sum_array(&bodies[0].volume, SUMS * s->in.bodies);
}

int standing_of(const struct run *r, int body, const struct standing *bodies, char sentence[STANDING_SENTENCE]) {
    int c, high;
    if (!is_wanted(r, &c, &high)) return 0;
    const struct fluid_input *in = fluid_input_of(r->fluid);
    const double weight = in->density * fabs(in->body_force[c]), flooded = weight * bodies[body].volume,
                 sealed = weight * r->scene->domain.size[c] * bodies[body].area - flooded;
    if (!(flooded + sealed > LEAST * flooded)) return 0;
    snprintf(sentence, STANDING_SENTENCE,
             "body %s stands on %s with %.3g m2: the load on it is that with fluid beneath it, at rest %.3g N away "
             "from this side; sealed off there it would be %.3g N %s it, with pressures counted from the opposite side",
             r->solid->in.body[body].name, side_name[c][high], bodies[body].area, flooded, fabs(sealed),
             sealed > 0 ? "towards" : "away from");
    return 1;
}
