/* The time step: the list of parts that a stage needs, and the loop over it.  (001: sec. 4.3) */
#include "base/die.h"
#include "base/ensure.h"
#include "base/memory.h"
#include "base/par.h"
#include "base/step_status.h"
#include "coupling/balance.h"
#include "coupling/forcing_guess.h"
#include "coupling/interface.h"
#include "coupling/refinement.h"
#include "coupling/run.h"
#include "coupling/step.h"
#include "files/log.h"
#include "solid/contact/contact.h"
#include "solid/refine/refine.h"
#include "solid/step/integrate.h"
#include "solid/step/rates.h"
#include "solid/step/relax.h"
#include "solid/step/stable.h"

#include <math.h>

static void part_refine(struct run *r) {
    const long before = solid_refine_events(r->solid);
    refinement_look(r);
    if (solid_refine_events(r->solid) == before || r->scene->stage[r->stage].substeps > 0) return;
    const int wanted = adapt_substeps_wanted(r);
    if (wanted <= r->substeps) return;
    log_line("step %ld: %d solid substeps, stable up to %.4g s", r->step, wanted, r->solid_stable);
    r->substeps = wanted;
}

static void part_fluid(struct run *r) {
    fluid_state_of(r->fluid)->t = r->t;
    fluid_step(r->fluid, r->dt);
}

static void part_markers(struct run *r) {
    interface_markers_update(r);
    ibm_markers_set(r->ibm, r->markers.n, (const double *const *)r->markers.x, (const double *const *)r->markers.v,
                    r->markers.volume);
    forcing_guess_hand_on(r);
}

/* A step of the fluid with the solid immersed, at X^n, V^n.  (001: eqs 3.65-3.69, 3.80-3.82) */
static void part_fluid_forced(struct run *r) {
    fluid_state_of(r->fluid)->t = r->t;
    for (int s = 0; s < 3; s++) {
        fluid_predict(r->fluid, s, r->dt);
        ibm_forcing_stage(r->ibm, s, r->dt);
        fluid_project(r->fluid, s, r->dt);
    }
}

/* The same with implicit diffusion: the force of the last stage diffuses with the velocity, then the rest of the force
 * is added. */
static void part_fluid_implicit(struct run *r) {
    fluid_state_of(r->fluid)->t = r->t;
    for (int s = 0; s < 3; s++) {
        fluid_predict(r->fluid, s, r->dt);
        ibm_implicit_force_again(r->ibm, s, r->dt);
        fluid_diffusion_stage(r->fluid, s, r->dt);
        ibm_implicit_force(r->ibm, s, r->dt);
        fluid_project(r->fluid, s, r->dt);
    }
}

static void part_solid(struct run *r) {
    struct solid *s = r->solid;
    if (r->v_last[0])
        for (int c = 0; c < 3; c++)
            for (int h = 0; h < s->n; h++) r->v_last[c][h] = s->v[c][h];
    s->t = r->t;
    solid_integrate(s, r->dt / r->substeps, r->substeps);
    balance_keep(r);
    r->moved = r->step + 1;
}

static void part_contact(struct run *r) { solid_contact_update(r->solid); }

static void part_surface(struct run *r) { solid_surface_update(r->solid, r->surface); }

static void part_relax(struct run *r) {
    if (r->stage_step > 0) return;
    r->solid->t = r->t;
    if (solid_relax(r->solid, 1e-6, 200000) < 0)
        die_all(EXIT_CODE_UNSTABLE, "stage %s: no static equilibrium within 200000 relaxation steps",
                r->scene->stage[r->stage].name);
    r->moved = r->step + 1;
}

static void add(struct run *r, run_part *part, const char *name) {
    ENSURE(r->parts < RUN_PARTS_MAX, "a step of more than %d parts", RUN_PARTS_MAX);
    r->part_name[r->parts] = name;
    r->part[r->parts++] = part;
}

static void stable_step(struct run *r) {
    if (r->scene->solid->refinement)
        refinement_rates(r);
    else
        solid_rates_of(r->solid, &r->solid_rates);
    r->solid_stable = solid_stable_of(&r->solid_rates, r->solid->stage.integrator, 0, &r->solid_bound);
}

