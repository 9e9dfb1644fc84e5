/* Writes to the log what a run holds, how far it is, and what its numbers are worth. */
#include "program/run/report.h"
#include "base/par.h"
#include "base/side.h"
#include "base/threads.h"
#include "base/files/log.h"
#include "coupling/control/duration.h"
#include "coupling/stage.h"
#include "coupling/control/blocked.h"
#include "coupling/control/contact_warning.h"
#include "coupling/control/piston.h"
#include "coupling/control/unbonded.h"
#include "coupling/control/unresolved.h"
#include "coupling/control/ramp.h"
#include "coupling/control/substeps.h"
#include "coupling/control/early_breakage.h"
#include "coupling/interface/near_outflow.h"
#include "coupling/interface/ratio.h"
#include "coupling/interface/outside.h"
#include "coupling/interface/standing.h"
#include "coupling/load/reaction.h"
#include "coupling/setup/image_cut.h"
#include "coupling/setup/image_voxel.h"
#include "cracks/cracks.h"
#include "program/check/groups.h"
#include "program/check/injection.h"
#include "program/output/left_out.h"

#include <math.h>
#include <stdio.h>

/* Reynolds number with the root of the permeability above which the log says that inertia counts. */
#define INERTIA 0.1

/* Along what the permeability is measured, or why it is not. */
static void report_direction(const struct run *r) {
    const double *e = r->measured.along;
    if (!r->medium) return;
    if (r->measured.why[0])
        log_line("permeability is not measured: %s", r->measured.why);
    else if (e[0] == 0 || e[1] == 0 || e[2] == 0 ? (e[0] != 0) + (e[1] != 0) + (e[2] != 0) > 1 : 1)
        log_line("permeability is measured along (%g, %g, %g)", e[0], e[1], e[2]);
    else
        log_line("permeability is measured along %c", "xyz"[medium_axis(r->medium)]);
}

/* Not of a resumed run, whose particles have moved. */
static void report_places(struct run *r) {
    char loose[UNBONDED_SENTENCE], sentence[CONTACT_WARNING_MAX][CONTACT_WARNING_SENTENCE];
    char outlet[NEAR_OUTFLOW_MAX][NEAR_OUTFLOW_SENTENCE], standing[STANDING_SENTENCE], ratio[RATIO_SENTENCE];
    struct standing stand[PHYSICS_BODIES_MAX];
    if (!r->solid || r->step > 0) return;
    if (ratio_of(r, ratio)) log_line("warning: %s", ratio);
    standing_measure(r, 1, stand);
    for (int b = 0; b < r->solid->in.bodies; b++) {
        for (int k = 0, n = near_outflow_of(r, b, outlet); k < n; k++) log_line("warning: %s", outlet[k]);
        if (standing_of(r, b, stand, standing)) log_line("%s", standing);
    }
    if (unbonded_of(r, loose)) log_line("warning: %s", loose);
    for (int k = 0, n = contact_warning_of(r, sentence); k < n; k++) log_line("warning: %s", sentence[k]);
}

static void log_warning(const char *sentence) { log_line("warning: %s", sentence); }

void report_set_up(struct run *r) {
    char left_out[LEFT_OUT_MAX][LEFT_OUT_SENTENCE], blocked[BLOCKED_MAX][BLOCKED_SENTENCE], outside[OUTSIDE_SENTENCE];
    char piston[PISTON_SENTENCE];
    char sentence[IMAGE_VOXEL_SENTENCE]; /* at least UNRESOLVED_, CHECK_GROUPS_ and IMAGE_CUT_SENTENCE */
    for (int k = 0, n = left_out_of(r->scene, left_out); k < n; k++) log_line("left out: %s", left_out[k]);
    for (int k = 0, n = blocked_of(r, blocked); k < n; k++) log_line("warning: %s", blocked[k]);
    if (piston_of(r, piston)) log_line("warning: %s", piston);
    for (int b = 0; r->solid && b < r->solid->in.bodies; b++)
        if (outside_of(r->solid, b, r->fluid != NULL, outside)) log_line("warning: %s", outside);
    if (r->fluid && unresolved_of(r, unresolved_velocity(r->scene->fluid), sentence)) log_line("warning: %s", sentence);
    for (int m = 0; r->solid && m < r->scene->solid->materials; m++)
        if (check_groups_light(r->scene, m, sentence)) log_line("warning: %s", sentence);
    for (int b = 0; par_rank() == 0 && r->solid && b < r->scene->solid->bodies; b++)
        if (image_voxel_differs(r->scene, b, sentence)) log_line("warning: %s", sentence);
    for (int c = 0; r->solid && c < 3; c++)
        if (image_cut_describe(r->cut_share[c], c, sentence)) log_line("warning: %s", sentence);
    check_injection_warn(r, log_warning);
    report_places(r);
    report_direction(r);
}

