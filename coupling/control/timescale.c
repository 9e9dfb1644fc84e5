/* Says that a step of the fluid is so long for the solid that a run will hardly end, or that too many bonds break. */
#include "coupling/control/timescale.h"
#include "physics/dilatation.h"
#include "physics/waves.h"

#include <math.h>
#include <stdio.h>

/* Substeps in a step; the main case takes some ten. */
static const double COSTLY = 1000, HOPELESS = 10000;
/* Fluid's steps over the solid's stable step: from COARSE on a tenth more bonds break than with short steps, with
 * ADVISED about a twentieth, at a density ratio of 3 (cases/verification/cost). A solid HEAVY times as dense as the
 * fluid is taken to feel none of it. */
static const double COARSE = 4.5, ADVISED = 2.5, HEAVY = 30;

static double step_of(const struct run *r) {
    if (r->dt > 0 || !r->fluid) return r->dt;
    return r->scene->stage[r->stage].cfl * fluid_limits_foreseen(r->fluid).step;
}

double timescale_substeps(struct run *r) {
    const struct scene_stage *stage = &r->scene->stage[r->stage];
    if (!r->needs.bonds || stage->solid != SCENE_SOLID_ELASTIC || stage->relax) return 0;
    if (stage->substeps > 0) return stage->substeps;
    const double least = ceil(step_of(r) / (stage->safety * r->solid_stable) * (1 - 1e-12));
    return isfinite(least) ? fmax(fmax(least, r->substeps), 1) : 1;
}

static double lightest(const struct scene_solid *solid) {
    double density = INFINITY;
    for (int m = 0; m < solid->materials; m++) density = fmin(density, solid->material[m].density);
    return density;
}

/* Waves that breaking bonds release meet a fluid that answers only at its next stage. */
static int breaks_too_much(const struct run *r, double dt, char sentence[TIMESCALE_SENTENCE]) {
    const struct scene_stage *stage = &r->scene->stage[r->stage];
    const double ratio = dt / r->solid_stable;
    if (!r->needs.immersed || !r->needs.breakage || !stage->breakage || ratio < COARSE) return 0;
    if (stage->damping_relative > 0) return 0; /* the bonds damp these waves */
    if (lightest(r->scene->solid) >= HEAVY * fluid_input_of(r->fluid)->density) return 0;
    snprintf(sentence, TIMESCALE_SENTENCE,
             "stage %s: bonds may break, and the step of %.3g s is %.3g times the solid's stable step of %.3g s: some "
             "tenth or more of the broken bonds are due to that. time_step: %.2g leaves a twentieth, half of it less "
             "(docs/choosing.md)",
             stage->name, dt, ratio, r->solid_stable, ADVISED * r->solid_stable);
    return 1;
}

int timescale_of(struct run *r, char sentence[TIMESCALE_SENTENCE]) {
    const double n = timescale_substeps(r), dt = step_of(r);
    if (!(n > 0)) return 0;
    if (n < COSTLY) return breaks_too_much(r, dt, sentence);
    double fastest = 0;
    const enum physics_model model = (enum physics_model)r->solid->in.model;
    for (int m = 0; m < r->scene->solid->materials; m++) {
        const struct scene_material *s = &r->scene->solid->material[m];
        fastest = fmax(fastest, physics_waves_of(model, s->youngs_modulus,
                                                 physics_dilatation_ratio(model, s->poisson_ratio), s->density)
                                    .longitudinal);
    }
    snprintf(sentence, TIMESCALE_SENTENCE,
             "stage %s: %.0f substeps a step%s: the step of %.3g s%s is %.3g times the solid's stable step of %.3g s, "
             "limited by %s (waves of %.4g m/s cross a spacing of %.3g m in %.3g s). A softer or denser material, a "
             "larger spacing or a shorter time_step bring the two nearer to each other",
             r->scene->stage[r->stage].name, n, n < HOPELESS ? "" : ": the run is hopeless", dt,
             r->fluid ? " of the fluid" : "", dt / r->solid_stable, r->solid_stable,
             solid_stable_bound_name[r->solid_bound], fastest, r->solid->in.spacing, r->solid->in.spacing / fastest);
    return 1;
}
