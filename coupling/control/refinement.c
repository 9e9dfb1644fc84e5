/* Refines the solid's plates during a run, and updates the rates that limit its stable step. */
#include "base/clock.h"
#include "coupling/control/refinement.h"
#include "coupling/run.h"
#include "base/files/log.h"
#include "solid/bonds/ghosts.h"
#include "solid/refine/refine.h"
#include "solid/step/rates.h"
#include "solid/step/stable.h"

#include <math.h>

/* Allowance for the growth of the fastest mode between levels as a refined region grows, so that Lanczos need not run
 * again. */
static const double GROWTH = 1.03;

/* Whether the given step is less than half as long as the bound allows: then the bound is used as the rate, and
 * leaves a margin for contact. One-sided horizons have no such bound, and damping has rates of its own. */
static int is_ample(struct run *r, double bound) {
    const struct scene_stage *stage = &r->scene->stage[r->stage];
    const struct solid_stage *solid = &r->solid->stage;
    const struct solid_rates rates = {
        .stiffness = bound, .sum = 1, .difference = 1, .absolute = solid->damping_absolute};
    if (r->solid->in.horizons != SOLID_DUAL_HORIZON || solid->damping_relative > 0 || !(r->dt > 0)) return 0;
    const double step = stage->safety * solid_stable_of(&rates, solid->integrator, 0, NULL);
    if (r->dt > 0.5 * step) return 0;
    r->solid_rates = rates;
    return 1;
}

/* Updates the rates after a refinement. The rates of Lanczos's iteration hold for the particles that it saw, and for
 * others of the same levels as long as the bound by families has not risen; a new level or a higher bound needs
 * another iteration. A small refined region has lower rates than an infinite one of its level; the rate of the
 * infinite one is included. The rate is never above the bound. */
void refinement_rates(struct run *r) {
    struct solid_rates *rates = &r->solid_rates;
    const double bound = solid_refine_rate_bound(r->solid);
    const int level = solid_refine_finest(r->solid);
    if (level <= r->refined.level && bound <= r->refined.rate2 * (1 + 1e-9)) return;
    r->refined = (struct run_refined){level, bound};
    if (is_ample(r, bound)) return;
    solid_rates_of(r->solid, rates);
    if (level > 0) rates->stiffness = fmax(GROWTH * rates->stiffness, solid_refine_rate_lattice(r->solid, level));
    if (r->solid->in.horizons == SOLID_DUAL_HORIZON) rates->stiffness = fmin(rates->stiffness, bound);
}

void refinement_check(struct run *r) {
    const struct scene_refinement *in = r->scene->solid->refinement;
    if (r->step % in->every != 0 || r->t < in->from) return;
    clock_begin(CLOCK_SOLID);
    r->solid->t = r->t;
    solid_ghosts_update(r->solid);
    const long refined = solid_refine_criteria(r->solid);
    if (refined > 0) {
        refinement_rates(r);
        log_line("step %ld: %ld particles refined, %ld in all, finest level %d", r->step, refined, r->solid->n_global,
                 solid_refine_finest(r->solid));
    }
    clock_end(CLOCK_SOLID);
}
