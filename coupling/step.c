/* The time step: the pipeline of all parts, those of it that a stage needs, and the loop over them.  (001: sec. 4.3) */
#include "base/clock.h"
#include "base/die.h"
#include "base/par.h"
#include "base/step_status.h"
#include "coupling/control/duration.h"
#include "coupling/control/time_step.h"
#include "coupling/control/substeps.h"
#include "coupling/interface/marker_force.h"
#include "coupling/interface/forced_fluid.h"
#include "coupling/interface/interface.h"
#include "coupling/interface/crack_outlets.h"
#include "coupling/control/refinement.h"
#include "coupling/run.h"
#include "coupling/stage.h"
#include "coupling/step.h"
#include "cracks/project.h"
#include "base/files/log.h"
#include "solid/bonds/breaks.h"
#include "solid/contact/contact.h"
#include "solid/imposed/reactions.h"
#include "solid/refine/refine.h"
#include "solid/step/integrate.h"
#include "solid/step/quasi_static.h"
#include "solid/step/relax.h"

static void part_refine(struct run *r) {
    const long before = solid_refine_events(r->solid);
    refinement_check(r);
    if (solid_refine_events(r->solid) == before || r->scene->stage[r->stage].substeps > 0) return;
    const int wanted = substeps_wanted(r);
    if (wanted <= r->substeps) return;
    log_line("step %ld: %d solid substeps, stable up to %.4g s", r->step, wanted, r->solid_stable);
    r->substeps = wanted;
}

static void part_fluid(struct run *r) {
    fluid_state_of(r->fluid)->t = r->t;
    fluid_step(r->fluid, r->dt);
}

static void part_solid(struct run *r) {
    struct solid *s = r->solid;
    if (r->v_last[0])
        for (int c = 0; c < 3; c++)
            for (int h = 0; h < s->n; h++) r->v_last[c][h] = s->v[c][h];
    s->t = r->t;
    solid_reactions_begin(s);
    solid_integrate(s, r->dt / r->substeps, r->substeps);
    r->dt_last = r->dt;
    r->moved = r->step + 1;
}

/* The pressures are found within the solid's substeps (cracks/project.c). */
static void part_cracks(struct run *r) {
    cracks_project_end(r->cracks);
    if (r->crack_outlets) crack_outlets_end_step(r);
}

static void part_contact(struct run *r) { solid_contact_update(r->solid); }

static void part_surface(struct run *r) {
    marker_force_hold(r);
    solid_surface_update(r->solid, r->surface);
}

enum { RELAXATIONS_MAX = 200000 };

static void part_relax(struct run *r) {
    if (r->stage_step > 0) return;
    r->solid->t = r->t;
    const struct scene_stage *stage = &r->scene->stage[r->stage];
    const int steps = solid_relax(r->solid, stage->tolerance, RELAXATIONS_MAX);
    if (r->solid->stops) return;
    if (steps == SOLID_RELAX_AWAY)
        die_all(EXIT_CODE_UNSTABLE, "stage %s: no static equilibrium: a part that nothing holds moves away",
                stage->name);
    if (steps < 0)
        die_all(EXIT_CODE_UNSTABLE, "stage %s: no static equilibrium within %d relaxation steps", stage->name,
                (int)RELAXATIONS_MAX);
    r->moved = r->step + 1;
}

