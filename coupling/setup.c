#include "coupling/setup.h"
#include "base/par.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void copy3(double to[3], const double from[3]) { memcpy(to, from, 3 * sizeof(double)); }

static void setup_side(const struct scene_side *from, struct fluid_side *to) {
    static const enum fluid_side_type type[] = {
        [SCENE_PERIODIC] = FLUID_PERIODIC, [SCENE_WALL] = FLUID_WALL,       [SCENE_SLIP] = FLUID_SLIP,
        [SCENE_INFLOW] = FLUID_INFLOW,     [SCENE_OUTFLOW] = FLUID_OUTFLOW, [SCENE_PRESSURE] = FLUID_PRESSURE,
        [SCENE_GENERAL] = FLUID_GENERAL};
    static const enum fluid_profile profile[] = {[SCENE_UNIFORM] = FLUID_UNIFORM,
                                                 [SCENE_POISEUILLE] = FLUID_POISEUILLE,
                                                 [SCENE_PROFILE_FILE] = FLUID_PROFILE_FILE};
    const enum scene_condition condition[4] = {from->u, from->v, from->w, from->p};
    to->type = type[from->type];
    copy3(to->velocity, from->velocity);
    to->profile = profile[from->profile];
    to->bulk_velocity = from->bulk_velocity;
    snprintf(to->file, sizeof to->file, "%s", from->file);
    to->pressure = from->pressure;
    for (int q = 0; q < 4; q++)
        to->condition[q] = condition[q] == SCENE_NEUMANN ? FLUID_NEUMANN : FLUID_DIRICHLET;
}

void setup_fluid(const struct scene *scene, struct fluid_input *in) {
    static const enum fluid_driving_type driving[] = {[SCENE_DRIVING_NONE] = FLUID_DRIVING_NONE,
                                                      [SCENE_DRIVING_GRADIENT] = FLUID_DRIVING_GRADIENT,
                                                      [SCENE_DRIVING_BULK] = FLUID_DRIVING_BULK};
    const struct scene_fluid *f = scene->fluid;
    *in = (struct fluid_input){.density = f->density,
                               .viscosity = f->viscosity,
                               .driving = {driving[f->driving], f->driving_direction, f->driving_value},
                               .initial_poiseuille = f->initial_poiseuille,
                               .immersed = scene->solid != NULL};
    memcpy(in->n, scene->domain.cells, sizeof in->n);
    copy3(in->length, scene->domain.size);
    copy3(in->body_force, f->body_force);
    copy3(in->initial_velocity, f->initial_velocity);
    for (int c = 0; c < 3; c++)
        for (int e = 0; e < 2; e++) setup_side(&f->side[c][e], &in->side[c][e]);
}

/* Particles of a point file: x y z volume a line; rank 0 reads, everybody gets them. Collective. */
static void setup_points(const struct scene_body *from, struct solid_body *to) {
    double *value = NULL;
    long lines = 0;
    if (par_rank() == 0) {
        FILE *file = fopen(from->file, "r");
        if (!file)
            die(EXIT_CODE_FILE, "%s: the point file of body %s can't be opened", from->file, from->name);
        long capacity = 0;
        double v[4];
        int got;
        while ((got = fscanf(file, "%lf %lf %lf %lf", &v[0], &v[1], &v[2], &v[3])) == 4) {
            if (lines == capacity) value = realloc(value, (size_t)(capacity = 2 * capacity + 64) * sizeof v);
            ENSURE(value, "no memory for %ld points", capacity);
            memcpy(value + 4 * lines++, v, sizeof v);
        }
        fclose(file);
        if (got != EOF || lines == 0)
            die(EXIT_CODE_FILE, "%s: line %ld is not the four numbers x y z volume", from->file, lines + 1);
    }
    par_bcast(&lines, sizeof lines, 0);
    double *column = malloc((size_t)lines * 4 * sizeof(double));
    for (long i = 0; value && i < lines; i++)
        for (int c = 0; c < 4; c++) column[c * lines + i] = value[4 * i + c];
    free(value);
    par_bcast(column, (size_t)lines * 4 * sizeof(double), 0);
    to->points = lines;
    for (int c = 0; c < 3; c++) to->point[c] = column + c * lines;
    to->point_volume = column + 3 * lines;
}

