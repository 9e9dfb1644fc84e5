/* Keys of the section solid. */
#include "physics/limits.h"
#include "scene/keys/table.h"

static const struct scene_word models[] = {WORD("plane_stress", PHYSICS_PLANE_STRESS),
                                           WORD("plane_strain", PHYSICS_PLANE_STRAIN)};
static const struct scene_word methods[] = {WORD("peridynamic", SCENE_PERIDYNAMIC),
                                            WORD("element_free", SCENE_ELEMENT_FREE)};
static const struct scene_word partials[] = {WORD("exact", SOLID_PARTIAL_EXACT),
                                             WORD("ramp", SOLID_PARTIAL_RAMP, .only = PLATE),
                                             WORD("ramp_cut", SOLID_PARTIAL_RAMP_CUT)};
/* false and true: as the key was read before it had words. */
static const struct scene_word corrections[] = {
    WORD("none", SOLID_CORRECTION_NONE), WORD("volume", SOLID_CORRECTION_VOLUME),
    WORD("energy", SOLID_CORRECTION_ENERGY), WORD("false", SOLID_CORRECTION_NONE),
    WORD("true", SOLID_CORRECTION_VOLUME)};
static const struct scene_word precisions[] = {WORD("double", SOLID_DOUBLE), WORD("mixed", SOLID_MIXED)};
static const struct scene_word horizons[] = {WORD("dual", SOLID_DUAL_HORIZON), WORD("one_sided", SOLID_ONE_SIDED)};
static const struct scene_word micromoduli[] = {WORD("constant", PHYSICS_CONSTANT), WORD("conical", PHYSICS_CONICAL),
                                                WORD("exponential", PHYSICS_EXPONENTIAL)};
static const struct scene_word breakages[] = {WORD("brittle", SCENE_BRITTLE), WORD("bilinear", SCENE_BILINEAR)};
static const struct scene_word depths[] = {WORD("layer", 0), WORD("horizon", 1)};
static const struct scene_word initial_shapes[] = {WORD("gaussian", SOLID_GAUSSIAN), WORD("sine", SOLID_SINE)};
static const struct scene_word initial_axes[] = {WORD("x", 0), WORD("y", 1), WORD("z", 2, .only = SPACE)};
static const struct scene_word indenter_shapes[] = {WORD("sphere", SCENE_INDENTER_SPHERE)};

/* clang-format off */
#define OF scene_material
static const struct scene_key breakage[] = {
    KEY("law", CHOICE(breakage, breakages), "choice", NEEDED),
    KEY("tensile_strength", NUMBER(tensile_strength), "Pa", ABOVE(0), WHERE("law", "bilinear")),
    KEY("s00", NUMBER(s00), "1", ABOVE(0), WHERE("law", "brittle"), WITH("alpha")),
    KEY("alpha", NUMBER(alpha), "1", FROM(0), WHERE("law", "brittle"), WITH("s00")),
    END};
static const struct scene_key materials[] = {
    KEY("name", TEXT(name), "text", NEEDED),
    KEY("youngs_modulus", NUMBER(youngs_modulus), "Pa", NEEDED, ABOVE(0)),
    KEY("density", NUMBER(density), "kg/m3", NEEDED, ABOVE(0)),
    KEY("poisson_ratio", NUMBER(poisson_ratio), "1", NEEDED_IN(GALERKIN), WITHIN(-1, 0.5), WITHOUT_ENDS),
    KEY("fracture_energy", NUMBER(fracture_energy), "J/m2", DEFAULT(".inf"), ABOVE(0), OR(".inf", INFINITY),
        NOT_WITH("toughness")),
    KEY("toughness", NUMBER(toughness), "Pa m^(1/2)", ABOVE(0)),
    KEY("tensile_strength", NUMBER(strength), "Pa", ABOVE(0), ONLY(STEPPED)),
    KEY("horizon_ratio", NUMBER(horizon_ratio), "1", DEFAULT("3"), WITHIN(1, SCENE_HORIZON_MAX), WITHOUT_HIGH,
        .plate_high = SCENE_HORIZON_MAX_PLATE, ONLY(STEPPED)),
    KEY("micromodulus", CHOICE(micromodulus, micromoduli), "choice", DEFAULT("constant"), ONLY(STEPPED)),
    KEY("breakage", PART(breakage), "section", ONLY(STEPPED)),
    END};
