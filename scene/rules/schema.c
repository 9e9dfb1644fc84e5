/* libcyaml schema of the scene, except for the section solid. */
#include "scene/rules/schema.h"
#include "base/text.h"
#include "scene/rules/schema_parts.h"
#include "scene/text/node.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const cyaml_schema_value_t whole = {CYAML_VALUE_INT(NEEDED, int)};
static const cyaml_schema_value_t boolean = {CYAML_VALUE_BOOL(NEEDED, int)};

static const cyaml_strval_t side_types[] = {
    {"periodic", SCENE_PERIODIC}, {"wall", SCENE_WALL},         {"slip", SCENE_SLIP},      {"inflow", SCENE_INFLOW},
    {"outflow", SCENE_OUTFLOW},   {"pressure", SCENE_PRESSURE}, {"general", SCENE_GENERAL}};
static const cyaml_strval_t profiles[] = {
    {"uniform", SCENE_UNIFORM}, {"poiseuille", SCENE_POISEUILLE}, {"file", SCENE_PROFILE_FILE}};
static const cyaml_strval_t conditions[] = {{"dirichlet", SCENE_DIRICHLET}, {"neumann", SCENE_NEUMANN}};
static const cyaml_strval_t drivings[] = {
    {"none", SCENE_DRIVING_NONE}, {"pressure_gradient", SCENE_DRIVING_GRADIENT}, {"bulk_velocity", SCENE_DRIVING_BULK}};
static const cyaml_strval_t axes[] = {{"xy", SCENE_XY}, {"xz", SCENE_XZ}, {"yz", SCENE_YZ}, {"xyz", SCENE_XYZ}};
static const cyaml_strval_t load_forms[] = {{"reaction", SCENE_LOAD_REACTION},
                                            {"probe", SCENE_LOAD_PROBE},
                                            {"wall", SCENE_LOAD_WALL},
                                            {"balanced", SCENE_LOAD_BALANCED}};
static const cyaml_strval_t schemes[] = {{"explicit", SCENE_EXPLICIT}, {"strong", SCENE_STRONG}};
static const cyaml_strval_t relaxations[] = {{"quasi_newton", SCENE_QUASI_NEWTON}, {"aitken", SCENE_AITKEN}};
static const cyaml_strval_t diffusions[] = {{"explicit", SCENE_DIFFUSION_EXPLICIT},
                                            {"implicit", SCENE_DIFFUSION_IMPLICIT}};
static const cyaml_strval_t projections[] = {{"each_stage", SCENE_EACH_STAGE}, {"last_stage", SCENE_LAST_STAGE}};
static const cyaml_strval_t modes[] = {{"rigid", SCENE_SOLID_RIGID}, {"elastic", SCENE_SOLID_ELASTIC}};
static const cyaml_strval_t surfaces[] = {{"lattice", SCENE_SURFACE_LATTICE}, {"shape", SCENE_SURFACE_SHAPE}};
static const cyaml_strval_t medium_directions[] = {{"auto", SCENE_MEDIUM_AUTO},
                                                   {"x", SCENE_MEDIUM_X},
                                                   {"y", SCENE_MEDIUM_Y},
                                                   {"z", SCENE_MEDIUM_Z},
                                                   {"driving", SCENE_MEDIUM_DRIVING}};
static const cyaml_strval_t until_quantities[] = {{"permeability", SCENE_UNTIL_PERMEABILITY}};
static const cyaml_strval_t fluid_integrators[] = {{"rk3", SCENE_FLUID_RK3}, {"ab2", SCENE_FLUID_AB2}};
static const cyaml_strval_t integrators[] = {{"rk3", SCENE_RK3}, {"verlet", SCENE_VERLET}};

static const cyaml_schema_field_t domain_fields[] = {
    VECTOR("size", NEEDED, scene_domain, size),
    CYAML_FIELD_SEQUENCE_FIXED("cells", OPTIONAL, struct scene_domain, cells, &whole, 3),
    CYAML_FIELD_SEQUENCE_FIXED("periodic", OPTIONAL, struct scene_domain, periodic, &boolean, 3), CYAML_FIELD_END};

