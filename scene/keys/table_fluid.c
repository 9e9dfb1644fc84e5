/* Keys of the section fluid. */
#include "scene/keys/table.h"

static const struct scene_word side_types[] = {WORD("periodic", FLUID_PERIODIC), WORD("wall", FLUID_WALL),
                                               WORD("slip", FLUID_SLIP),         WORD("inflow", FLUID_INFLOW),
                                               WORD("outflow", FLUID_OUTFLOW),   WORD("pressure", FLUID_PRESSURE),
                                               WORD("general", FLUID_GENERAL)};
static const struct scene_word profiles[] = {WORD("uniform", FLUID_UNIFORM), WORD("poiseuille", FLUID_POISEUILLE),
                                             WORD("file", FLUID_PROFILE_FILE)};
static const struct scene_word conditions[] = {WORD("dirichlet", FLUID_DIRICHLET), WORD("neumann", FLUID_NEUMANN)};
static const struct scene_word drivings[] = {WORD("none", FLUID_DRIVING_NONE),
                                             WORD("pressure_gradient", FLUID_DRIVING_GRADIENT),
                                             WORD("bulk_velocity", FLUID_DRIVING_BULK)};
static const struct scene_word axes[] = {WORD("xy", SCENE_XY), WORD("xz", SCENE_XZ), WORD("yz", SCENE_YZ),
                                         WORD("xyz", SCENE_XYZ)};
static const struct scene_word diffusions[] = {WORD("explicit", SCENE_DIFFUSION_EXPLICIT),
                                               WORD("implicit", SCENE_DIFFUSION_IMPLICIT)};
static const struct scene_word projections[] = {WORD("each_stage", FLUID_EACH_STAGE),
                                                WORD("last_stage", FLUID_LAST_STAGE)};

/* clang-format off */
#define OF scene_side
static const struct scene_key side[] = {
    KEY("type", CHOICE(type, side_types), "choice", NEEDED),
    KEY("velocity", VECTOR(velocity), "m/s", DEFAULT("[0, 0, 0]"), WHERE("type", "wall general")),
    KEY("profile", CHOICE(profile, profiles), "choice", DEFAULT("uniform"), WHERE("type", "inflow")),
    KEY("bulk_velocity", NUMBER(bulk_velocity), "m/s", NEEDED, ABOVE(0), WHERE("profile", "uniform poiseuille")),
    KEY("file", TEXT(file), "file", NEEDED, WHERE("profile", "file")),
    KEY("pressure", NUMBER(pressure), "Pa", DEFAULT("0"), WHERE("type", "pressure")),
    KEY("u", CHOICE(u, conditions), "choice", NEEDED, WHERE("type", "general")),
    KEY("v", CHOICE(v, conditions), "choice", NEEDED, WHERE("type", "general")),
    KEY("w", CHOICE(w, conditions), "choice", NEEDED, WHERE("type", "general")),
    KEY("p", CHOICE(p, conditions), "choice", NEEDED, WHERE("type", "general")),
    END};
#undef OF

#define OF scene_fluid
static const struct scene_key vortices[] = {
    KEY("velocity", NUMBER(taylor_green_velocity), "m/s", NEEDED),
    KEY("axes", CHOICE(taylor_green_axes, axes), "choice", DEFAULT("xy")),
    END};
static const struct scene_key initial[] = {
    KEY("velocity", VECTOR(initial_velocity), "m/s", DEFAULT("[0, 0, 0]")),
    KEY("poiseuille", SWITCH(initial_poiseuille), "bool", DEFAULT("false"), NOT_WITH("taylor_green")),
    KEY("taylor_green", PART(vortices), "section"),
    END};
#define SIDE(name, direction, end) KEY(name, INNER(side[direction][end], side), "section", NEEDED, .described = "SIDE")
static const struct scene_key sides[] = {
    SIDE("x_low", 0, 0), SIDE("x_high", 0, 1), SIDE("y_low", 1, 0), SIDE("y_high", 1, 1),
    SIDE("z_low", 2, 0), SIDE("z_high", 2, 1), END};
static const struct scene_key driving[] = {
    KEY("type", CHOICE(driving, drivings), "choice", NEEDED),
    KEY("direction", CHOICE(driving_direction, scene_table_axes), "choice", DEFAULT("x"),
        WHERE("type", "pressure_gradient bulk_velocity"), NOT_WITH("along")),
    KEY("along", VECTOR(driving_along), "1", WHERE("type", "pressure_gradient")),
    KEY("value", NUMBER(driving_value), "Pa/m or m/s", NEEDED, WHERE("type", "pressure_gradient bulk_velocity")),
    KEY("frequency", NUMBER(driving_frequency), "Hz", DEFAULT("0"), FROM(0), WHERE("type", "pressure_gradient")),
    END};
const struct scene_key scene_table_fluid[] = {
    KEY("density", NUMBER(density), "kg/m3", NEEDED, ABOVE(0)),
    KEY("viscosity", NUMBER(viscosity), "m2/s", NEEDED, ABOVE(0)),
    KEY("diffusion", CHOICE(diffusion, diffusions), "choice", DEFAULT("explicit")),
    KEY("projection", CHOICE(projection, projections), "choice", DEFAULT("each_stage")),
    KEY("initial", PART(initial), "section", DEFAULT("{}")),
    KEY("sides", PART(sides), "section", NEEDED),
    KEY("driving", PART(driving), "section", DEFAULT("{type: none}")),
    KEY("body_force", VECTOR(body_force), "m/s2", DEFAULT("[0, 0, 0]")),
    END};
#undef OF
/* clang-format on */