#undef OF
ENTRY(material, scene_material, materials);

#define OF scene_interface
static const struct scene_value name_of_body = {
    .type = SCENE_TEXT, .bytes = SCENE_NAME, .least = 1, .most = SCENE_NAME - 1};
static const struct scene_key interfaces[] = {
    KEY("between", VECTOR_OF(2, name_of_body, between), "text", NEEDED),
    KEY("fracture_energy", NUMBER(fracture_energy), "J/m2", NEEDED, ABOVE(0), OR(".inf", INFINITY)),
    END};
#undef OF
ENTRY(interface, scene_interface, interfaces);

#define OF scene_crack
static const struct scene_key cracks[] = {
    KEY("name", TEXT(name), "text"),
    KEY("points", LIST(scene_table_triple, point, points, 2, LIST_MAX), "m", NEEDED),
    END};
#undef OF
ENTRY(crack, scene_crack, cracks);

#define REGION                                                                                                         \
    KEY("low", VECTOR(low), "m", NEEDED),                                                                              \
    KEY("high", VECTOR(high), "m", NEEDED),                                                                            \
    KEY("rotation", INNER(turn, scene_table_rotation), "section")
#define TIME                                                                                                           \
    KEY("time", LIST(scene_table_pair, time.point, time.n, 1, LIST_MAX), "s, 1", ONLY(STEPPED)),             \
    KEY("time_from", TEXT(time.from), "text", WITH("time"), ONLY(STEPPED))

#define OF scene_constraint
static const struct scene_key constraints[] = {
    REGION,
    KEY("directions", TEXT(directions), "text", DEFAULT("xyz"), .in_plate = "xy"),
    KEY("velocity", VECTOR(velocity), "m/s", DEFAULT("[0, 0, 0]"), NOT_WITH("displacement"), ONLY(STEPPED)),
    KEY("displacement", VECTOR(displacement), "m"),
    TIME,
    END};
#undef OF
ENTRY(constraint, scene_constraint, constraints);

#define OF scene_region
static const struct scene_key regions[] = {REGION, END};
#undef OF
ENTRY(region, scene_region, regions);

#define OF scene_load
static const struct scene_key edge[] = {
    KEY("from", PAIR(edge[0]), "m", NEEDED),
    KEY("to", PAIR(edge[1]), "m", NEEDED),
    END};
static const struct scene_key loads[] = {
    KEY("low", VECTOR(low), "m", NEEDED, NOT_WITH("edge"), ONLY(STEPPED)),
    KEY("high", VECTOR(high), "m", NEEDED, NOT_WITH("edge"), ONLY(STEPPED)),
    KEY("rotation", INNER(turn, scene_table_rotation), "section", NOT_WITH("edge")),
    KEY("force", VECTOR(force), "N/m3", NEEDED, NOT_WITH("edge"), ONLY(STEPPED)),
    KEY("edge", PART(edge), "section", NEEDED_IN(GALERKIN), ONLY(PLATE)),
    KEY("traction", VECTOR(traction), "Pa", NEEDED, WITH("edge")),
    KEY("depth", CHOICE(over_horizon, depths), "choice", DEFAULT("layer"), WITH("edge"), ONLY(STEPPED)),
    TIME,
    END};
#undef OF
ENTRY(load, scene_load, loads);

#define OF scene_initial
static const struct scene_key initials[] = {
    KEY("shape", CHOICE(shape, initial_shapes), "choice", NEEDED),
    KEY("along", CHOICE(along, initial_axes), "choice", NEEDED),
    KEY("centre", NUMBER(centre), "m", NEEDED),
    KEY("width", NUMBER(width), "m", NEEDED, ABOVE(0)),
    KEY("displacement", VECTOR(displacement), "m", NEEDED),
    END};
