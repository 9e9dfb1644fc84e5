/* Translates the scene into the inputs of fluid and solid. */
#include "coupling/setup/setup.h"
#include "base/ensure.h"
#include "coupling/setup/parts.h"
#include "fluid/scheme.h"
#include "physics/dilatation.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void copy3(double to[3], const double from[3]) { memcpy(to, from, 3 * sizeof(double)); }

static void setup_side(const struct scene_side *from, struct fluid_side *to) {
    const enum fluid_condition condition[4] = {from->u, from->v, from->w, from->p};
    to->type = from->type;
    copy3(to->velocity, from->velocity);
    to->profile = from->profile;
    to->bulk_velocity = from->bulk_velocity;
    snprintf(to->file, sizeof to->file, "%s", from->file);
    to->pressure = from->pressure;
    for (int q = 0; q < 4; q++) to->condition[q] = condition[q];
}

/* The fastest sqrt(E/rho) of an elastic solid, m/s. */
static double wave_speed(const struct scene *scene) {
    double most = 0;
    for (int m = 0; setup_needs_of(scene).bonds && m < scene->solid->materials; m++)
        most = fmax(most, sqrt(scene->solid->material[m].youngs_modulus / scene->solid->material[m].density));
    return most;
}

/* Whether some stage takes the fluid's steps by a scheme that reads the step before. */
static int is_multistep(const struct scene *scene) {
    for (int k = 0; k < scene->stages; k++)
        if (fluid_scheme_is_multistep(scene->stage[k].fluid_integrator)) return 1;
    return 0;
}

void setup_fluid(const struct scene *scene, struct fluid_input *in) {
    const struct scene_fluid *f = scene->fluid;
    *in = (struct fluid_input){.density = f->density,
                               .viscosity = f->viscosity,
                               .driving = {f->driving, f->driving_direction, f->driving_value},
                               .driving_frequency = f->driving_frequency,
                               .initial_poiseuille = f->initial_poiseuille,
                               .immersed = scene->solid != NULL,
                               .mean_pressure = scene->coupling && scene->coupling->load == SCENE_LOAD_REACTION,
                               .speed = wave_speed(scene),
                               .implicit = f->diffusion == SCENE_DIFFUSION_IMPLICIT,
                               .projection = f->projection,
                               .keeps_rate = is_multistep(scene)};
    memcpy(in->n, scene->domain.cells, sizeof in->n);
    copy3(in->length, scene->domain.size);
    const double *along = f->driving_along,
                 length = sqrt(along[0] * along[0] + along[1] * along[1] + along[2] * along[2]);
    for (int d = 0; d < 3 && length > 0; d++) in->driving_along[d] = along[d] / length;
    copy3(in->body_force, f->body_force);
    copy3(in->initial_velocity, f->initial_velocity);
    if (f->has_taylor_green) {
        in->vortices.velocity = f->taylor_green_velocity;
        for (int d = 0; d < 3; d++) in->vortices.along[d] = scene_axes_has(f->taylor_green_axes, d);
    }
    for (int c = 0; c < 3; c++)
        for (int e = 0; e < 2; e++) setup_side(&f->side[c][e], &in->side[c][e]);
}

/* Whether the side of the fluid's domain stops particles. */
static int is_wall(const struct scene *scene, int c, int high) {
    if (!scene->fluid || !scene->solid->contact) return 0;
    const enum fluid_side_type type = scene->fluid->side[c][high].type;
    return type == FLUID_WALL || type == FLUID_SLIP;
}

static void setup_constraint(const struct scene_constraint *from, struct solid_constraint *to) {
    copy3(to->low, from->low);
    copy3(to->high, from->high);
    to->turn = setup_body_turn(&from->turn);
    memcpy(to->direction, from->direction, sizeof to->direction);
    copy3(to->velocity, from->velocity);
}

static void setup_material(enum physics_model model, const struct scene_material *from, struct solid_material *to) {
    *to = (struct solid_material){.youngs_modulus = from->youngs_modulus,
                                  .density = from->density,
                                  .fracture_energy = from->fracture_energy,
                                  .horizon_ratio = from->horizon_ratio,
                                  .tensile_strength = from->breakage == SCENE_BILINEAR ? from->tensile_strength : 0,
                                  .micromodulus = from->micromodulus,
                                  .ratio_excess = physics_dilatation_ratio_excess(model, from->poisson_ratio)};
}

/* The fracture energy of a constant limit s00: s0^2 is proportional to G0. */
static double energy_of_limit(const struct scene_solid *s, const struct scene_material *k) {
    const double s0 =
        physics_bond_of(s->model, k->micromodulus, s->thickness, k->youngs_modulus, 1, k->horizon_ratio * s->spacing)
            .s0;
    return (k->s00 / s0) * (k->s00 / s0);
}

/* n elements and one more, so that n = 0 also gives an array. */
static void *array_of(int n, size_t size) {
    void *array = calloc((size_t)n + 1, size);
    ENSURE(array, "no memory for the solid's input");
    return array;
}

/* malloc'ed; NULL: no material has a limit that follows the other bonds. */
static struct solid_limit *limits_of(const struct scene_solid *s) {
    struct solid_limit *limit = NULL;
    for (int m = 0; m < s->materials; m++) {
        const struct scene_material *k = &s->material[m];
        if (!(k->s00 > 0)) continue;
        if (!limit) limit = array_of(s->materials, sizeof *limit);
        limit[m] = (struct solid_limit){k->s00, k->alpha, energy_of_limit(s, k)};
    }
    return limit;
}