static const cyaml_schema_field_t taylor_green_fields[] = {
    NUMBER("velocity", NEEDED, scene_fluid, taylor_green_velocity),
    CHOICE("axes", OPTIONAL, scene_fluid, taylor_green_axes, axes), CYAML_FIELD_END};
static const cyaml_schema_field_t initial_fields[] = {VECTOR("velocity", OPTIONAL, scene_fluid, initial_velocity),
                                                      BOOLEAN("poiseuille", OPTIONAL, scene_fluid, initial_poiseuille),
                                                      PART("taylor_green", OPTIONAL, scene_fluid, taylor_green_fields),
                                                      CYAML_FIELD_END};

static const cyaml_schema_field_t side_fields[] = {CHOICE("type", NEEDED, scene_side, type, side_types),
                                                   VECTOR("velocity", OPTIONAL, scene_side, velocity),
                                                   CHOICE("profile", OPTIONAL, scene_side, profile, profiles),
                                                   NUMBER("bulk_velocity", OPTIONAL, scene_side, bulk_velocity),
                                                   TEXT("file", OPTIONAL, scene_side, file),
                                                   NUMBER("pressure", OPTIONAL, scene_side, pressure),
                                                   CHOICE("u", OPTIONAL, scene_side, u, conditions),
                                                   CHOICE("v", OPTIONAL, scene_side, v, conditions),
                                                   CHOICE("w", OPTIONAL, scene_side, w, conditions),
                                                   CHOICE("p", OPTIONAL, scene_side, p, conditions),
                                                   CYAML_FIELD_END};

#define SIDE(key, d, end) CYAML_FIELD_MAPPING(key, NEEDED, struct scene_fluid, side[d][end], side_fields)
static const cyaml_schema_field_t sides_fields[] = {SIDE("x_low", 0, 0),  SIDE("x_high", 0, 1), SIDE("y_low", 1, 0),
                                                    SIDE("y_high", 1, 1), SIDE("z_low", 2, 0),  SIDE("z_high", 2, 1),
                                                    CYAML_FIELD_END};

static const cyaml_schema_field_t driving_fields[] = {
    CHOICE("type", NEEDED, scene_fluid, driving, drivings),
    CHOICE("direction", OPTIONAL, scene_fluid, driving_direction, scene_schema_parts_axes),
    VECTOR("along", OPTIONAL, scene_fluid, driving_along),
    NUMBER("value", OPTIONAL, scene_fluid, driving_value),
    NUMBER("frequency", OPTIONAL, scene_fluid, driving_frequency),
    CYAML_FIELD_END};

static const cyaml_schema_field_t fluid_fields[] = {
    NUMBER("density", NEEDED, scene_fluid, density),
    NUMBER("viscosity", NEEDED, scene_fluid, viscosity),
    CHOICE("diffusion", OPTIONAL, scene_fluid, diffusion, diffusions),
    CHOICE("projection", OPTIONAL, scene_fluid, projection, projections),
    PART("initial", OPTIONAL, scene_fluid, initial_fields),
    PART("sides", NEEDED, scene_fluid, sides_fields),
    PART("driving", OPTIONAL, scene_fluid, driving_fields),
    VECTOR("body_force", OPTIONAL, scene_fluid, body_force),
    CYAML_FIELD_END};

static const cyaml_schema_field_t medium_fields[] = {
    VECTOR("low", OPTIONAL, scene_coupling, box_low), VECTOR("high", OPTIONAL, scene_coupling, box_high),
    CHOICE("direction", OPTIONAL, scene_coupling, medium_direction, medium_directions), CYAML_FIELD_END};

