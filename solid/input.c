/* Checks a solid's input and makes the copy that the solid keeps. */
#include "solid/input.h"
#include "base/die.h"
#include "base/memory.h"
#include "physics/limits.h"
#include "solid/imposed/time.h"
#include "solid/law/material.h"

#include <math.h>
#include <stdint.h>

/* Of a body or a part. */
static void copy_entries(struct solid_body *body) {
    body->entry = memory_copy(MEMORY_SOLID, body->entry, (size_t)body->entries, sizeof *body->entry);
}

/* The lists of a body on the lattice, which its surface is made of later. */
static void copy_shapes(struct solid_body *body) {
    struct solid_body *part = memory_copy(MEMORY_SOLID, body->part, (size_t)body->parts, sizeof *part);
    copy_entries(body);
    for (int p = 0; p < body->parts; p++) copy_entries(&part[p]);
    body->part = part;
}

static void free_shapes(const struct solid_body *body) {
    for (int p = 0; p < body->parts; p++) memory_free((void *)(uintptr_t)body->part[p].entry);
    MEMORY_FREE((void *)(uintptr_t)body->part, (void *)(uintptr_t)body->entry);
}

void solid_input_copy(struct solid_input *to, const struct solid_input *from) {
    *to = *from;
    to->body = memory_copy(MEMORY_SOLID, from->body, (size_t)from->bodies, sizeof *from->body);
    to->material = memory_copy(MEMORY_SOLID, from->material, (size_t)from->materials, sizeof *from->material);
    to->constraint = memory_copy(MEMORY_SOLID, from->constraint, (size_t)from->constraints, sizeof *from->constraint);
    to->unbreakable =
        memory_copy(MEMORY_SOLID, from->unbreakable, (size_t)from->unbreakables, sizeof *from->unbreakable);
    to->interface = memory_copy(MEMORY_SOLID, from->interface, (size_t)from->interfaces, sizeof *from->interface);
    if (from->limit) to->limit = memory_copy(MEMORY_SOLID, from->limit, (size_t)from->materials, sizeof *from->limit);
    if (from->indenters > 0)
        to->indenter = memory_copy(MEMORY_SOLID, from->indenter, (size_t)from->indenters, sizeof *from->indenter);
    for (int b = 0; b < to->bodies; b++) {
        struct solid_body *body = (struct solid_body *)(uintptr_t)&to->body[b];
        copy_shapes(body);
        body->least_horizon = to->material[body->material].horizon_ratio * to->spacing;
        for (long p = 0; body->point_horizon && p < body->points; p++)
            body->least_horizon = fmin(body->least_horizon, body->point_horizon[p]);
    }
    to->load = memory_copy(MEMORY_SOLID, from->load, (size_t)from->loads, sizeof *from->load);
    for (int k = 0; k < to->constraints; k++) solid_time_copy((struct solid_time *)(uintptr_t)&to->constraint[k].time);
    for (int k = 0; k < to->loads; k++) solid_time_copy((struct solid_time *)(uintptr_t)&to->load[k].time);
}

void solid_input_free(struct solid_input *in) {
    for (int k = 0; k < in->constraints; k++) solid_time_free((struct solid_time *)(uintptr_t)&in->constraint[k].time);
    for (int k = 0; k < in->loads; k++) solid_time_free((struct solid_time *)(uintptr_t)&in->load[k].time);
    for (int b = 0; b < in->bodies; b++) free_shapes(&in->body[b]);
    const void *const own[] = {in->body, in->material,  in->constraint, in->unbreakable,
                               in->load, in->interface, in->limit,      in->indenters > 0 ? in->indenter : NULL};
    for (size_t i = 0; i < sizeof own / sizeof own[0]; i++) memory_free((void *)(uintptr_t)own[i]);
}

/* All particles need the horizon that the stretches of the bilinear law are computed for. */
static void check_softening(const struct solid_input *in, int m) {
    const struct solid_material *k = &in->material[m];
    if (!(k->fracture_energy < INFINITY) || in->refinement ||
        !(solid_material_softening(in->model, in->thickness, k, k->horizon_ratio * in->spacing).s_c > 0))
        die_all(EXIT_CODE_SCENE,
                "solid material %d: bonds that soften need a fracture energy, a narrower horizon than %g m, and no "
                "refinement",
                m, k->horizon_ratio * in->spacing);
    for (int b = 0; b < in->bodies; b++)
        if (in->body[b].material == m && in->body[b].point_horizon)
            die_all(EXIT_CODE_SCENE, "solid body %s: bonds that soften need one horizon for all its points",
                    in->body[b].name);
}

