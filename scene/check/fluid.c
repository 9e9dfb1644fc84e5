/* Checks that the fluid's sides, driving, initial flow and diffusion scheme fit together. */
#include "base/ensure.h"
#include "base/side.h"
#include "scene/check/check.h"

#include <math.h>

/* Its word in the scene. */
static const char *type_name(enum fluid_side_type type) {
    switch (type) {
    case FLUID_PERIODIC:
        return "periodic";
    case FLUID_WALL:
        return "wall";
    case FLUID_SLIP:
        return "slip";
    case FLUID_INFLOW:
        return "inflow";
    case FLUID_OUTFLOW:
        return "outflow";
    case FLUID_PRESSURE:
        return "pressure";
    case FLUID_GENERAL:
        return "general";
    }
    ENSURE(0, "side type %d", (int)type);
}

static struct scene_path side_path(int d, int end, const char *key) {
    return PATH("fluid.sides.%s%s%s", side_name[d][end], *key ? "." : "", key);
}

static int sides_clean(const struct scene_check *c, int d) {
    return CLEAN(c, side_path(d, 0, "").text) && CLEAN(c, side_path(d, 1, "").text);
}

static enum fluid_condition condition_of(const struct scene_side *s, int component) {
    return component == 0 ? s->u : component == 1 ? s->v : s->w;
}

/* Whether both sides of direction d prescribe the velocity component. */
static int has_walls(const struct scene_fluid *f, int d, int component) {
    int walls = 0;
    for (int end = 0; end < 2; end++) {
        const struct scene_side *s = &f->side[d][end];
        walls += s->type == FLUID_WALL || (s->type == FLUID_GENERAL && condition_of(s, component) == FLUID_DIRICHLET);
    }
    return walls == 2;
}

static void check_pair(const struct scene_check *c, int d) {
    const struct scene_side *side = c->scene->fluid->side[d];
    const int low = side[0].type == FLUID_PERIODIC, high = side[1].type == FLUID_PERIODIC;
    if (low != high)
        PROBLEM(c, side_path(d, low ? 0 : 1, "type").text, "periodic sides come in pairs, but %s is %s",
                side_name[d][low ? 1 : 0], type_name(side[low ? 1 : 0].type));
}

/* Checks the values given for one side against its type. */
static void check_side(const struct scene_check *c, int d, int end) {
    const struct scene_fluid *f = c->scene->fluid;
    const struct scene_side *side = &f->side[d][end];
    const int a = (d + 1) % 3, b = (d + 2) % 3;
    if (side->type == FLUID_WALL && side->velocity[d] != 0)
        PROBLEM(c, side_path(d, end, "velocity").text, "a wall moves in its own plane: the %c component must be 0",
                "xyz"[d]);
    if (side->type == FLUID_INFLOW && side->profile == FLUID_POISEUILLE && sides_clean(c, a) && sides_clean(c, b) &&
        !has_walls(f, a, d) && !has_walls(f, b, d))
        PROBLEM(c, side_path(d, end, "profile").text, "needs walls on both sides in %c or %c", "xyz"[a < b ? a : b],
                "xyz"[a < b ? b : a]);
    if (side->type == FLUID_GENERAL) {
        const enum fluid_condition normal = condition_of(side, d);
        if (normal == side->p)
            PROBLEM(c, side_path(d, end, "p").text, "must be %s where the normal velocity %c is %s",
                    normal == FLUID_NEUMANN ? "dirichlet" : "neumann", "uvw"[d],
                    normal == FLUID_NEUMANN ? "neumann" : "dirichlet");
    }
}

