/* Compares a stage's given step and substeps with the limits of the fluid and of the solid. */
#include "coupling/control/overstep.h"
#include "base/die.h"
#include "coupling/control/substeps.h"
#include "coupling/control/time_step.h"
#include "solid/contact/contact.h"
#include "solid/contact/implicit.h"

#include <float.h>
#include <math.h>
#include <stdio.h>

/* Tolerance for a given step that is the printed limit itself, rounded. */
static const double ROUNDED = 1 + 1e-5;

static int of_fluid(const struct scene_stage *stage, const struct fluid_limits *l, int implicit, char *sentence) {
    const int convective = implicit || l->convective < l->viscous;
    const double limit = convective ? l->convective : l->viscous;
    if (!(limit > 0)) {
        snprintf(sentence, OVERSTEP_SENTENCE,
                 "stage %s: the fluid's %s limit is 0 s, so no step is stable: domain.size, domain.cells and "
                 "fluid.viscosity give cells that are too small for numbers",
                 stage->name, convective ? "convective" : "viscous");
        return 1;
    }
    if (stage->time_step <= ROUNDED * limit) return 0; /* an automatic step is 0 */
    snprintf(sentence, OVERSTEP_SENTENCE,
             "stage %s: the step of %.5g s is %.4g times the fluid's %s limit%s: at most %.5g s is stable", stage->name,
             stage->time_step, stage->time_step / limit, convective ? "convective" : "viscous",
             convective ? " for the velocities that the scene gives" : "", limit);
    return 1;
}

static int of_solid(struct run *r, const struct scene_stage *stage, double dt, char *sentence) {
    const double substep = dt / r->substeps;
    const char *limited = solid_stable_bound_name[r->solid_bound], *once = "";
    double limit = r->solid_stable;
    if (substep <= ROUNDED * limit && stage->substeps > 0 && r->needs.contact && !solid_contact_implicit_is(r->solid) &&
        solid_contact_is_possible(r->solid)) {
        limit = solid_stable_linear(&r->solid_rates, r->solid->stage.integrator, solid_contact_rate_touch(r->solid));
        limited = solid_stable_bound_name[SOLID_BOUND_CONTACT];
        once = ", once a broken bond has closed";
    }
    if (substep <= ROUNDED * limit) return 0;
    snprintf(sentence, OVERSTEP_SENTENCE,
             "stage %s: the solid's substep of %s%.5g s is %.4g times its limit by %s%s: at most %.5g s is stable, "
             "which takes "
             "%.0f substeps in a step",
             stage->name, stage->time_step > 0 ? "" : "up to ", substep, substep / limit, limited, once, limit,
             ceil(dt / (stage->safety * limit) * (1 - 1e-12)));
    return 1;
}

/* Fewer substeps than an automatic number has where the drag of the markers acts within the step. */
static int of_few(const struct run *r, const struct scene_stage *stage, char *sentence) {
    const int fewest = substeps_fewest(r);
    if (stage->substeps == 0 || stage->substeps >= fewest) return 0;
    snprintf(sentence, OVERSTEP_SENTENCE,
             "stage %s: %d substep%s in a step %s fewer than %d, the least automatic number with %s: the drag on the "
             "surface then acts so late in the step that slow waves of thick bodies may grow",
             stage->name, stage->substeps, stage->substeps > 1 ? "s" : "", stage->substeps > 1 ? "are" : "is", fewest,
             stage->fluid_integrator == FLUID_RK3 ? "fluid_integrator: rk3 and so light a solid"
                                                  : "fluid_integrator: ab2");
    return 1;
}

/* Dies on a given step that advances nothing. Values change by about themselves in a stable step, so in EPSILON of one
 * no number of 16 digits changes, and in a stage of less than NONE of one none by more than the rounding of some steps;
 * and a time that earlier stages have reached does not grow by less than EPSILON of it. */