void step_begin_stage(struct run *r) {
    const struct scene_stage *stage = &r->scene->stage[r->stage];
    const int elastic = r->solid && stage->solid == SCENE_SOLID_ELASTIC;
    const double dt = r->stage_step > 0 && r->solid && r->solid->refine ? r->dt : 0; /* that before a refinement */
    r->parts = 0;
    adapt_begin(r);
    if (stage->time_step > 0 || !r->fluid || r->stage_step == 0) r->dt = stage->time_step;
    if (!elastic || r->stage_step == 0) r->substeps = 0;
    if (r->stage_step == 0) r->refined.level = -1;
    if (elastic) {
        setup_stage(stage, &r->solid->stage);
        if (!stage->relax) stable_step(r);
        if (r->stage_step > 0) solid_verlet_resume(r->solid);
        if (!r->fluid && r->dt <= 0 && !isfinite(r->solid_stable))
            die_all(EXIT_CODE_SCENE, "stage %s: time_step: needs a value, because no bond limits it", stage->name);
        if (!r->fluid && r->dt <= 0) r->dt = dt > 0 ? dt : stage->safety * r->solid_stable;
    }
    if (stage->relax) {
        add(r, part_relax, "relaxation");
        return;
    }
    if (r->fluid && stage->time_step <= 0) add(r, adapt_time_step, "time step from the fluid's limits");
    const int touches = elastic && r->needs.contact && solid_contact_is_possible(r->solid);
    const int follows = stage->substeps == 0 && (touches || (r->fluid && stage->time_step <= 0));
    if (elastic && stage->substeps > 0)
        r->substeps = stage->substeps;
    else if (elastic && r->dt > 0 && (r->substeps == 0 || !follows))
        r->substeps = adapt_substeps_wanted(r);
    if (elastic && r->strong) {
        if (touches) add(r, part_contact, "contact");
        if (follows) add(r, adapt_substeps, "number of substeps");
        strong_parts(r->strong, part_markers, part_fluid_forced); /* never with implicit diffusion: the scene's checks
                                                                   * refuse it */
        add(r, strong_step, "fluid, probe and solid, iterated");
        add(r, part_surface, "surface");
        return;
    }
    if (r->ibm && elastic)
        add(r, part_markers, "markers");
    else if (r->ibm)
        part_markers(r); /* a solid at rest: once a stage */
    if (r->fluid && r->ibm && fluid_input_of(r->fluid)->implicit)
        add(r, part_fluid_implicit, "fluid with forcing, implicit diffusion");
    else if (r->fluid)
        add(r, r->ibm ? part_fluid_forced : part_fluid, r->ibm ? "fluid with forcing" : "fluid");
    if (!elastic) return;
    if (r->ibm) add(r, interface_probe, "probe");
    if (r->solid->refine) add(r, part_refine, "refinement");
    if (touches) add(r, part_contact, "contact");
    if (follows) add(r, adapt_substeps, "number of substeps");
    add(r, part_solid, "solid");
    if (r->surface) add(r, part_surface, "surface");
}

void step_advance(struct run *r) {
    for (int k = 0; k < r->parts; k++) r->part[k](r);
    r->t += r->dt;
    r->step++;
    r->stage_step++;
    r->fluid_cell_steps += r->fluid ? (long)fluid_cells(r->fluid) : 0;
    r->solid_sweeps += (long)r->substeps * (r->solid && r->solid->stage.integrator == SOLID_VERLET ? 1 : 3);
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

int step_check(const struct run *r, int whole, struct step_status *status) {
    *status = (struct step_status){0};
    if (r->fluid && (whole || pressure_lost(r))) *status = fluid_limits_check(r->fluid);
    const int may_differ = r->solid && (whole || r->moved == r->step); /* the state of a solid at rest does not
                                                                        * change */
    if (may_differ && !status->failed) *status = solid_integrate_check(r->solid);
    if (status->failed) status->rank = par_rank();
    return status->failed;
}
