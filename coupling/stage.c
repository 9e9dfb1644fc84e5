/* The start of a stage: the needs of its steps, and the numbers that it starts with. */
#include "coupling/control/duration.h"
#include "coupling/control/time_step.h"
#include "coupling/control/origins.h"
#include "coupling/control/strained.h"
#include "coupling/control/substeps.h"
#include "coupling/stage.h"
#include "base/die.h"
#include "base/files/log.h"
#include "base/par.h"
#include "coupling/control/refinement.h"
#include "cracks/cracks.h"
#include "fluid/scheme.h"
#include "solid/contact/contact.h"
#include "solid/imposed/constraint.h"
#include "solid/step/integrate.h"
#include "solid/step/rates.h"

#include <math.h>
#include <string.h>

static int is_elastic(const struct scene *scene, int k) {
    return scene->solid && scene->stage[k].solid == SCENE_SOLID_ELASTIC;
}

unsigned stage_needs_of(const struct scene *scene, int k, int can_touch) {
    const struct scene_stage *stage = &scene->stage[k];
    if (stage->relax) return stage->increment > 0 ? STAGE_INCREMENTS : STAGE_RELAXATION;
    unsigned needs = 0;
    if (stage->duration > 0) needs |= STAGE_DURATION;
    if (scene->fluid) needs |= STAGE_FLUID;
    if (scene->fluid && stage->time_step <= 0) needs |= STAGE_AUTOMATIC_STEP;
    if (scene->fluid && scene->fluid->diffusion == SCENE_DIFFUSION_IMPLICIT) needs |= STAGE_IMPLICIT;
    if (scene->fluid && scene->solid) needs |= STAGE_IMMERSED;
    if (!is_elastic(scene, k)) return needs;
    needs |= STAGE_ELASTIC;
    if (scene->fluid && load_kind_of(scene->coupling->load)->step) needs |= STAGE_REACTION;
    if (scene->solid->refinement) needs |= STAGE_REFINEMENT;
    if (stage->crack_fluid) needs |= STAGE_CRACK_FLUID;
    if (scene_stage_rests(stage)) needs |= STAGE_SETTLING;
    if (can_touch) needs |= STAGE_CONTACT;
    if (stage->substeps == 0 && needs & (STAGE_CONTACT | STAGE_AUTOMATIC_STEP)) needs |= STAGE_AUTOMATIC_SUBSTEPS;
    return needs;
}

int stage_has_ended(const struct run *r) {
    return r->stage_step >= run_stage(r)->steps || duration_is_over(r) || steady_has_ended(r);
}

/* Resets the numbers of the stage before. In the middle of a stage the automatic step and the number of substeps are
 * kept. */
static void begin_numbers(struct run *r, int elastic) {
    const struct scene_stage *stage = &r->scene->stage[r->stage];
    const int starts = r->stage_step == 0;
    if (stage->time_step > 0 || !r->fluid || starts) r->dt = stage->increment > 0 ? stage->increment : stage->time_step;
    if (!elastic || starts) r->substeps = 0;
    if (starts) r->refined.level = -1;
    if (starts) steady_begin(r);
}

static void find_stable_step(struct run *r) {
    if (r->scene->solid->refinement)
        refinement_rates(r);
    else if (!solid_rates_again(r->solid, &r->rates_found, &r->solid_rates)) {
        solid_rates_of(r->solid, &r->solid_rates);
        r->rates_found = (struct solid_rates_found){1, r->solid->stage.damping_relative, r->solid_rates};
    }
    settle_begin(r);
    r->solid_stable = solid_stable_of(&r->solid_rates, r->solid->stage.integrator, 0, &r->solid_bound);
}

/* A rigid stage begins: a support stops the solid, which stands still from now on, and so does the fluid inside it.
 * What is driven goes on in the next elastic stage. */
static void stand_still(struct run *r) {
    struct solid *s = r->solid;
    double momentum[3] = {0};
    const double fastest = par_max(substeps_fastest(s));
    for (size_t q = 0; q < sizeof r->inner / sizeof *r->inner; q++) r->inner[q].time = -1;
    if (fastest == 0) return;
    for (int c = 0; c < s->dim; c++)
        for (int h = 0; h < s->n; h++) {
            const double mass = solid_density(s, h) * s->volume[h];
            momentum[c] += mass * s->v[c][h];
            if (r->step > 0) s->e_constraint -= 0.5 * mass * s->v[c][h] * s->v[c][h];
            s->v[c][h] = 0;
            if (r->v_last[0]) r->v_last[c][h] = 0;
        }
    if (r->step == 0) return; /* only driven particles had a velocity, and nothing has moved */
    r->moved = r->step + 1;
    par_sum_array(momentum, 3);
    log_line(
        "stage %s: the solid, as fast as %.4g m/s, stands still from now on: its momentum of (%.4g, %.4g, %.4g) N s "
        "ends",
        run_stage(r)->name, fastest, momentum[0], momentum[1], momentum[2]);
}