#undef OF
ENTRY(initial, scene_initial, initials);

#define OF scene_indenter
static const struct scene_key indenters[] = {
    KEY("shape", CHOICE(shape, indenter_shapes), "choice", NEEDED),
    KEY("centre", VECTOR(centre), "m", NEEDED),
    KEY("radius", NUMBER(radius), "m", NEEDED, ABOVE(0)),
    KEY("velocity", VECTOR(velocity), "m/s", DEFAULT("[0, 0, 0]")),
    KEY("stiffness", NUMBER(stiffness), "N/m5", NEEDED, ABOVE(0)),
    END};
#undef OF
ENTRY(indenter, scene_indenter, indenters);
ENTRY(body, scene_body, scene_table_body);

#define OF scene_solid
static const struct scene_key contact[] = {
    KEY("enabled", SWITCH(contact), "bool", DEFAULT("true")),
    KEY("stiffness", NUMBER(contact_stiffness), "1", DEFAULT("15"), ABOVE(0)), /* k_c/c0: from the EMU Theory Manual */
    KEY("exponent", NUMBER(contact_exponent), "1", DEFAULT("1"), ABOVE(0)),
    KEY("radius", NUMBER(contact_radius), "1", DEFAULT("1"), ABOVE(0)),
    END};
const struct scene_key scene_table_solid[] = {
    KEY("spacing", NUMBER(spacing), "m", ABOVE(0)),
    KEY("model", CHOICE(model, models), "choice", NEEDED_IN(PLATE), ONLY(PLATE)),
    KEY("method", CHOICE(method, methods), "choice", DEFAULT("peridynamic"), ONLY(PLATE)),
    KEY("element_free", SECTION(element_free, scene_table_element_free), "section", DEFAULT("{}"),
        WHERE("method", "element_free")),
    KEY("thickness", NUMBER(thickness), "m", DEFAULT("1"), ABOVE(0), ONLY(PLATE)),
    KEY("lattice_offset", VECTOR(lattice_offset), "spacings", DEFAULT("[0, 0, 0]"), WITHIN(-1, 1)),
    KEY("partial_volume", CHOICE(partial_volume, partials), "choice", DEFAULT("exact"), ONLY(STEPPED)),
    KEY("horizons", CHOICE(horizons, horizons), "choice", DEFAULT("dual"), ONLY(STEPPED)),
    KEY("materials", LIST(material, material, materials, 1, PHYSICS_BODIES_MAX), "list", NEEDED),
    KEY("bodies", LIST(body, body, bodies, 1, PHYSICS_BODIES_MAX), "list", NEEDED),
    KEY("interfaces", LIST(interface, interface, interfaces, 0, LIST_MAX), "list"),
    KEY("cracks", LIST(crack, crack, cracks, 0, LIST_MAX), "list"),
    KEY("constraints", LIST(constraint, constraint, constraints, 0, LIST_MAX), "list"),
    KEY("unbreakable", LIST(region, unbreakable, unbreakables, 0, LIST_MAX), "list", ONLY(STEPPED)),
    KEY("loads", LIST(load, load, loads, 0, LIST_MAX), "list"),
    KEY("initial", LIST(initial, initial, initials, 0, LIST_MAX), "list", ONLY(STEPPED)),
    KEY("indenters", LIST(indenter, indenter, indenters, 0, LIST_MAX), "list", ONLY(STEPPED)),
    KEY("refinement", SECTION(refinement, scene_table_refinement), "section", ONLY(PLATE | STEPPED)),
    KEY("surface_correction", CHOICE(surface_correction, corrections), "choice", DEFAULT("energy"), ONLY(STEPPED)),
    KEY("precision", CHOICE(precision, precisions), "choice", DEFAULT("double"), ONLY(STEPPED)),
    KEY("body_force", VECTOR(body_force), "m/s2", DEFAULT("[0, 0, 0]")),
    KEY("contact", PART(contact), "section", DEFAULT("{}"), ONLY(STEPPED)),
    END};
#undef OF
/* clang-format on */