static void refuse(const struct run *r, const struct scene_stage *stage, double stable) {
    static const double NONE = 1e-9;
    const double dt = stage->time_step, all = (double)stage->steps * dt;
    double before = 0; /* s that earlier stages take at least */
    for (const struct scene_stage *s = r->scene->stage; s < stage; s++)
        if (!s->has_until && !s->relax && !(s->duration > 0)) before += (double)s->steps * s->time_step;
    if (!(dt > 0) || stage->steps == 0) return;
    if (isfinite(stable) && dt < DBL_EPSILON * stable)
        die_all(EXIT_CODE_SCENE,
                "stage %s: the step of %.4g s is %.2g of a stable one, %.4g s: no value of 16 digits changes in such a "
                "step",
                stage->name, dt, dt / stable, stable);
    if (isfinite(stable) && all < NONE * stable)
        die_all(EXIT_CODE_SCENE,
                "stage %s: all its steps of %.4g s together are %.2g of one stable step, %.4g s: nothing moves: take "
                "%.2g s or more, or leave time_step out",
                stage->name, dt, all / stable, stable, NONE * stable / (double)stage->steps);
    if (before + dt == before)
        die_all(EXIT_CODE_SCENE,
                "stage %s: the step of %.4g s is lost in the rounding of the time, which is %.4g s after the stages "
                "before: take %.2g s or more",
                stage->name, dt, before, DBL_EPSILON * before);
}

/* Warns if the given step is less than LEAST of a stable one, and the whole stage is shorter than one stable step. */
static int of_nothing(const struct scene_stage *stage, double stable, char *sentence) {
    static const double LEAST = 1e-6;
    const double all = (double)stage->steps * stage->time_step;
    if (!(stage->time_step > 0 && stage->time_step < LEAST * stable && all < stable)) return 0;
    snprintf(sentence, OVERSTEP_SENTENCE,
             "stage %s: the step of %.4g s is %.2g of a stable one, %.4g s: nothing moves in %ld such steps",
             stage->name, stage->time_step, stage->time_step / stable, stable, stage->steps);
    return 1;
}

/* A step in which something moves, s: a flow that pressures or forces set in motion has no velocity yet. */
static double moving_step(const struct run *r, const struct fluid_limits *l) {
    const double *d = fluid_grid_of(r->fluid)->d, speed = fluid_limits_speed(r->fluid);
    return fmin(l->step, speed > 0 ? sqrt(3) * fmin(d[0], fmin(d[1], d[2])) / speed : INFINITY);
}

int overstep_of(struct run *r, char sentence[OVERSTEP_MAX][OVERSTEP_SENTENCE]) {
    const struct scene_stage *stage = &r->scene->stage[r->stage];
    struct fluid_limits l = {INFINITY, INFINITY, INFINITY};
    int n = 0;
    if (stage->relax) return 0;
    if (r->fluid) {
        l = fluid_limits_foreseen(r->fluid);
        n += of_fluid(stage, &l, fluid_input_of(r->fluid)->implicit, sentence[n]);
    }
    const double dt = stage->time_step > 0 ? stage->time_step
                      : r->fluid           ? fmin(stage->cfl * l.step, time_step_breaking(r))
                                           : r->dt;
    if (r->solid && stage->solid == SCENE_SOLID_ELASTIC && r->substeps > 0 && isfinite(dt))
        n += of_solid(r, stage, dt, sentence[n]);
    if (r->needs.immersed && stage->solid == SCENE_SOLID_ELASTIC && r->substeps > 0) n += of_few(r, stage, sentence[n]);
    const int elastic = r->solid && stage->solid == SCENE_SOLID_ELASTIC;
    const double stable =
        fmin(r->fluid ? moving_step(r, &l) : INFINITY, elastic && r->solid_stable > 0 ? r->solid_stable : INFINITY);
    refuse(r, stage, stable);
    return n + (isfinite(stable) && of_nothing(stage, stable, sentence[n]));
}