/* malloc'ed; NULL: none. */
static struct solid_indenter *indenters_of(const struct scene_solid *s) {
    struct solid_indenter *to = s->indenters > 0 ? array_of(s->indenters, sizeof *to) : NULL;
    for (int k = 0; k < s->indenters; k++) {
        const struct scene_indenter *from = &s->indenter[k];
        switch (from->shape) {
        case SCENE_INDENTER_SPHERE:
            to[k] = (struct solid_indenter){.radius = from->radius, .stiffness = from->stiffness};
        }
        copy3(to[k].centre, from->centre);
        copy3(to[k].velocity, from->velocity);
    }
    return to;
}

struct solid_input *setup_solid(const struct scene *scene) {
    const struct scene_solid *s = scene->solid;
    const struct setup_needs needs = setup_needs_of(scene);
    setup_check(scene);
    struct solid_input *in = array_of(1, sizeof *in);
    struct solid_body *body = array_of(s->bodies, sizeof *body);
    struct solid_material *material = array_of(s->materials, sizeof *material);
    struct solid_cut *cut = array_of(s->cracks, sizeof *cut);
    struct solid_constraint *constraint = array_of(s->constraints, sizeof *constraint);
    struct solid_interface *interface = array_of(s->interfaces, sizeof *interface);
    struct solid_region *unbreakable = array_of(s->unbreakables, sizeof *unbreakable);
    for (int b = 0; b < s->bodies; b++) setup_body(scene, b, &body[b]);
    for (int m = 0; m < s->materials; m++) setup_material((enum physics_model)s->model, &s->material[m], &material[m]);
    for (int k = 0; k < s->cracks; k++) setup_body_cut(&s->crack[k], &cut[k]);
    for (int k = 0; k < s->constraints; k++) setup_constraint(&s->constraint[k], &constraint[k]);
    for (int k = 0; k < s->interfaces; k++)
        interface[k] = (struct solid_interface){{s->interface[k].body[0], s->interface[k].body[1]},
                                                s->interface[k].fracture_energy};
    for (int k = 0; k < s->unbreakables; k++) {
        copy3(unbreakable[k].low, s->unbreakable[k].low);
        copy3(unbreakable[k].high, s->unbreakable[k].high);
        unbreakable[k].turn = setup_body_turn(&s->unbreakable[k].turn);
    }
    *in = (struct solid_input){.model = s->model,
                               .thickness = s->thickness,
                               .partial = s->partial_volume,
                               .horizons = s->horizons,
                               .cuts = s->cracks,
                               .cut = cut,
                               .spacing = s->spacing,
                               .bodies = s->bodies,
                               .body = body,
                               .materials = s->materials,
                               .material = material,
                               .limit = limits_of(s),
                               .indenters = s->indenters,
                               .indenter = indenters_of(s),
                               .interfaces = s->interfaces,
                               .interface = interface,
                               .constraints = s->constraints,
                               .constraint = constraint,
                               .unbreakables = s->unbreakables,
                               .unbreakable = unbreakable,
                               .surface_correction = s->surface_correction,
                               .precision = s->precision,
                               .contact = s->contact,
                               .contact_stiffness = s->contact_stiffness,
                               .contact_exponent = s->contact_exponent,
                               .contact_radius = s->contact_radius,
                               .depth = scene->coupling ? scene->coupling->surface : SOLID_DEPTH_HALF,
                               .rigid = needs.immersed && !needs.bonds};
    for (int d = 0; d < scene->dimension; d++) in->origin[d] = s->lattice_offset[d] * s->spacing;
    copy3(in->body_force, s->body_force);
    copy3(in->length, scene->domain.size);
    memcpy(in->periodic, scene->domain.periodic, sizeof in->periodic);
    for (int c = 0; c < 3; c++)
        for (int high = 0; high < 2; high++) in->wall[c][high] = is_wall(scene, c, high);
    return in;
}

static void give_back(const void *array) { free((void *)(uintptr_t)array); }

void setup_solid_free(struct solid_input *in) {
    for (int b = 0; b < in->bodies; b++) setup_body_free((struct solid_body *)(uintptr_t)&in->body[b]);
    for (int k = 0; k < in->cuts; k++) setup_body_cut_free((struct solid_cut *)(uintptr_t)&in->cut[k]);
    give_back(in->body);
    give_back(in->material);
    give_back(in->cut);
    give_back(in->constraint);
    give_back(in->unbreakable);
    give_back(in->interface);
    give_back(in->limit);
    give_back(in->indenter);
    free(in);
}

void setup_stage(const struct scene_stage *from, struct solid_stage *to) {
    *to = (struct solid_stage){.integrator = from->integrator,
                               .breakage = from->breakage,
                               .damping_relative = from->damping_relative,
                               .damping_absolute = fmax(from->damping_absolute, 0)};
}

/* Whether particles that share no bond may meet from the start: those of several bodies, on both sides of a crack, of
 * points with gaps, of an image, or of shapes that are not bonded. */
static int is_in_pieces(const struct scene_solid *s) {
    const enum solid_shape shape = s->body[0].own.shape;
    return s->bodies > 1 || s->cracks > 0 || shape == SOLID_POINTS || shape == SOLID_IMAGE ||
           s->body[0].contacts_broken;
}

struct setup_needs setup_needs_of(const struct scene *scene) {
    struct setup_needs needs = {.fluid = scene->fluid != NULL, .solid = scene->solid != NULL};
    needs.immersed = needs.fluid && needs.solid;
    for (int k = 0; needs.solid && k < scene->stages; k++) {
        needs.bonds |= scene->stage[k].solid == SCENE_SOLID_ELASTIC;
        needs.breakage |= scene_stage_may_break(scene, k);
    }
    needs.contact = needs.bonds && scene->solid->contact && (needs.breakage || is_in_pieces(scene->solid));
    return needs;
}