static void part_increment(struct run *r) {
    const struct scene_stage *stage = &r->scene->stage[r->stage];
    const double t = r->t + r->dt;
    struct solid_quasi_static found;
    r->solid->t = r->t;
    const int rests = solid_quasi_static_step(r->solid, t, stage->tolerance, RELAXATIONS_MAX, &found);
    if (r->solid->stops) return;
    if (!rests && found.moves_away)
        die_all(EXIT_CODE_UNSTABLE,
                "stage %s, increment %ld to t = %g s: no static equilibrium: after %ld bonds broke in %d rounds a part "
                "that nothing holds moves away: the solid cannot bear the load any more",
                stage->name, r->stage_step + 1, t, found.broken, found.rounds);
    if (!rests)
        die_all(EXIT_CODE_UNSTABLE,
                "stage %s, increment %ld to t = %g s: no static equilibrium within %d relaxation steps after %ld bonds "
                "broke in %d rounds: the solid cannot bear the load any more, or the tolerance of %g is too small",
                stage->name, r->stage_step + 1, t, (int)RELAXATIONS_MAX, found.broken, found.rounds, stage->tolerance);
    if (found.broken > 0)
        log_line("stage %s, increment %ld to t = %g s: %ld bonds broken in %d rounds, %ld relaxation steps, which took "
                 "%.3g J",
                 stage->name, r->stage_step + 1, t, found.broken, found.rounds, found.relaxations, found.dissipated);
    else if (found.dissipated > 0)
        log_line(
            "warning: stage %s, increment %ld to t = %g s: the solid snapped into another equilibrium, and gave off "
            "%.3g J, though no bond broke: what came before was unstable, as a column beyond its buckling load. It "
            "would have snapped earlier with a smaller tolerance (stages[].tolerance, now %g)",
            stage->name, r->stage_step + 1, t, found.dissipated, stage->tolerance);
    r->moved = r->step + 1;
}

/* The pipeline: the parts of a step in their order. A stage has a part if it has all needs of `with` and none of
 * `without`. (001: sec. 4.3) */
static const struct step_part pipeline[] = {
    {"relaxation", CLOCK_SOLID, STAGE_RELAXATION, 0, part_relax}, /* Underwood 1983; Kilic and Madenci 2010 */
    {"loads raised, relaxation and breakage in turn", CLOCK_SOLID, STAGE_INCREMENTS, 0, part_increment},
    {"time step from the fluid's limits", CLOCK_JUDGING, STAGE_AUTOMATIC_STEP, 0,
     time_step_choose}, /* Wesseling 2001 */
    {"end of the duration", CLOCK_JUDGING, STAGE_DURATION, 0, duration_shorten_step},
    {"markers", CLOCK_INTERFACE, STAGE_IMMERSED | STAGE_ELASTIC, 0,
     interface_begin_step}, /* 001: sec. 3.5.2, X^n and V^n */
    {"volume given to cracks", CLOCK_CRACKS, STAGE_CRACK_FLUID | STAGE_IMMERSED, 0,
     crack_outlets_set_sources},                                        /* docs/design/cracks.md */
    {"fluid", CLOCK_MOMENTUM, STAGE_FLUID, STAGE_IMMERSED, part_fluid}, /* 001: eqs 3.70-3.74 */
    {"fluid with forcing", CLOCK_FORCING, STAGE_IMMERSED, STAGE_IMPLICIT | STAGE_REACTION,
     forced_fluid_step}, /* 001: eqs 3.70-3.82 */
    {"fluid with forcing, implicit diffusion", CLOCK_FORCING, STAGE_IMMERSED | STAGE_IMPLICIT, STAGE_REACTION,
     forced_fluid_step_implicit},
    {"probe", CLOCK_PROBE, STAGE_IMMERSED | STAGE_ELASTIC, STAGE_REACTION, load_sample}, /* 001: eqs 3.83-3.96 */
    {"mouths of cracks", CLOCK_CRACKS, STAGE_CRACK_FLUID | STAGE_IMMERSED, 0,
     crack_outlets_set_pressures},                                 /* docs/design/cracks.md */
    {"refinement", CLOCK_SOLID, STAGE_REFINEMENT, 0, part_refine}, /* 000: ch. 2 */
    {"contact", CLOCK_CONTACT, STAGE_CONTACT, 0, part_contact},    /* lists of pairs for 001: eq. 3.40 */
    {"number of substeps", CLOCK_JUDGING, STAGE_AUTOMATIC_SUBSTEPS, 0, substeps_choose}, /* the solid's stable step */
    {"damping", CLOCK_SOLID, STAGE_SETTLING, 0, settle_damp},                            /* Underwood 1983 */
    {"solid", CLOCK_SOLID, STAGE_ELASTIC, STAGE_REACTION, part_solid},                   /* 001: eqs 3.38, 3.47, 3.48 */
    {"work of the loads", CLOCK_PROBE, STAGE_IMMERSED | STAGE_ELASTIC, STAGE_REACTION, load_set_work},
    {"fluid, forcing and solid, stage by stage", CLOCK_COUPLING, STAGE_REACTION, 0,
     load_step}, /* Tschisgale et al. 2017 */
    {"cracks", CLOCK_CRACKS, STAGE_CRACK_FLUID, 0,
     part_cracks}, /* bonds that broke become struts; docs/design/cracks.md */
    {"surface", CLOCK_INTERFACE, STAGE_IMMERSED | STAGE_ELASTIC, 0, part_surface}, /* 001: secs 3.3.7, 3.3.9 */
};

