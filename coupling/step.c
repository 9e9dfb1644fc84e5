/* The time step, put together from the parts that the stage needs.  (001: sec. 4.3; SPEC 5) */
#include "base/par.h"
#include "coupling/run.h"
#include "solid/contact.h"

#include <math.h>

static void part_time_step(struct run *r) {
    const struct scene_stage *stage = &r->scene->stage[r->stage];
    r->dt = stage->cfl * fluid_stable_step(r->fluid).step;
}

static void part_substeps(struct run *r) {
    const struct scene_stage *stage = &r->scene->stage[r->stage];
    const double least = ceil(r->dt / (stage->safety * r->solid_stable) * (1 - 1e-12));
    r->substeps = least > 1 ? (int)least : 1; /* without bonds there is no limit */
}

static void part_fluid(struct run *r) { fluid_step(r->fluid, r->dt); }

static void part_markers(struct run *r) {
    run_markers_update(r);
    ibm_markers(r->ibm, r->markers.n, (const double *const *)r->markers.x,
                (const double *const *)r->markers.v, r->markers.volume);
}

/* Fluid with the solid immersed, at X^n, V^n.  (001: eqs 3.65-3.69, 3.80-3.82) */
static void part_fluid_forced(struct run *r) {
    for (int s = 0; s < 3; s++) {
        fluid_predict(r->fluid, s, r->dt);
        ibm_force(r->ibm, s, r->dt);
        fluid_project(r->fluid, s, r->dt);
    }
}

static void part_solid(struct run *r) {
    struct solid *s = r->solid;
    if (r->v_last[0])
        for (int c = 0; c < 3; c++)
            for (int h = 0; h < s->n; h++) r->v_last[c][h] = s->v[c][h];
    solid_advance(s, r->dt / r->substeps, r->substeps);
}

static void part_contact(struct run *r) { solid_contact_update(r->solid); }

static void part_surface(struct run *r) { solid_surface_update(r->solid, r->surface); }

static void part_relax(struct run *r) {
    if (r->stage_step > 0) return;
    if (solid_relax(r->solid, 1e-6, 200000) < 0)
        die_all(EXIT_CODE_UNSTABLE, "stage %s: no static equilibrium within 200000 relaxation steps",
                r->scene->stage[r->stage].name);
}

static void add(struct run *r, run_part *part, const char *name) {
    ENSURE(r->parts < RUN_PARTS_MAX, "a step of more than %d parts", RUN_PARTS_MAX);
    r->part_name[r->parts] = name;
    r->part[r->parts++] = part;
}

void run_stage_begin(struct run *r) {
    const struct scene_stage *stage = &r->scene->stage[r->stage];
    const int elastic = r->solid && stage->solid == SCENE_SOLID_ELASTIC;
    r->parts = 0;
    r->dt = stage->time_step;
    r->substeps = 0;
    if (elastic) {
        setup_stage(stage, &r->solid->stage);
        if (!stage->relax) r->solid_stable = solid_stable_step(r->solid, r->solid->stage.integrator);
        if (r->stage_step > 0) solid_verlet_resume(r->solid);
        if (!r->fluid && r->dt <= 0 && !isfinite(r->solid_stable))
            die_all(EXIT_CODE_SCENE, "stage %s: time_step: needs a value, because no bond limits it",
                    stage->name);
        if (!r->fluid && r->dt <= 0) r->dt = stage->safety * r->solid_stable;
    }
    if (stage->relax) {
        add(r, part_relax, "relaxation");
        return;
    }
    if (r->fluid && stage->time_step <= 0) add(r, part_time_step, "time step from the fluid's limits");
    if (elastic) {
        r->substeps = stage->substeps;
        if (r->substeps == 0 && r->dt > 0)
            part_substeps(r);
        else if (r->substeps == 0)
            add(r, part_substeps, "number of substeps");
    }
    if (r->ibm && elastic)
        add(r, part_markers, "markers");
    else if (r->ibm)
        part_markers(r); /* at rest: once a stage */
    if (r->fluid) add(r, r->ibm ? part_fluid_forced : part_fluid, r->ibm ? "fluid with forcing" : "fluid");
    if (!elastic) return;
    if (r->ibm) add(r, run_probe, "probe");
    if (r->solid->in.contact && r->needs.breakage) add(r, part_contact, "contact");
    add(r, part_solid, "solid");
    if (r->surface) add(r, part_surface, "surface");
}

void run_step(struct run *r) {
    for (int k = 0; k < r->parts; k++) r->part[k](r);
    r->t += r->dt;
    r->step++;
    r->stage_step++;
    r->fluid_cell_steps += r->fluid ? (long)fluid_cells(r->fluid) : 0;
    r->solid_sweeps += (long)r->substeps * (r->solid && r->solid->stage.integrator == SOLID_VERLET ? 1 : 3);
}

int run_check(struct run *r, struct step_status *status) {
    *status = (struct step_status){0};
    if (r->fluid) *status = fluid_check(r->fluid);
    if (r->solid && !status->failed) *status = solid_check(r->solid);
    if (status->failed) status->rank = par_rank();
    return step_status_agree(status);
}