void report_threads(void) {
    const int threads = threads_count(), cores = threads_cores();
    if (cores > 0 && cores < threads)
        log_line("warning: %d threads of a rank share %d core%s: mpiexec --map-by slot:pe=%d gives them as many",
                 threads, cores, cores > 1 ? "s" : "", threads);
}

/* Before an automatic stage the step is known only where the stage before it has left one. */
static void report_steps(const struct run *r, const struct scene_stage *stage) {
    const int automatic = r->fluid && stage->time_step <= 0;
    char length[64] = "";
    if (r->dt > 0) snprintf(length, sizeof length, " of %.5g s", r->dt);
    if (stage->duration > 0)
        log_line("stage %s: until t = %.6g s, after %.6g s, at most %ld steps%s%s", stage->name,
                 r->began[r->stage] + stage->duration, stage->duration, stage->steps - r->stage_step, length,
                 automatic ? " (automatic)" : "");
    else
        log_line("stage %s: %ld steps%s%s", stage->name, stage->steps - r->stage_step, length,
                 automatic ? " (automatic)" : "");
}

void report_ramp(const struct run *r, int ends) {
    char sentence[RAMP_SENTENCE];
    if (ramp_of(r, ends, sentence)) log_line("warning: %s", sentence);
}

void report_ramp_of_stage(const struct run *r) {
    char sentence[RAMP_SENTENCE];
    if (r->stage >= SCENE_TIMED_MAX || r->stage + 1 == r->scene->stages) return; /* the run's end says it of the last */
    if (ramp_of_stage(r, r->began[r->stage], r->t, sentence)) log_line("warning: %s", sentence);
}

void report_duration(const struct run *r) {
    const struct scene_stage *stage = run_stage(r);
    if (stage->duration > 0 && !duration_is_over(r) && !steady_has_ended(r))
        log_line("warning: stage %s: all its %ld steps end at t = %.6g s, %.3g of its duration of %.6g s: more steps",
                 stage->name, stage->steps, r->t, (r->t - r->began[r->stage]) / stage->duration, stage->duration);
}

/* The first stage after the present one in which bonds may break; NULL: none. */
static const char *stage_that_breaks(const struct run *r) {
    for (int k = r->stage + 1; k < r->scene->stages; k++)
        if (scene_stage_may_break(r->scene, k)) return r->scene->stage[k].name;
    return NULL;
}

/* Of bonds that are stretched beyond their limits, because none may break in the stage. */
static void report_beyond(const struct run *r, const struct solid_reach *reach) {
    const char *then = stage_that_breaks(r);
    if (reach->softens && scene_stage_may_break(r->scene, r->stage)) return; /* they soften as they should */
    if (then)
        log_line(
            "warning: stage %s: %ld bonds are stretched beyond their %s stretch, the most by %.3g times: they %s at "
            "once when stage %s begins. The load is too large to settle under without breakage: raise it slowly in "
            "a stage in which bonds may break",
            run_stage(r)->name, reach->beyond, reach->softens ? "softening" : "critical", reach->part,
            reach->softens ? "soften" : "break", then);
    else
        log_line(
            "stage %s: %ld bonds are stretched beyond their %s stretch, the most by %.3g times, and no stage after "
            "it lets them break",
            run_stage(r)->name, reach->beyond, reach->softens ? "softening" : "critical", reach->part);
}