static void setup_body(const struct scene_body *from, struct solid_body *to) {
    static const enum solid_shape shape[] = {[SCENE_BOX] = SOLID_BOX,
                                             [SCENE_SPHERE] = SOLID_SPHERE,
                                             [SCENE_CYLINDER] = SOLID_CYLINDER,
                                             [SCENE_POINTS] = SOLID_POINTS};
    *to = (struct solid_body){.shape = shape[from->shape],
                              .radius = from->radius,
                              .axis = from->axis,
                              .length = from->length,
                              .material = from->material_index};
    snprintf(to->name, sizeof to->name, "%s", from->name);
    copy3(to->low, from->low);
    copy3(to->high, from->high);
    copy3(to->centre, from->centre);
    if (from->has_cavities) {
        to->cavity_period = from->cavity_period;
        to->cavity_radius = from->cavity_radius;
        copy3(to->cavity_centre, from->cavity_centre);
    }
    if (to->shape == SOLID_POINTS) setup_points(from, to);
}

struct solid_input *setup_solid(const struct scene *scene) {
    const struct scene_solid *s = scene->solid;
    struct solid_input *in = calloc(1, sizeof *in);
    struct solid_body *body = calloc((size_t)s->bodies, sizeof *body);
    struct solid_material *material = calloc((size_t)s->materials, sizeof *material);
    struct solid_constraint *constraint = calloc((size_t)s->constraints + 1, sizeof *constraint);
    struct solid_region *unbreakable = calloc((size_t)s->unbreakables + 1, sizeof *unbreakable);
    for (int b = 0; b < s->bodies; b++) setup_body(&s->body[b], &body[b]);
    for (int m = 0; m < s->materials; m++)
        material[m] = (struct solid_material){s->material[m].youngs_modulus, s->material[m].density,
                                              s->material[m].fracture_energy, s->material[m].horizon_ratio};
    for (int k = 0; k < s->constraints; k++) {
        copy3(constraint[k].low, s->constraint[k].low);
        copy3(constraint[k].high, s->constraint[k].high);
        copy3(constraint[k].velocity, s->constraint[k].velocity);
        memcpy(constraint[k].direction, s->constraint[k].direction, sizeof constraint[k].direction);
    }
    for (int k = 0; k < s->unbreakables; k++) {
        copy3(unbreakable[k].low, s->unbreakable[k].low);
        copy3(unbreakable[k].high, s->unbreakable[k].high);
    }
    *in = (struct solid_input){.spacing = s->spacing,
                               .bodies = s->bodies,
                               .body = body,
                               .materials = s->materials,
                               .material = material,
                               .constraints = s->constraints,
                               .constraint = constraint,
                               .unbreakables = s->unbreakables,
                               .unbreakable = unbreakable,
                               .surface_correction = s->surface_correction,
                               .contact = s->contact,
                               .contact_stiffness = s->contact_stiffness,
                               .contact_exponent = s->contact_exponent,
                               .contact_radius = s->contact_radius};
    copy3(in->body_force, s->body_force);
    copy3(in->length, scene->domain.size);
    memcpy(in->periodic, scene->domain.periodic, sizeof in->periodic);
    return in;
}

void setup_solid_free(struct solid_input *in) {
    for (int b = 0; b < in->bodies; b++) free((void *)(size_t)in->body[b].point[0]);
    free((void *)(size_t)in->body);
    free((void *)(size_t)in->material);
    free((void *)(size_t)in->constraint);
    free((void *)(size_t)in->unbreakable);
    free(in);
}

void setup_stage(const struct scene_stage *from, struct solid_stage *to) {
    *to = (struct solid_stage){.integrator = from->integrator == SCENE_VERLET ? SOLID_VERLET : SOLID_RK3,
                               .breakage = from->breakage,
                               .damping_relative = from->damping_relative,
                               .damping_absolute = from->damping_absolute};
}

struct setup_needs setup_needs_of(const struct scene *scene) {
    struct setup_needs needs = {.fluid = scene->fluid != NULL, .solid = scene->solid != NULL};
    needs.immersed = needs.fluid && needs.solid;
    for (int k = 0; needs.solid && k < scene->stages; k++) {
        const int elastic = scene->stage[k].solid == SCENE_SOLID_ELASTIC;
        needs.bonds |= elastic;
        for (int m = 0; m < scene->solid->materials; m++)
            needs.breakage |=
                elastic && scene->stage[k].breakage && isfinite(scene->solid->material[m].fracture_energy);
    }
    return needs;
}