/* Prescribed inflow must be able to leave; an outflow side needs an inflow. */
static void check_flux(const struct scene_check *c) {
    const struct scene_fluid *f = c->scene->fluid;
    const double *size = c->scene->domain.size;
    double net = 0, scale = 0;
    int from_file = 0, open = 0, source = 0;
    for (int d = 0; d < 3; d++)
        for (int end = 0; end < 2; end++) {
            const struct scene_side *s = &f->side[d][end];
            const double area = size[0] * size[1] * size[2] / size[d], normal = end ? -s->velocity[d] : s->velocity[d];
            const int given = condition_of(s, d) == FLUID_DIRICHLET; /* of a general side */
            double in = 0;
            switch (s->type) {
            case FLUID_INFLOW:
                in = s->bulk_velocity * area;
                from_file |= s->profile == FLUID_PROFILE_FILE;
                source = 1;
                break;
            case FLUID_OUTFLOW:
                open = 1;
                break;
            case FLUID_PRESSURE:
                open = source = 1;
                break;
            case FLUID_GENERAL:
                in = given ? normal * area : 0;
                open |= !given;
                source = 1;
                break;
            case FLUID_PERIODIC:
            case FLUID_WALL:
            case FLUID_SLIP:
                break;
            }
            net += in;
            scale += fabs(in);
        }
    if (!open && (from_file || fabs(net) > 1e-12 * scale))
        PROBLEM(c, "fluid.sides",
                "the velocities given at the sides do not balance, and no side is an outflow or of "
                "given pressure");
    for (int d = 0; d < 3; d++)
        for (int end = 0; end < 2; end++)
            if (f->side[d][end].type == FLUID_OUTFLOW && !source)
                PROBLEM(c, side_path(d, end, "type").text,
                        "an outflow needs a side where something comes in (inflow, pressure or general)");
}

static void check_driven(const struct scene_check *c, int d, const char *key) {
    const struct scene_side *side = c->scene->fluid->side[d];
    if (!sides_clean(c, d) || (side[0].type == FLUID_PERIODIC && side[1].type == FLUID_PERIODIC)) return;
    PROBLEM(c, key, "must be a periodic direction: %s is %s, %s is %s", side_name[d][0], type_name(side[0].type),
            side_name[d][1], type_name(side[1].type));
}

static void check_driving(const struct scene_check *c) {
    const struct scene_fluid *f = c->scene->fluid;
    const int slanted = scene_node_find(c->root, "fluid.driving.along") != NULL;
    const char *key = slanted ? "fluid.driving.along" : "fluid.driving.direction";
    if (f->driving == FLUID_DRIVING_NONE || !CLEAN(c, "fluid.driving")) return;
    if (!scene_node_find(c->root, key)) return; /* a misplaced key has been reported */
    if (slanted && scene_check_parts_is_zero(f->driving_along)) PROBLEM(c, key, "must not be 0 in every direction");
    for (int d = 0; d < 3; d++)
        if (slanted ? f->driving_along[d] != 0 : d == f->driving_direction) check_driven(c, d, key);
}

/* In each direction in which the vortices vary there is one wave, sin or cos, which must fit the direction's sides. */
static void check_taylor_green(const struct scene_check *c) {
    const struct scene_fluid *f = c->scene->fluid;
    if (!f->has_taylor_green || !CLEAN(c, "fluid.initial")) return;
    for (int d = 0; d < 3; d++) {
        if (!scene_axes_has(f->taylor_green_axes, d)) continue;
        for (int end = 0; end < 2; end++)
            if (sides_clean(c, d) && f->side[d][end].type != FLUID_PERIODIC && f->side[d][end].type != FLUID_SLIP)
                PROBLEM(c, "fluid.initial.taylor_green.axes", "%s must be periodic or slip, it is %s",
                        side_name[d][end], type_name(f->side[d][end].type));
        if (CLEAN(c, "domain.cells") && c->scene->domain.cells[d] < 4)
            PROBLEM(c, "fluid.initial.taylor_green.axes", "needs at least 4 cells in %c, there are %d", "xyz"[d],
                    c -> scene -> domain.cells[d]);
    }
}