void report_strength(struct run *r) {
    const struct solid_reach reach = early_breakage_reach(r);
    const double stress = reach.modulus * reach.critical;
    if (reach.part >= 1)
        report_beyond(r, &reach);
    else if (reach.part > 0)
        log_line("stage %s: no bond has broken: the most stretched one is at %.3g of the %s stretch (a stress of "
                 "about %.3g of %.3g Pa): a load %.3g times as large %s the first",
                 run_stage(r)->name, reach.part, reach.softens ? "softening" : "critical", reach.part * stress, stress,
                 1 / reach.part, reach.softens ? "softens" : "breaks");
}

void report_early_breakage(struct run *r, const struct early_breakage_load *load) {
    char sentence[EARLY_BREAKAGE_SENTENCE];
    if (early_breakage_of(r, sentence)) log_line("warning: %s", sentence);
    if (early_breakage_flow_of(r, load, r->scene->output.series_every, sentence)) log_line("warning: %s", sentence);
}

void report_stage(const struct run *r) {
    const struct scene_stage *stage = &r->scene->stage[r->stage];
    if (!stage_has_ended(r)) report_steps(r, stage);
    if (r->substeps > 0 && !(r->dt > 0))
        log_line("stage %s: %d solid substeps a step, each stable up to %.4g s", stage->name, r->substeps,
                 r->solid_stable);
    else if (r->substeps > 0)
        log_line("stage %s: %d solid substeps of %.4g s, stable up to %.4g s", stage->name, r->substeps,
                 r->dt / r->substeps, r->solid_stable);
    report_ramp(r, 0);
}

void report_progress(const struct run *r, const struct series_sample *s) {
    const struct scene_stage *stage = &r->scene->stage[r->stage];
    const long every = r->scene->output.log_every, all = duration_steps(r);
    if (r->needs.immersed && r->needs.bonds)
        log_progress(stage->name, r->stage_step, all, every, "t %.4g s  dp %.4g Pa  broken %.0f", r->t,
                     s->medium.pressure_drop, s->bonds_broken);
    else if (r->needs.immersed)
        log_progress(stage->name, r->stage_step, all, every, "t %.4g s  dp %.4g Pa", r->t, s->medium.pressure_drop);
    else if (r->needs.fluid)
        log_progress(stage->name, r->stage_step, all, every, "t %.4g s  u %.4g m/s  div %.1e 1/s", r->t,
                     s->fluid.bulk_velocity, s->fluid.divergence_max);
    else
        log_progress(stage->name, r->stage_step, all, every, "t %.4g s  broken %.0f", r->t, s->bonds_broken);
}

/* Of all that is to be at rest: what each quantity is, how much it changes, and what is left of the change. */
static void describe_rest(const struct run *r, const struct steady_found *f, char *text, size_t size) {
    static const char *const name[] = {"strain energy", "flow's energy", "load of the flow"}, *const unit[] = {"J", "J",
                                                                                                               "N"};
    int n = 0;
    if (isnan(f->moving) && isnan(f->value[0]) && isnan(f->value[1]) && isnan(f->value[2])) {
        snprintf(text, size, ": too few windows of %d steps to tell what changes", run_stage(r)->until_window);
        return;
    }
    if (r->needs.bonds && run_stage(r)->solid == SCENE_SOLID_ELASTIC && !isnan(f->moving))
        n = snprintf(text, size, ": kinetic energy at most %.2g of the strain energy", f->moving);
    for (int q = 0; q < STEADY_QUANTITIES && n < (int)size; q++)
        if (!isnan(f->value[q]) && isnan(f->left[q]))
            n += snprintf(text + n, size - (size_t)n,
                          "%s %s %.4g %s (spread %.2g, too few windows to tell what is left)", n ? "," : ":", name[q],
                          f->value[q], unit[q], f->spread[q]);
        else if (!isnan(f->value[q]))
            n += snprintf(text + n, size - (size_t)n, "%s %s %.4g %s (spread %.2g, %.2g left)", n ? "," : ":", name[q],
                          f->value[q], unit[q], f->spread[q], f->left[q]);
    if (n < (int)size && r->settle.frequency > 0)
        n += snprintf(text + n, size - (size_t)n, "; slowest motion %.4g Hz, damping %.4g 1/s",
                      r->settle.frequency / 6.283185307179586, r->solid->stage.damping_absolute);
    if (n < (int)size && f->ramps) snprintf(text + n, size - (size_t)n, "; a load or constraint still changes");
}

