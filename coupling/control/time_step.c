/* Chooses the length of an automatic time step. */
#include "coupling/control/time_step.h"
#include "base/files/log.h"
#include "base/par.h"
#include "coupling/run.h"

#include <math.h>

/* A new bound is logged once it has limited so many steps in a row. */
enum { LOG_AFTER_STEPS = 10 };
/* The step where bonds may break, over the solid's stable step: with it 2 % too many bonds break
 * (cases/verification/cost). */
static const double BREAKING = 1.2;
/* From this density ratio on, the fluid's step is taken to have no effect on the solid. */
static const double HEAVY = 30;

const char *const time_step_bound_name[] = {"the scene",         "convection",           "diffusion",        "growth",
                                            "a step made again", "bonds that may break", "the solid's start"};

int time_step_is_automatic(const struct run *r) { return r->fluid && run_stage(r)->time_step <= 0; }

void time_step_begin_stage(struct run *r) {
    r->control.limits_step = -1;
    r->control.dt_max = INFINITY;
    r->control.substeps_min = r->control.repeats = r->control.substeps_usual = 0;
    r->control.dt_first = 0;
    r->control.logged = STEP_BOUND_SCENE;
    if (r->stage_step == 0) r->control.approach = 0;
}

static double lightest(const struct scene_solid *solid) {
    double density = INFINITY;
    for (int m = 0; m < solid->materials; m++) density = fmin(density, solid->material[m].density);
    return density;
}

int time_step_is_heavy(const struct run *r) {
    return lightest(r->scene->solid) >= HEAVY * fluid_input_of(r->fluid)->density;
}

/* The fluid responds to waves from breaking bonds only in its next stage; damping of the bonds damps these waves. */
int time_step_counts(const struct run *r) {
    return r->needs.immersed && scene_stage_may_break(r->scene, r->stage) && run_stage(r)->damping_relative == 0 &&
           !time_step_is_heavy(r);
}

double time_step_breaking(const struct run *r) {
    if (!time_step_counts(r)) return INFINITY;
    return BREAKING * solid_stable_of(&r->solid_rates, SOLID_VERLET, 0, NULL);
}

/* The longest step with which the solid crosses no cell of the fluid, by its present velocity, and by its body force if
 * nothing holds it. */
static double carried(const struct run *r) {
    const struct solid *s = r->solid;
    const double *d = fluid_grid_of(r->fluid)->d;
    double rate = 0, pulled = 0;
    for (int h = 0; h < s->n; h++) {
        double sum = 0;
        for (int c = 0; c < s->dim; c++) sum += fabs(s->v[c][h]) / d[c];
        rate = fmax(rate, sum);
    }
    for (int c = 0; c < s->dim && s->in.constraints == 0; c++) pulled += fabs(s->in.body_force[c]) / d[c];
    return run_stage(r)->cfl * fluid_limits_of(r->fluid, par_max(rate) + sqrt(pulled)).convective;
}

double time_step_first(const struct run *r) {
    if (!r->needs.immersed || run_stage(r)->solid != SCENE_SOLID_ELASTIC) return INFINITY;
    const double most = carried(r);
    if (!fluid_input_of(r->fluid)->implicit) return most;
    const int moves = r->step > 0 && r->moved == r->step && r->dt_last > 0; /* 0: of an older checkpoint */
    return fmin(most, moves ? TIME_STEP_GROWTH * r->dt_last : run_stage(r)->cfl * fluid_limits_explicit_step(r->fluid));
}

/* Writes one line if another bound has limited the last steps. */
static void log_bound(struct run *r) {
    struct step_control *a = &r->control;
    if (a->replays || a->bound == a->logged || (a->logged != STEP_BOUND_SCENE && a->steps_bound < LOG_AFTER_STEPS))
        return;
    log_line("step %ld: time step %.4g s, bound by %s", r->step, r->dt, time_step_bound_name[a->bound]);
    a->logged = a->bound;
}

static void bounded_by(struct run *r, enum step_bound bound) {
    r->control.steps_bound = bound == r->control.bound ? r->control.steps_bound + 1 : 1;
    r->control.bound = bound;
}

void time_step_choose(struct run *r) {
    struct step_control *a = &r->control;
    const double before = r->stage_step > 0 ? TIME_STEP_GROWTH * r->dt : 0;
    if (a->limits_step != r->step) a->limits = fluid_limits_stable_step(r->fluid);
    enum step_bound bound = a->limits.convective < a->limits.viscous ? STEP_BOUND_CONVECTION : STEP_BOUND_DIFFUSION;
    r->dt = run_stage(r)->cfl * a->limits.step;
    const double breaking = time_step_breaking(r), first = r->stage_step == 0 ? time_step_first(r) : INFINITY;
    if (r->dt > first) r->dt = first, bound = STEP_BOUND_FIRST;
    if (r->dt > breaking) r->dt = breaking, bound = STEP_BOUND_BREAKING;
    if (before > 0 && r->dt > before) r->dt = before, bound = STEP_BOUND_GROWTH;
    if (r->dt > a->dt_max) r->dt = a->dt_max, bound = STEP_BOUND_REPEAT;
    if (!(a->dt_first > 0)) a->dt_first = r->dt;
    bounded_by(r, bound);
    log_bound(r);
}