static const cyaml_schema_field_t coupling_fields[] = {
    WHOLE("forcing_iterations", OPTIONAL, scene_coupling, forcing_iterations),
    CHOICE("surface", OPTIONAL, scene_coupling, surface, surfaces),
    NUMBER("retraction", OPTIONAL, scene_coupling, retraction),
    NUMBER("probe_length", OPTIONAL, scene_coupling, probe_length),
    CHOICE("load", OPTIONAL, scene_coupling, load, load_forms),
    CHOICE("scheme", OPTIONAL, scene_coupling, scheme, schemes),
    CHOICE("relaxation", OPTIONAL, scene_coupling, relaxation, relaxations),
    NUMBER("tolerance", OPTIONAL, scene_coupling, tolerance),
    WHOLE("iterations", OPTIONAL, scene_coupling, iterations),
    PART("medium", OPTIONAL, scene_coupling, medium_fields),
    CYAML_FIELD_END};

static const cyaml_schema_value_t pair = {CYAML_VALUE_SEQUENCE_FIXED(NEEDED, double, &scene_schema_parts_real, 2)};
static const cyaml_schema_field_t injection_fields[] = {
    VECTOR("low", NEEDED, scene_injection, low),
    VECTOR("high", NEEDED, scene_injection, high),
    NUMBER("rate", OPTIONAL, scene_injection, rate),
    NUMBER("pressure", OPTIONAL, scene_injection, pressure),
    ENTRIES("time", LIST, scene_injection, time.point, time.n, &pair, 1, LIST_MAX),
    CYAML_FIELD_END};
static const cyaml_schema_value_t injection = {CYAML_VALUE_MAPPING(NEEDED, struct scene_injection, injection_fields)};
static const cyaml_schema_field_t pores_fields[] = {NUMBER("permeability", NEEDED, scene_pores, permeability),
                                                    NUMBER("biot", NEEDED, scene_pores, biot),
                                                    NUMBER("modulus", OPTIONAL, scene_pores, modulus), CYAML_FIELD_END};
static const cyaml_schema_field_t crack_fluid_fields[] = {
    NUMBER("viscosity", OPTIONAL, scene_crack_fluid, viscosity),
    NUMBER("compressibility", OPTIONAL, scene_crack_fluid, compressibility),
    NUMBER("least_pressure", OPTIONAL, scene_crack_fluid, least_pressure),
    NUMBER("least_aperture", OPTIONAL, scene_crack_fluid, least_aperture),
    NUMBER("leak_off", OPTIONAL, scene_crack_fluid, leak_off),
    CYAML_FIELD_MAPPING_PTR("pores", OPTIONAL, struct scene_crack_fluid, pores, pores_fields),
    ENTRIES("injections", LIST, scene_crack_fluid, injection, injections, &injection, 1, LIST_MAX),
    CYAML_FIELD_END};

static const cyaml_schema_field_t arrangement_fields[] = {
    CHOICE("kind", OPTIONAL, scene_nonlocal, arrangement, scene_schema_parts_arrangements),
    NUMBER("perturbation", OPTIONAL, scene_nonlocal, perturbation),
    WHOLE("seed", OPTIONAL, scene_nonlocal, arrangement_seed),
    CHOICE("volume", OPTIONAL, scene_nonlocal, volume, scene_schema_parts_volumes), CYAML_FIELD_END};
static const cyaml_schema_field_t nonlocal_fields[] = {
    WHOLE("dimension", NEEDED, scene_nonlocal, dimension),
    WHOLE("exponent", NEEDED, scene_nonlocal, exponent),
    NUMBER("horizon", NEEDED, scene_nonlocal, horizon),
    NUMBER("inner_radius", NEEDED, scene_nonlocal, inner_radius),
    NUMBER("outer_radius", NEEDED, scene_nonlocal, outer_radius),
    NUMBER("spacing", OPTIONAL, scene_nonlocal, spacing),
    WHOLE("points", OPTIONAL, scene_nonlocal, points),
    PART("arrangement", OPTIONAL, scene_nonlocal, arrangement_fields),
    BOOLEAN("condition", OPTIONAL, scene_nonlocal, condition),
    CYAML_FIELD_END};

static const cyaml_schema_field_t until_fields[] = {
    CHOICE("quantity", OPTIONAL, scene_stage, until_quantity, until_quantities),
    NUMBER("change", OPTIONAL, scene_stage, until_change), WHOLE("window", OPTIONAL, scene_stage, until_window),
    CYAML_FIELD_END};