void report_steadiness(const struct run *r, const struct steady_found *found, int is_steady, int is_last) {
    const struct scene_stage *stage = &r->scene->stage[r->stage];
    char what[512] = "";
    if (!stage->has_until || !(is_steady || is_last)) return;
    const int rests = scene_stage_rests(stage);
    char duration[64] = "";
    if (stage->duration > 0 && duration_is_over(r))
        snprintf(duration, sizeof duration, " and its duration of %.6g s", stage->duration);
    if (rests)
        describe_rest(r, found, what, sizeof what);
    else if (isnan(found->spread[0]))
        snprintf(what, sizeof what, ": permeability %.6g m2; too few windows of %d steps to tell its change",
                 found->value[0], stage->until_window);
    else
        snprintf(what, sizeof what, ": permeability %.6g m2, spread %.2g of it over %ld steps, %.2g left",
                 found->value[0], found->spread[0], found->windows * stage->until_window, found->left[0]);
    if (is_steady)
        log_line("stage %s: %s after %ld steps, t = %.6g s%s", stage->name, rests ? "at rest" : "steady", r->stage_step,
                 r->t, what);
    else if (rests)
        log_line("warning: stage %s: not at rest after all its %ld steps%s, t = %.6g s%s", stage->name, r->stage_step,
                 duration, r->t, what);
    else
        log_line("warning: stage %s: not steady after all its %ld steps%s, t = %.6g s%s", stage->name, r->stage_step,
                 duration, r->t, what);
}

/* The way of fluid or solid in a step, the faster one, in cells. In a full vessel the fluid before a piston rests. */
static double way_in_step(const struct run *r, const struct series_sample *s) {
    return fmax(s->cfl, par_max(substeps_fastest(r->solid)) * r->dt / r->solid->in.spacing);
}

/* Why so much goes in the slip. What finds no way loses all of its power so; a layer that is thinner than a cell, on a
 * body that moves through the cells, a part: 11 % at a cell Reynolds number of 13, 70 % at 120. */
static const char *why_slip(const struct run *r, double reynolds, double part) {
    static char why[256];
    const double thin = 5, all = 0.9;
    if (r->surface->isolated > 0)
        return "particles without a bond take their drag by slip; what is more than that is pressed through the solid, "
               "because it finds no other way";
    if (!(reynolds > thin && part < all)) return "fluid is pressed through the solid, because it finds no other way";
    snprintf(why, sizeof why,
             "its speed times a cell over nu is %.3g, so the layer at the walls is thinner than a cell, and slips; or "
             "fluid is pressed through the solid, because it finds no other way",
             reynolds);
    return why;
}

static double longest(const struct run *r) {
    const double *size = r->scene->domain.size;
    return fmax(size[0], fmax(size[1], size[2]));
}

/* Where fluid that a body displaces, or that is driven against one, finds no way, it goes through the body's walls.
 * Where there is a way, they take 0.1 to 3 % of the power. The drag of single particles is all slip. A flow that loses
 * next to nothing, as with a plug that floats along, loses that in the slip: it is little beside load times speed, or,
 * where all falls freely and no load acts, beside the flow's energy over the time in which it crosses the domain. A
 * flow that is pressed through a wall loses many times its energy in that time, and one around a body Cd A/L^2 of it.
 * The powers at one moment of an oscillating flow say nothing. */
