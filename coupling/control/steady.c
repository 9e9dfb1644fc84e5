/* Decides when a stage that waits for a quantity has become steady. */
#include "coupling/control/steady.h"
#include "base/ensure.h"
#include "coupling/interface/deposit.h"
#include "coupling/run.h"

#include <math.h>

/* Samples a window, and the largest factor between the spreads of two windows that counts: a spread of round-off does
 * not fall any more. */
enum { SAMPLES = 20 };
#define SLOWEST 0.99
/* Part of the spread that the change from the window's first sample to its last one is if the value is on its way, and
 * does not only vary about a mean. */
#define ON_ITS_WAY 0.8

static const struct scene_stage *stage_of(const struct run *r) { return &r->scene->stage[r->stage]; }

void steady_begin(struct run *r) { r->steady = (struct steady){0}; }

int steady_may_end(const struct run *r, long stage_step) {
    return stage_of(r)->has_until && stage_step % stage_of(r)->until_window == 0;
}

int steady_is_due(const struct run *r, long stage_step) {
    const struct scene_stage *s = stage_of(r);
    if (!s->has_until) return 0;
    const int every = s->until_window > SAMPLES ? s->until_window / SAMPLES : 1;
    return steady_may_end(r, stage_step) || stage_step % s->until_window % every == 0;
}

int steady_has_ended(const struct run *r) { return stage_of(r)->has_until && r->steady.ended; }

static double value_of(struct run *r, enum scene_until_quantity quantity) {
    const struct medium_values v = deposit_measure(r);
    switch (quantity) {
    case SCENE_UNTIL_PERMEABILITY:
        return v.permeability;
    }
    ENSURE(0, "quantity %d", (int)quantity);
}

/* How far the value is still from its end.
 *
 *  value
 *   |         _ _ _ _ _ _ _  end
 *   |      .  - - -  left = spread r/(1 - r)
 *   |   .     - - -
 *   | .       spread
 *   +-------+--------+----   windows; r: this spread over the one before
 *
 * A value that varies about a mean, as with implicit diffusion, is as far from it as its spread. */
static double left_after(const struct steady *s, double value) {
    const double spread = s->high - s->low, ratio = s->windows && spread < s->spread ? spread / s->spread : 1;
    const double r = spread == 0 ? 0 : fmin(ratio, SLOWEST);
    return fabs(value - s->first) < ON_ITS_WAY * spread ? spread : spread * r / (1 - r);
}

int steady_sample(struct run *r, struct steady_found *found) {
    const struct scene_stage *stage = stage_of(r);
    struct steady *s = &r->steady;
    const double value = value_of(r, stage->until_quantity);
    const int ends = steady_may_end(r, r->stage_step);
    if (ends) *found = (struct steady_found){value, NAN, NAN};
    if (!isfinite(value)) {
        *s = (struct steady){0};
        return 0;
    }
    if (s->samples == 0) s->first = s->low = s->high = value;
    s->low = fmin(s->low, value);
    s->high = fmax(s->high, value);
    s->samples++;
    if (!ends) return 0;
    const double spread = s->high - s->low, left = left_after(s, value);
    found->spread = spread / fabs(value);
    if (s->windows) found->left = left / fabs(value);
    s->ended = s->windows && found->spread <= stage->until_change && found->left <= stage->until_change;
    s->spread = spread;
    s->first = s->low = s->high = value;
    s->samples = 1;
    s->windows++;
    return (int)s->ended;
}