/* In the midst of a rigid stage, which a run is resumed in: without an elastic stage a checkpoint has no velocities,
 * and driven particles have those that they were made with. */
static void stay_still(struct run *r) {
    struct solid *s = r->solid;
    for (int c = 0; c < s->dim; c++) memset(s->v[c], 0, (size_t)(s->n + s->n_ghost) * sizeof(double));
}

/* Fluid in cracks changes what the last sweep keeps of contact (solid/state.h, v_old). */
static int fluid_in_cracks_changes(const struct run *r) {
    const struct scene_stage *stage = &r->scene->stage[r->stage];
    return r->stage > 0 && stage[0].crack_fluid != stage[-1].crack_fluid;
}

/* Sets the integrator, its stable step, and the time step of a solid alone. refined: the last step, if a refinement has
 * shortened the stable one since; else 0. */
static void begin_solid(struct run *r, double refined) {
    const struct scene_stage *stage = &r->scene->stage[r->stage];
    const int held = r->solid->a_holds && !fluid_in_cracks_changes(r);
    if (r->stage_step == 0 && r->stage > 0 && !is_elastic(r->scene, r->stage - 1))
        solid_constraint_velocity(r->solid, r->t, 0);
    setup_stage(stage, &r->solid->stage);
    if (!stage->relax) find_stable_step(r);
    if (r->stage_step > 0)
        solid_integrate_resume(r->solid);
    else
        r->solid->a_holds = held; /* finding rates keeps the last sweep's forces (solid/step/verlet.c) */
    if (r->fluid || stage->relax || r->dt > 0) return; /* a relaxation takes no time, an increment its own */
    if (!isfinite(r->solid_stable))
        die_all(EXIT_CODE_SCENE, "stage %s: time_step: needs a value, because no bond limits it", stage->name);
    r->dt = refined > 0 ? refined : stage->safety * r->solid_stable;
}

/* Sets the number of substeps: given, or the least stable one. If an automatic time step is not known yet, a part of
 * the step sets the number. */
static void begin_substeps(struct run *r, unsigned needs) {
    const struct scene_stage *stage = &r->scene->stage[r->stage];
    if (stage->substeps > 0)
        r->substeps = stage->substeps;
    else if (r->dt > 0 && (r->substeps == 0 || !(needs & STAGE_AUTOMATIC_SUBSTEPS)))
        r->substeps = substeps_wanted(r);
}

unsigned stage_begin(struct run *r) {
    const int elastic = is_elastic(r->scene, r->stage), relaxes = r->scene->stage[r->stage].relax;
    if (r->fluid) fluid_scheme_set(r->fluid, r->scene->stage[r->stage].fluid_integrator);
    const double refined = r->stage_step > 0 && r->solid && r->solid->refine ? r->dt : 0;
    time_step_begin_stage(r);
    origins_set(r);
    begin_numbers(r, elastic);
    if (elastic) begin_solid(r, refined);
    if (!elastic && !relaxes && r->solid) (r->stage_step == 0 ? stand_still : stay_still)(r);
    if (r->crack_outlets && !r->scene->stage[r->stage].crack_fluid) fluid_volume_source_clear(r->fluid);
    if (r->cracks) (r->stage_step > 0 ? cracks_resume : cracks_begin)(r->cracks, r->scene->stage[r->stage].crack_fluid);
    const int can_touch = elastic && !relaxes && r->needs.contact && solid_contact_is_possible(r->solid);
    unsigned needs = stage_needs_of(r->scene, r->stage, can_touch);
    if (needs & STAGE_ELASTIC) strained_begin(r);
    r->control.strain_alone = !(needs & STAGE_AUTOMATIC_SUBSTEPS);
    if (needs & STAGE_ELASTIC && r->stretched && run_stage(r)->substeps == 0) needs |= STAGE_AUTOMATIC_SUBSTEPS;
    if (needs & STAGE_ELASTIC) begin_substeps(r, needs);
    return needs;
}
