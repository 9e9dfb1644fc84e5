/* Finds bodies that stand on a wall in a fluid with a weight. The fluid inside a body has the pressure of that beside
 * it, and bears the body's foot: so the load by reaction is the buoyancy, as with a film of fluid beneath. Sealed off
 * there, the body would bear the weight of the column above its foot, rho g H A, in addition. */
#include "coupling/interface/standing.h"
#include "base/par.h"
#include "base/side.h"

#include <math.h>
#include <stdio.h>

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

int standing_of(const struct run *r, int body, int at_start, char sentence[STANDING_SENTENCE]) {
    const struct solid *s = r->solid;
    int c, high;
    if (!r->fluid || !r->reaction || s->dim < 3) return 0;
    const struct fluid_input *in = fluid_input_of(r->fluid);
    if (!find_floor(in, &c, &high)) return 0;
    double sum[2] = {0}; /* volume, area on the wall */
    const double height = r->scene->domain.size[c];
    for (int h = 0; h < s->n; h++) {
        if (s->body[h] != body) continue;
        const double x = s->x0[c][h] + (at_start ? 0 : s->d[c][h]);
        const double above = (high ? height - x : x) / s->in.spacing;
        if (above >= DEEP && above < NEAR) sum[1] += s->in.spacing * s->in.spacing;
        if (above >= DEEP) sum[0] += s->volume[h];
    }
    par_sum_array(sum, 2);
    const double weight = in->density * fabs(in->body_force[c]), flooded = weight * sum[0],
                 sealed = weight * height * sum[1] - flooded;
    if (!(flooded + sealed > LEAST * flooded)) return 0;
    snprintf(sentence, STANDING_SENTENCE,
             "body %s stands on %s with %.3g m2: the load on it is that with fluid beneath it, at rest %.3g N away "
             "from this side; sealed off there it would be %.3g N %s it, with pressures counted from the opposite side",
             s->in.body[body].name, side_name[c][high], sum[1], flooded, fabs(sealed),
             sealed > 0 ? "towards" : "away from");
    return 1;
}
