/* Follows the stable step of a solid whose bonds are stretched. */
#include "coupling/control/strained.h"
#include "base/files/log.h"
#include "coupling/run.h"
#include "solid/step/shadow.h"
#include "solid/step/strained.h"

#include <math.h>

/* Substeps between two checks; a wave crosses some two spacings in three of them. */
enum { LOOK_EVERY = 8, AGAIN_EVERY = 100 };
/* Rates are found again once the stretch is more than GROWS times that of the last time and MORE, or, every hundred
 * steps, if it has been less than that over FALLS since. In between the frequency rises by 2 to 3 % at most. */
static const double GROWS = 1.05, FALLS = 1.5;
#define MORE 0.02

/* The part of the stable step that an undamped solid of this stretch can take for long. Waves of the angles theta in a
 * step of velocity Verlet feed each other through the forces' nonlinearity where three of them add up to a full turn,
 * in second order where four do. The largest angle, 2 asin(omega dt/2), is below 2 pi/3 for dt below 0.866 of the
 * stable step, and below pi/2 below 0.707. RK3 damps such waves. (docs/design/solid-motion.md) */
static double part_of(enum solid_integrator integrator, double stretch) {
    static const double most[] = {MORE, 0.1, 0.25}, part[] = {0.97, 0.85, 0.7, 0.5};
    int k = 0;
    while (integrator == SOLID_VERLET && k < 3 && stretch > most[k]) k++;
    return part[k];
}

static void find(struct run *r, double stretch) {
    const double before = r->strained.factor;
    r->strained.stretch = stretch;
    r->strained.factor = fmax(1, solid_rates_strained(r->solid) / r->solid_rates.stiffness);
    if (!r->control.replays && r->stage_step > 0 && fabs(r->strained.factor - before) > 0.05)
        log_line("step %ld: bonds are stretched by up to %.2g %%, which makes the solid's largest frequency %.3g times "
                 "that at rest",
                 r->step, 100 * stretch, sqrt(r->strained.factor));
}

static int is_due(const struct run *r) {
    const long every = r->substeps > 1 ? LOOK_EVERY / r->substeps : LOOK_EVERY;
    return every <= 1 || r->stage_step % every == 0;
}

static void update(struct run *r) {
    struct run_strained *strained = &r->strained;
    const double stretch = solid_strained_stretch(r->stretched);
    strained->recent = fmax(strained->recent, stretch);
    if (stretch > GROWS * strained->stretch + MORE) find(r, stretch);
    if (strained->stretch == 0 || r->stage_step % AGAIN_EVERY) return;
    if (strained->recent <= MORE)
        *strained = (struct run_strained){.factor = 1};
    else if (strained->recent < strained->stretch / FALLS)
        find(r, strained->recent);
    strained->recent = 0;
}

void strained_update(struct run *r) {
    if (r->stretched && is_due(r)) update(r);
}

void strained_begin(struct run *r) {
    solid_strained_free(r->stretched);
    r->stretched = r->solid_rates.stiffness > 0 ? solid_strained_new(r->solid) : NULL;
    if (r->stage_step == 0) r->strained = (struct run_strained){.factor = 1};
    if (r->stage_step == 0 && r->stretched) update(r);
}

double strained_step(const struct run *r, double stable) {
    if (r->strained.stretch == 0) return stable;
    const double part = part_of(r->solid->stage.integrator, r->strained.stretch);
    return fmin(stable, stable / sqrt(r->strained.factor) * part / run_stage(r)->safety);
}

double strained_waves(struct run *r) {
    const struct solid *s = r->solid;
    if (!r->stretched || !(r->strained.stretch > 0) || s->stage.integrator != SOLID_VERLET || s->soft) return 0;
    return solid_shadow_waves(r->solid, r->substeps > 0 ? r->dt / r->substeps : r->dt);
}