/* The limit stands alone, and its array does not follow a refinement. */
static void check_limit(const struct solid_input *in, int m) {
    const struct solid_material *k = &in->material[m];
    const struct solid_limit *limit = &in->limit[m];
    if (!(limit->alpha >= 0) || !(limit->fracture_energy > 0) || k->fracture_energy < INFINITY ||
        k->tensile_strength > 0 || in->refinement)
        die_all(EXIT_CODE_SCENE,
                "solid material %d: a limit that follows the other bonds goes with no fracture energy, no strength and "
                "no refinement",
                m);
    for (int i = 0; i < in->interfaces; i++)
        for (int e = 0; e < 2; e++)
            if (in->body[in->interface[i].body[e]].material == m)
                die_all(EXIT_CODE_SCENE,
                        "solid.interfaces[%d]: does not go with a limit that follows the other bonds (material %d)", i,
                        m);
}

/* Of both bodies all bonds are in lists, by one law each. */
static void check_interface(const struct solid_input *in, int k) {
    const struct solid_interface *i = &in->interface[k];
    for (int e = 0; e < 2; e++)
        if (i->body[e] < 0 || i->body[e] >= in->bodies || i->body[0] == i->body[1] ||
            in->material[in->body[i->body[e]].material].tensile_strength > 0)
            die_all(EXIT_CODE_SCENE, "solid.interfaces[%d]: needs two bodies whose materials are brittle", k);
    if (!(i->fracture_energy > 0) || in->refinement || in->horizons == SOLID_ONE_SIDED)
        die_all(EXIT_CODE_SCENE,
                "solid.interfaces[%d]: needs a fracture_energy above 0, dual horizons and no refinement", k);
}

/* The lattice store has one stencil a body, and takes bonds of several materials as long as they are brittle. */
static void check_kinds(const struct solid_input *in, int b) {
    const struct solid_body *body = &in->body[b];
    const double ratio = in->material[body->material].horizon_ratio;
    for (int k = 0; k < body->image_materials; k++) {
        const int m = body->image_material[k];
        if (m < 0 || m >= in->materials || body->image_material[0] != body->material ||
            body->image_materials > SOLID_BODY_MATERIALS_MAX)
            die_all(EXIT_CODE_SCENE, "solid body %s: material %d of %d, %d kinds", body->name, m, in->materials,
                    body->image_materials);
        if (body->image_materials < 2) continue;
        if (!body->voxels || in->general_bonds || in->partial != SOLID_PARTIAL_EXACT ||
            in->material[m].micromodulus != PHYSICS_CONSTANT || in->material[m].horizon_ratio != ratio ||
            in->material[m].tensile_strength > 0 || (in->limit && in->limit[m].s00 > 0))
            die_all(EXIT_CODE_SCENE,
                    "solid body %s: several materials in a body need an image, exact partial volumes, one horizon, a "
                    "constant micromodulus and brittle bonds",
                    body->name);
    }
    for (int k = 0; body->image_materials > 1 && k < in->interfaces; k++)
        if (in->interface[k].body[0] == b || in->interface[k].body[1] == b)
            die_all(EXIT_CODE_SCENE, "solid.interfaces[%d]: body %s is of several materials", k, body->name);
}

void solid_input_check(const struct solid_input *in) {
    if (!(in->spacing > 0)) die_all(EXIT_CODE_SCENE, "solid.spacing = %g: must be above 0", in->spacing);
    if (in->model != PHYSICS_3D && !(in->thickness > 0))
        die_all(EXIT_CODE_SCENE, "solid.thickness = %g: must be above 0", in->thickness);
    if (in->bodies < 1 || in->bodies > PHYSICS_BODIES_MAX)
        die_all(EXIT_CODE_SCENE, "solid.bodies: %d of them; must be 1 to %d", in->bodies, PHYSICS_BODIES_MAX);
    for (int b = 0; b < in->bodies; b++) {
        const int m = in->body[b].material;
        if (m < 0 || m >= in->materials)
            die_all(EXIT_CODE_SCENE, "solid body %s: material %d of %d", in->body[b].name, m, in->materials);
    }
    for (int m = 0; m < in->materials; m++) {
        const struct solid_material *k = &in->material[m];
        if (!(k->youngs_modulus > 0) || !(k->density > 0) || !(k->fracture_energy >= 0) || !(k->horizon_ratio >= 1))
            die_all(EXIT_CODE_SCENE,
                    "solid material %d: youngs_modulus %g and density %g must be above 0, fracture_energy %g "
                    "not below 0, "
                    "horizon_ratio %g at least 1 particle spacing",
                    m, k->youngs_modulus, k->density, k->fracture_energy, k->horizon_ratio);
        if (k->tensile_strength > 0) check_softening(in, m);
    }
    for (int b = 0; b < in->bodies; b++) check_kinds(in, b);
    for (int k = 0; k < in->interfaces; k++) check_interface(in, k);
    for (int m = 0; in->limit && m < in->materials; m++)
        if (in->limit[m].s00 > 0) check_limit(in, m);
    for (int k = 0; k < in->indenters; k++)
        if (!(in->indenter[k].radius > 0) || !(in->indenter[k].stiffness > 0))
            die_all(EXIT_CODE_SCENE, "solid.indenters[%d]: radius %g and stiffness %g must be above 0", k,
                    in->indenter[k].radius, in->indenter[k].stiffness);
}