static void check_initial(const struct scene_check *c) {
    const struct scene_fluid *f = c->scene->fluid;
    const double *u = f->initial_velocity;
    if (!f->initial_poiseuille || !CLEAN(c, "fluid.initial")) return;
    const int along = (u[0] != 0) + (u[1] != 0) + (u[2] != 0), d = u[0] != 0 ? 0 : u[1] != 0 ? 1 : 2;
    const int a = (d + 1) % 3, b = (d + 2) % 3;
    if (along != 1)
        PROBLEM(c, "fluid.initial.poiseuille", "needs initial.velocity, its mean, along one of the axes");
    else if (sides_clean(c, a) && sides_clean(c, b) && !has_walls(f, a, d) && !has_walls(f, b, d))
        PROBLEM(c, "fluid.initial.poiseuille", "needs walls on both sides in %c or %c", "xyz"[a < b ? a : b],
                "xyz"[a < b ? b : a]);
}

/* Checks the conditions of implicit diffusion: a given normal velocity on every side, weak coupling, and a solid that
 * does not break (each marker keeps a guess of its force). */
static void check_diffusion(const struct scene_check *c) {
    const struct scene *s = c->scene;
    const struct scene_fluid *f = s->fluid;
    int breaks = 0;
    if (f->diffusion != SCENE_DIFFUSION_IMPLICIT) return;
    if (f->projection == FLUID_LAST_STAGE) PROBLEM(c, "fluid.projection", "does not go with fluid.diffusion: implicit");
    for (int d = 0; d < 3; d++)
        for (int end = 0; end < 2; end++) {
            const struct scene_side *side = &f->side[d][end];
            const int clean = CLEAN(c, side_path(d, end, "").text);
            const int free =
                side->type == FLUID_PRESSURE || (side->type == FLUID_GENERAL && side->p == FLUID_DIRICHLET);
            if (clean && free)
                PROBLEM(c, "fluid.diffusion", "needs a normal velocity on every side, and %s has a pressure",
                        side_name[d][end]);
        }
    for (int k = 0; s->solid && k < s->stages; k++)
        breaks |= s->stage[k].solid == SCENE_SOLID_ELASTIC && s->stage[k].breakage;
    for (int m = 0; breaks && m < s->solid->materials; m++)
        if (isfinite(s->solid->material[m].fracture_energy)) {
            PROBLEM(c, "fluid.diffusion",
                    "needs a solid that does not break: material %s has a fracture energy, and "
                    "a stage breakage",
                    s->solid->material[m].name);
            return;
        }
}

/* A velocity of the scene with which the cells hold nothing of the flow. frana check and the log warn from 1000 on,
 * where the flow may yet be bounded; a million is no flow of this program, but a wrong unit. Not of an initial flow:
 * vortices that the cells resolve go on without viscosity too. */
static void check_resolved(const struct scene_check *c) {
    const double most = 1e6;
    const struct scene *s = c->scene;
    const struct scene_fluid *f = s->fluid;
    double u = f->driving == FLUID_DRIVING_BULK ? fabs(f->driving_value) : 0, width = INFINITY;
    for (int d = 0; d < 3; d++) {
        width = fmin(width, s->domain.size[d] / s->domain.cells[d]);
        for (int end = 0; end < 2; end++) {
            u = fmax(u, fabs(f->side[d][end].bulk_velocity));
            for (int e = 0; e < 3; e++) u = fmax(u, fabs(f->side[d][end].velocity[e]));
        }
    }
    if (u * width <= most * f->viscosity) return;
    PROBLEM(c, "fluid.viscosity",
            "the Reynolds number of a cell, U d/nu, is %.3g, with U = %g m/s and d = %.4g m: it may be %g, which needs "
            "%.3g m2/s or more",
            u * width / f->viscosity, u, width, most, u * width / most);
}

void scene_check_fluid(const struct scene_check *c) {
    if (!c->scene->fluid) return;
    for (int d = 0; d < 3; d++) {
        if (sides_clean(c, d)) check_pair(c, d);
        for (int end = 0; end < 2; end++)
            if (CLEAN(c, side_path(d, end, "").text)) check_side(c, d, end);
    }
    if (CLEAN(c, "fluid.sides") && CLEAN(c, "domain.size")) check_flux(c);
    check_driving(c);
    check_initial(c);
    check_diffusion(c);
    check_taylor_green(c);
    if (CLEAN(c, "fluid") && CLEAN(c, "domain")) check_resolved(c);
}