static const cyaml_schema_field_t stage_fields[] = {
    TEXT("name", NEEDED, scene_stage, name),
    WHOLE("steps", NEEDED, scene_stage, steps),
    PART("until", OPTIONAL, scene_stage, until_fields),
    NUMBER("time_step", OPTIONAL, scene_stage, time_step),
    NUMBER("cfl", OPTIONAL, scene_stage, cfl),
    CHOICE("solid", OPTIONAL, scene_stage, solid, modes),
    BOOLEAN("relax", OPTIONAL, scene_stage, relax),
    NUMBER("increment", OPTIONAL, scene_stage, increment),
    NUMBER("tolerance", OPTIONAL, scene_stage, tolerance),
    CHOICE("integrator", OPTIONAL, scene_stage, integrator, integrators),
    CHOICE("fluid_integrator", OPTIONAL, scene_stage, fluid_integrator, fluid_integrators),
    WHOLE("substeps", OPTIONAL, scene_stage, substeps),
    NUMBER("safety", OPTIONAL, scene_stage, safety),
    BOOLEAN("breakage", OPTIONAL, scene_stage, breakage),
    NUMBER("damping_relative", OPTIONAL, scene_stage, damping_relative),
    NUMBER("damping_absolute", OPTIONAL, scene_stage, damping_absolute),
    BOOLEAN("crack_fluid", OPTIONAL, scene_stage, crack_fluid),
    CYAML_FIELD_END};
static const cyaml_schema_value_t stage = {CYAML_VALUE_MAPPING(NEEDED, struct scene_stage, stage_fields)};

static const cyaml_schema_field_t crack_fields[] = {NUMBER("damage", OPTIONAL, scene_crack_output, damage),
                                                    VECTOR("direction", OPTIONAL, scene_crack_output, direction),
                                                    NUMBER("window", OPTIONAL, scene_crack_output, window),
                                                    WHOLE("every", OPTIONAL, scene_crack_output, every),
                                                    CYAML_FIELD_END};

static const cyaml_schema_value_t place = {CYAML_VALUE_SEQUENCE_FIXED(NEEDED, double, &scene_schema_parts_real, 3)};
static const cyaml_schema_field_t intensity_fields[] = {
    ENTRIES("radii", NEEDED, scene_intensity, radius, radii, &scene_schema_parts_real, 1, LIST_MAX),
    WHOLE("crack", OPTIONAL, scene_intensity, crack), WHOLE("tip", OPTIONAL, scene_intensity, tip),
    WHOLE("every", OPTIONAL, scene_intensity, every), CYAML_FIELD_END};
static const cyaml_schema_field_t modes_fields[] = {
    VECTOR("centre", NEEDED, scene_modes, centre),
    VECTOR("axis", OPTIONAL, scene_modes, axis),
    ENTRIES("radii", NEEDED, scene_modes, radius, radii, &scene_schema_parts_real, 2, LIST_MAX),
    WHOLE("highest", OPTIONAL, scene_modes, highest),
    WHOLE("every", OPTIONAL, scene_modes, every),
    CYAML_FIELD_END};
static const cyaml_schema_field_t probes_fields[] = {
    ENTRIES("at", NEEDED, scene_probes, at, places, &place, 1, LIST_MAX), WHOLE("every", OPTIONAL, scene_probes, every),
    CYAML_FIELD_END};

static const cyaml_schema_field_t line_fields[] = {VECTOR("from", NEEDED, scene_probe_line, from),
                                                   VECTOR("to", NEEDED, scene_probe_line, to),
                                                   WHOLE("points", NEEDED, scene_probe_line, points), CYAML_FIELD_END};
static const cyaml_schema_value_t line = {CYAML_VALUE_MAPPING(NEEDED, struct scene_probe_line, line_fields)};
static const cyaml_schema_field_t fluid_probes_fields[] = {
    ENTRIES("at", LIST, scene_fluid_probes, at, places, &place, 1, LIST_MAX),
    ENTRIES("lines", LIST, scene_fluid_probes, line, lines, &line, 1, LIST_MAX),
    WHOLE("every", OPTIONAL, scene_fluid_probes, every), CYAML_FIELD_END};

