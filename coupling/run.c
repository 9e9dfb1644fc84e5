/* Creates and frees a run: the fluid, solid, interface and medium that the scene needs. */
#include "coupling/run.h"
#include "base/clock.h"
#include "base/die.h"
#include "base/memory.h"
#include "base/par.h"
#include "coupling/interface/deposit.h"
#include "coupling/interface/crack_outlets.h"
#include "coupling/interface/slip.h"
#include "coupling/setup/crack_fluid.h"
#include "coupling/setup/forecast.h"
#include "coupling/setup/image_cut.h"
#include "coupling/setup/imposed.h"
#include "coupling/setup/share.h"
#include "solid/bonds/breaks.h"
#include "solid/bonds/family.h"
#include "solid/solid.h"
#include "solid/step/strained.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The box in which porosity and permeability are measured: given, or the particles' bounds within the domain. */
static struct medium *medium_of(struct run *r) {
    const struct scene *scene = r->scene;
    double low[3], high[3];
    for (int c = 0; c < 3; c++) {
        low[c] = INFINITY, high[c] = -INFINITY;
        for (int h = 0; h < r->solid->n; h++) {
            low[c] = fmin(low[c], r->solid->x0[c][h] - 0.5 * r->solid->in.spacing);
            high[c] = fmax(high[c], r->solid->x0[c][h] + 0.5 * r->solid->in.spacing);
        }
    }
    par_min_array(low, 3);
    par_max_array(high, 3);
    for (int c = 0; c < 3; c++) {
        low[c] = scene->coupling->has_box ? scene->coupling->box_low[c] : fmax(low[c], 0);
        high[c] = scene->coupling->has_box ? scene->coupling->box_high[c] : fmin(high[c], scene->domain.size[c]);
    }
    struct medium *m = medium_new(fluid_grid_of(r->fluid), low, high);
    medium_reach(m, IBM_KERNEL_REACH - scene->coupling->retraction);
    scene_medium_of(scene, &r->measured);
    medium_along(m, r->measured.along);
    return m;
}

/* Looks at what the scene alone does not tell: the box of bodies of points, and the pores. A scene that asks for a
 * permeability which cannot be measured is refused. */
static void check_medium(struct run *r) {
    struct scene_medium *m = &r->measured;
    const int axes = (m->along[0] != 0) + (m->along[1] != 0) + (m->along[2] != 0);
    deposit_update(r);
    if (!m->why[0] && medium_measure_porosity(r->medium) == 1)
        snprintf(m->why, sizeof m->why, "the medium's box holds no solid");
    for (int c = 0; c < 3 && axes > 1 && !m->why[0]; c++)
        if (m->along[c] != 0 && !medium_is_whole_period(r->medium, c))
            snprintf(m->why, sizeof m->why,
                     "the fluid is driven along (%g, %g, %g): the medium's box must be the whole period along %c",
                     m->along[0], m->along[1], m->along[2], "xyz"[c]);
    if (!scene_medium_is_wanted(r->scene)) return;
    if (!m->why[0] && !(medium_measure_porosity(r->medium) > 0))
        snprintf(m->why, sizeof m->why, "the medium's box holds no fluid");
    if (!m->why[0] && medium_connect_porosity(r->medium) == 0)
        snprintf(m->why, sizeof m->why, "no way through the medium along %c that the cells resolve",
                 "xyz"[medium_axis(r->medium)]);
    if (m->why[0]) die_all(EXIT_CODE_SCENE, "coupling.medium: %s", m->why);
}

/* The fluid inside a solid at rest that is connected from the front of the medium's box to its back is not driven. Then
 * its pressure is close to that of the pores beside it, and the walls have to hold little. Of an endless one only the
 * pores' flow counts: what is inside moves with the walls' slip. */
static void leave_inside(struct run *r) {
    const struct fluid_input *in = fluid_input_of(r->fluid);
    const double *part[3] = {NULL}, *spread = NULL;
    for (int c = 0; c < 3; c++) {
        const int driven = in->driving.type != FLUID_DRIVING_NONE && fluid_driving_along(in, c) != 0;
        if (!fluid_grid_of(r->fluid)->periodic[c] || (!driven && in->body_force[c] == 0)) continue;
        deposit_update(r);
        const enum medium_span span = medium_spans(r->medium, c);
        if (span == MEDIUM_SPAN_ENDLESS && r->needs.bonds && c == medium_axis(r->medium) && !r->measured.why[0])
            snprintf(r->measured.why, sizeof r->measured.why,
                     "the solid is connected through the periodic sides along %c, and not rigid in every stage: the "
                     "fluid inside it is driven too; put a layer of fluid before or behind it",
                     "xyz"[c]);
        if (r->needs.bonds || span == MEDIUM_SPAN_NONE) continue;
        if (span == MEDIUM_SPAN_ENDLESS && !spread) spread = deposit_spread(r);
        part[c] = span == MEDIUM_SPAN_ENDLESS ? spread : medium_fraction(r->medium);
        if (span == MEDIUM_SPAN_ENDLESS) medium_pores_only(r->medium);
    }
    ibm_inside_undriven(r->ibm, part);
}