static void report_slip(const struct run *r, const struct series_sample *s) {
    enum { START = 5 }; /* steps; in the first one a body that a stream meets at once slips by itself */
    const double most = 0.1, little = 0.01, kept = 5e-3, at_rest = 1e-6, lost = s->slip_loss + s->fluid.dissipation;
    if (!r->reaction || r->step < START || r->scene->fluid->driving_frequency > 0) return;
    const double way = way_in_step(r, s), load = hypot(hypot(s->load[0], s->load[1]), s->load[2]);
    const double cell = r->solid->in.spacing, speed = way * cell / r->dt;
    const double least = fmax(most * lost, little * load * speed);
    if (way < at_rest || !(s->slip_loss > least)) return;
    if (lost * longest(r) < kept * s->fluid.kinetic_energy * speed) return;
    log_line("warning: stage %s: at its end %.0f %% of the power that the flow dissipates, %.3g W, is lost by slip at "
             "the solid's "
             "walls: %s",
             run_stage(r)->name, 100 * s->slip_loss / lost, lost,
             why_slip(r, speed * cell / fluid_input_of(r->fluid)->viscosity, s->slip_loss / lost));
}

/* Of bodies that have come to a wall since the start. */
static void report_standing(const struct run *r) {
    char sentence[STANDING_SENTENCE];
    struct standing before[PHYSICS_BODIES_MAX], now[PHYSICS_BODIES_MAX];
    if (!r->needs.bonds) return;
    standing_measure(r, 1, before);
    standing_measure(r, 0, now);
    for (int b = 0; b < r->solid->in.bodies; b++)
        if (!standing_of(r, b, before, sentence) && standing_of(r, b, now, sentence))
            log_line("stage %s: %s", run_stage(r)->name, sentence);
}

void report_flow(const struct run *r, const struct series_sample *s) {
    const char *name = r->scene->stage[r->stage].name;
    report_standing(r);
    if (r->scene->output.series_every > 0) report_slip(r, s);
    if (!r->needs.immersed || r->measured.why[0] || r->scene->output.series_every == 0) return;
    if (s->medium.porosity_effective == 0)
        log_line("stage %s: no permeability: no way through the medium along %c that the cells resolve", name,
                 "xyz"[medium_axis(r->medium)]);
    else if (s->medium.reynolds > INERTIA)
        log_line(
            "stage %s: the Reynolds number with the root of the permeability is %.3g, above %g: inertia counts, and "
            "the permeability is an apparent one",
            name, s->medium.reynolds, INERTIA);
}

/* Particles that were in the domain at the start and now are beyond a side. */
static long beyond(const struct run *r, int c, int high) {
    const double *x0 = r->solid->x0[c], *d = r->solid->d[c], size = r->scene->domain.size[c];
    long n = 0;
    for (int h = 0; h < r->solid->n; h++)
        n += x0[h] >= 0 && x0[h] <= size && (high ? x0[h] + d[h] > size : x0[h] + d[h] < 0);
    return par_sum_long(n);
}

void report_leaving(const struct run *r) {
    if (!r->needs.immersed || !r->needs.bonds) return;
    for (int c = 0; c < 3; c++)
        for (int e = 0; e < 2; e++) {
            if (r->scene->fluid->side[c][e].type != FLUID_OUTFLOW) continue;
            const long n = beyond(r, c, e);
            if (n > 0)
                log_line("stage %s: %ld particles have left through the outflow %s: while a body five times as fast "
                         "as the stream crosses it, from half a diameter before it on, its momentum is up to 7 %% too "
                         "small; before and after that within 2 %%",
                         run_stage(r)->name, n, side_name[c][e]);
        }
}

void report_crack_fluid(const struct run *r) {
    const struct scene_stage *stage = &r->scene->stage[r->stage];
    if (!stage->crack_fluid || r->cracks->steps == 0) return;
    const double steps = (double)r->cracks->steps;
    log_line("stage %s: crack fluid: %.3g solves and %.3g iterations a substep, struts made %ld times", stage->name,
             (double)r->cracks->solves / steps, (double)r->cracks->iterations / steps, r->cracks->renewals);
    const double uneven = reaction_take_uneven(r);
    if (uneven > 0)
        log_line(
            "stage %s: crack fluid: deep in a body the fluid's pressure has been %.2g Pa from its mean, which is what "
            "the cracks take (root mean square, at most)",
            stage->name, uneven);
}