static const cyaml_schema_field_t output_fields[] = {
    WHOLE("series_every", OPTIONAL, scene_output, series_every),
    WHOLE("fields_every", OPTIONAL, scene_output, fields_every),
    WHOLE("checkpoint_every", OPTIONAL, scene_output, checkpoint_every),
    WHOLE("log_every", OPTIONAL, scene_output, log_every),
    BOOLEAN("stress", OPTIONAL, scene_output, stress),
    BOOLEAN("fragments", OPTIONAL, scene_output, fragments),
    BOOLEAN("reactions", OPTIONAL, scene_output, reactions),
    BOOLEAN("bodies", OPTIONAL, scene_output, bodies),
    BOOLEAN("events", OPTIONAL, scene_output, events),
    CYAML_FIELD_MAPPING_PTR("crack", OPTIONAL, struct scene_output, crack, crack_fields),
    CYAML_FIELD_MAPPING_PTR("intensity", OPTIONAL, struct scene_output, intensity, intensity_fields),
    CYAML_FIELD_MAPPING_PTR("modes", OPTIONAL, struct scene_output, modes, modes_fields),
    CYAML_FIELD_MAPPING_PTR("probes", OPTIONAL, struct scene_output, probes, probes_fields),
    CYAML_FIELD_MAPPING_PTR("fluid_probes", OPTIONAL, struct scene_output, fluid_probes, fluid_probes_fields),
    CYAML_FIELD_END};

static const cyaml_schema_field_t scene_fields[] = {
    TEXT("title", OPTIONAL, scene, title),
    CYAML_FIELD_MAPPING("domain", OPTIONAL, struct scene, domain, domain_fields),
    CYAML_FIELD_MAPPING_PTR("fluid", OPTIONAL, struct scene, fluid, fluid_fields),
    CYAML_FIELD_MAPPING_PTR("solid", OPTIONAL, struct scene, solid, scene_schema_solid),
    CYAML_FIELD_MAPPING_PTR("coupling", OPTIONAL, struct scene, coupling, coupling_fields),
    CYAML_FIELD_MAPPING_PTR("crack_fluid", OPTIONAL, struct scene, crack_fluid, crack_fluid_fields),
    CYAML_FIELD_MAPPING_PTR("nonlocal", OPTIONAL, struct scene, nonlocal, nonlocal_fields),
    ENTRIES("stages", LIST, scene, stage, stages, &stage, 1, LIST_MAX),
    CYAML_FIELD_MAPPING("output", OPTIONAL, struct scene, output, output_fields),
    CYAML_FIELD_END};

const cyaml_schema_value_t scene_schema = {CYAML_VALUE_MAPPING(CYAML_FLAG_POINTER, struct scene, scene_fields)};

/* Keeps libcyaml's first error as text. */
static void keep_error(cyaml_log_t level, void *context, const char *format, va_list args) {
    char **why = context;
    if (level < CYAML_LOG_ERROR || *why) return;
    if (vasprintf(why, format, args) < 0) *why = NULL;
    if (*why) (*why)[strcspn(*why, "\n")] = '\0';
}

static cyaml_config_t config_of(char **why) {
    return (cyaml_config_t){.log_fn = keep_error,
                            .log_ctx = why,
                            .mem_fn = cyaml_mem,
                            .log_level = CYAML_LOG_ERROR,
                            .flags = CYAML_CFG_NO_ALIAS};
}

struct scene *scene_schema_load(const char *text, char **why) {
    const cyaml_config_t config = config_of(why);
    cyaml_data_t *data = NULL;
    *why = NULL;
    const cyaml_err_t error = cyaml_load_data((const uint8_t *)text, strlen(text), &config, &scene_schema, &data, NULL);
    if (error == CYAML_OK) return (struct scene *)data;
    if (!*why) *why = text_new("%s", cyaml_strerror(error));
    return NULL;
}

void scene_schema_free(struct scene *s) {
    char *why = NULL;
    const cyaml_config_t config = config_of(&why);
    if (s) cyaml_free(&config, &scene_schema, s, 0);
    free(why);
}