/* While the images' voxels are there. Of several samples the last one that is cut counts. */
static void find_cut(struct run *r, const struct solid_input *in) {
    for (int c = 0; c < 3; c++) r->cut_share[c] = NAN;
    for (int k = 0; k < 3 * in->bodies; k++) {
        const struct solid_voxels *v = in->body[k / 3].voxels;
        const double share = v ? image_cut_share(r->scene, v, NULL, k % 3) : NAN;
        if (!isnan(share)) r->cut_share[k % 3] = share;
    }
}

/* A stage without bonds needs a given step and number of substeps: only bonds would limit them. */
static void check_steps(const struct run *r) {
    for (int k = 0; !r->fluid && r->solid->bonds_total == 0 && k < r->scene->stages; k++) {
        const struct scene_stage *stage = &r->scene->stage[k];
        if (stage->time_step <= 0 && stage->damping_absolute <= 0 && !stage->relax)
            die_all(EXIT_CODE_SCENE, "stage %s: time_step: needs a value, because no bond limits it", stage->name);
    }
}

struct run *run_new(const struct scene *scene) {
    struct run *r = calloc(1, sizeof *r);
    r->wall_start = par_seconds();
    clock_phase(CLOCK_PHASE_FLUID);
    forecast_check(scene);
    r->scene = scene;
    r->needs = setup_needs_of(scene);
    r->deposited = -1;
    if (r->needs.immersed && !setup_check_are_cubes(scene))
        die_all(EXIT_CODE_SCENE,
                "domain.cells: a solid in a flow that is stepped needs cells of the same size in all directions; frana "
                "permeability solves the creeping flow through a solid at rest on others");
    if (r->needs.fluid) {
        struct fluid_input in;
        setup_fluid(scene, &in);
        r->fluid = fluid_new(&in);
    }
    clock_phase(CLOCK_PHASE_SOLID);
    if (r->needs.solid) {
        struct solid_input *in = setup_solid(scene);
        imposed_add(scene, in);
        find_cut(r, in);
        if (r->fluid) in->speed = fluid_limits_speed(r->fluid);
        r->solid = solid_new(in);
        if (r->needs.breakage && scene->output.events) solid_breaks_begin(r->solid); /* before a state is kept */
        imposed_free(in);
        setup_solid_free(in);
        check_steps(r);
        r->cracks = setup_crack_fluid(scene, r->solid);
    }
    r->beginning = beginning_of(scene, r->solid);
    clock_phase(CLOCK_PHASE_SURFACE);
    if (r->needs.immersed) {
        r->surface = solid_surface_new(r->solid);
        solid_surface_area_restrict(r->solid, r->surface, (double[]){0, 0, 0}, scene->domain.size);
        if (!r->needs.bonds) {
            solid_free_bonds(r->solid);
            solid_surface_freeze(r->surface);
        }
        r->fluid = share_divide(scene, r->fluid, r->solid, r->surface);
        clock_phase(CLOCK_PHASE_FORCING);
        r->load_kind = load_kind_of(scene->coupling->load);
        r->ibm = ibm_new(r->fluid, scene->coupling->forcing_iterations);
        r->medium = medium_of(r);
        for (int c = 0; c < 3 && r->needs.bonds; c++)
            r->position[c] = memory_new(MEMORY_COUPLING, (size_t)r->solid->n + 1, sizeof(double));
        check_medium(r);
        deposit_update(r);
        leave_inside(r);
        if (!r->needs.bonds) medium_freeze(r->medium);
        if (fluid_input_of(r->fluid)->implicit) ibm_implicit_set(r->ibm, slip_time_of_implicit(r));
        if (r->load_kind->begin) r->load_kind->begin(r);
        r->crack_outlets = crack_outlets_new(r);
    }
    return r;
}

long run_directed_bonds(const struct run *r) {
    return r->needs.bonds ? par_sum_long(solid_family_directed(r->solid)) : 0;
}

void run_free(struct run *r) {
    if (!r) return;
    if (r->load_kind && r->load_kind->end) r->load_kind->end(r);
    markers_free(&r->markers);
    wall_probes_free(&r->probes);
    crack_outlets_free(r->crack_outlets);
    for (int c = 0; c < 3; c++) memory_free(r->position[c]);
    memory_free(r->marker_force);
    medium_free(r->medium);
    ibm_free(r->ibm);
    solid_surface_free(r->surface);
    cracks_free(r->cracks);
    solid_strained_free(r->stretched);
    solid_free(r->solid);
    fluid_free(r->fluid);
    free(r);
}
