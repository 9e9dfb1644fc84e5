/* Finds elastic stages with the load by probes whose bonds nothing damps. */
#include "coupling/control/undamped.h"
#include "coupling/control/time_step.h"
#include "solid/step/rates.h"

#include <math.h>
#include <stdio.h>

/* Of the critical damping of the fastest wave (docs/design/coupling.md). */
static const double PART = 0.25;

/* The damping that is PART of the critical one, N s/m7: the rate of damping is in proportion to it. */
static double advised(struct run *r) {
    struct solid_stage *stage = &r->solid->stage;
    const struct solid_stage given = *stage;
    struct solid_rates with;
    stage->damping_relative = 1;
    solid_rates_of(r->solid, &with);
    *stage = given;
    return PART * 2 * sqrt(with.stiffness) / with.damping;
}

int undamped_of(struct run *r, char sentence[UNDAMPED_SENTENCE]) {
    const struct scene_stage *stage = run_stage(r);
    const int by_probe = r->needs.immersed && r->scene->coupling->load == SCENE_LOAD_PROBE;
    if (!by_probe || !r->needs.bonds || stage->solid != SCENE_SOLID_ELASTIC || stage->damping_relative > 0) return 0;
    if (time_step_is_heavy(r)) return 0;
    const double damping = advised(r);
    if (!isfinite(damping)) return 0; /* no bonds */
    snprintf(sentence, UNDAMPED_SENTENCE,
             "stage %s: with coupling.load: probe nothing damps the bonds, and waves that are too fast for the fluid's "
             "step may grow without bound: damping_relative: %.2g is a quarter of the critical damping of the "
             "fastest ones; coupling.load: reaction needs none",
             stage->name, damping);
    return 1;
}