_Static_assert(sizeof pipeline / sizeof *pipeline <= RUN_PARTS_MAX, "any step's parts have room");

int step_parts_of(unsigned needs, const struct step_part *part[RUN_PARTS_MAX]) {
    int n = 0;
    for (size_t k = 0; k < sizeof pipeline / sizeof *pipeline; k++) {
        if ((needs & pipeline[k].with) != pipeline[k].with || needs & pipeline[k].without) continue;
        part[n++] = &pipeline[k];
    }
    return n;
}

void step_begin_stage(struct run *r) {
    const struct step_part *part[RUN_PARTS_MAX];
    const unsigned needs = stage_begin(r);
    r->parts = step_parts_of(needs, part);
    for (int k = 0; k < r->parts; k++) {
        r->part[k] = part[k]->run;
        r->part_name[k] = part[k]->name;
        r->part_clock[k] = part[k]->clock;
    }
    if (needs & STAGE_IMMERSED && !(needs & STAGE_ELASTIC)) interface_begin_step(r); /* a solid at rest: once a stage */
}

int step_advance(struct run *r) {
    for (int k = 0; k < r->parts; k++) {
        clock_begin(r->part_clock[k]);
        r->part[k](r);
        clock_end(r->part_clock[k]);
        if (r->solid && r->solid->stops) return 0;
    }
    r->t += r->dt;
    r->step++;
    r->stage_step++;
    if (r->solid && solid_breaks_is_due(r->solid->breaks)) solid_breaks_stamp(r->solid->breaks, r->step, r->t);
    r->fluid_cell_steps += r->fluid ? (long)fluid_cells(r->fluid) : 0;
    r->solid_sweeps += r->solid ? solid_integrate_sweeps(r->solid, r->substeps) : 0;
    return 1;
}

/* 1: a value in one plane of p is NaN or infinite. */
static int pressure_lost(const struct run *r) {
    const struct fluid_grid *g = fluid_grid_of(r->fluid);
    const double *plane = fluid_state_of(r->fluid)->p + fluid_grid_at(g, 0, 0, (int)(r->step % g->m[2]));
    double sum = 0;
    for (int j = 0; j < g->m[1]; j++)
        for (int i = 0; i < g->m[0]; i++) sum += 0 * plane[j * g->row + i];
    return !(sum == 0); /* 0 times infinity, or NaN */
}

int step_check(const struct run *r, int all_fields, struct step_status *status) {
    *status = (struct step_status){0};
    if (r->fluid && (all_fields || pressure_lost(r))) *status = fluid_limits_check(r->fluid);
    const int may_differ = r->solid && (all_fields || r->moved == r->step); /* the state of a solid at rest does not
                                                                             * change */
    if (may_differ && !status->failed) *status = solid_integrate_check(r->solid);
    if (r->cracks && r->cracks->status.failed && !status->failed) *status = r->cracks->status;
    if (status->failed) status->rank = par_rank();
    return status->failed;
}
