/* libcyaml schema of the scene's section solid. */
#include "physics/limits.h"
#include "scene/rules/schema_parts.h"

static const cyaml_strval_t models[] = {{"plane_stress", SCENE_PLANE_STRESS}, {"plane_strain", SCENE_PLANE_STRAIN}};
static const cyaml_strval_t methods[] = {{"peridynamic", SCENE_PERIDYNAMIC}, {"element_free", SCENE_ELEMENT_FREE}};
static const cyaml_strval_t free_bases[] = {
    {"linear", SCENE_FREE_LINEAR}, {"sqrt_r", SCENE_FREE_SQRT_R}, {"tip", SCENE_FREE_TIP}};
static const cyaml_strval_t free_weights[] = {{"cubic", SCENE_FREE_CUBIC}, {"quartic", SCENE_FREE_QUARTIC}};
static const cyaml_strval_t free_cracks[] = {
    {"virtual", SCENE_FREE_VIRTUAL}, {"diffraction", SCENE_FREE_DIFFRACTION}, {"visibility", SCENE_FREE_VISIBILITY}};
static const cyaml_strval_t free_updates[] = {{"conjugate", SCENE_FREE_CONJUGATE},
                                              {"hestenes_powell", SCENE_FREE_HESTENES_POWELL}};
static const cyaml_strval_t partials[] = {
    {"exact", SCENE_PARTIAL_EXACT}, {"ramp", SCENE_PARTIAL_RAMP}, {"ramp_cut", SCENE_PARTIAL_RAMP_CUT}};
/* false and true: as the key was read before it had words. */
static const cyaml_strval_t corrections[] = {{"none", SCENE_CORRECTION_NONE},
                                             {"volume", SCENE_CORRECTION_VOLUME},
                                             {"energy", SCENE_CORRECTION_ENERGY},
                                             {"false", SCENE_CORRECTION_NONE},
                                             {"true", SCENE_CORRECTION_VOLUME}};
static const cyaml_strval_t precisions[] = {{"double", SCENE_PRECISION_DOUBLE}, {"mixed", SCENE_PRECISION_MIXED}};
static const cyaml_strval_t horizons[] = {{"dual", SCENE_HORIZONS_DUAL}, {"one_sided", SCENE_HORIZONS_ONE_SIDED}};
static const cyaml_strval_t micromoduli[] = {
    {"constant", SCENE_CONSTANT}, {"conical", SCENE_CONICAL}, {"exponential", SCENE_EXPONENTIAL}};
static const cyaml_strval_t shapes[] = {{"box", SCENE_BOX},           {"sphere", SCENE_SPHERE},
                                        {"cylinder", SCENE_CYLINDER}, {"ellipsoid", SCENE_ELLIPSOID},
                                        {"spheres", SCENE_SPHERES},   {"rectangle", SCENE_RECTANGLE},
                                        {"disc", SCENE_DISC},         {"polygon", SCENE_POLYGON},
                                        {"points", SCENE_POINTS},     {"image", SCENE_IMAGE}};
static const cyaml_strval_t part_shapes[] = {{"rectangle", SCENE_RECTANGLE}, {"disc", SCENE_DISC},
                                             {"polygon", SCENE_POLYGON},     {"box", SCENE_BOX},
                                             {"sphere", SCENE_SPHERE},       {"cylinder", SCENE_CYLINDER},
                                             {"ellipsoid", SCENE_ELLIPSOID}, {"spheres", SCENE_SPHERES}};
static const cyaml_strval_t contacts[] = {{"bonded", 0}, {"broken", 1}};
static const cyaml_strval_t image_formats[] = {{"auto", FILES_IMAGE_AUTO}, {"raw", FILES_IMAGE_RAW},
                                               {"mhd", FILES_IMAGE_MHD},   {"nrrd", FILES_IMAGE_NRRD},
                                               {"tiff", FILES_IMAGE_TIFF}, {"hdf5", FILES_IMAGE_HDF5}};
static const cyaml_strval_t image_types[] = {
    {"header", FILES_IMAGE_HEADER},   {"int8", FILES_IMAGE_INT8},      {"uint8", FILES_IMAGE_UINT8},
    {"int16", FILES_IMAGE_INT16},     {"uint16", FILES_IMAGE_UINT16},  {"int32", FILES_IMAGE_INT32},
    {"uint32", FILES_IMAGE_UINT32},   {"int64", FILES_IMAGE_INT64},    {"uint64", FILES_IMAGE_UINT64},
    {"float32", FILES_IMAGE_FLOAT32}, {"float64", FILES_IMAGE_FLOAT64}};
static const cyaml_strval_t image_orders[] = {
    {"header", FILES_IMAGE_ORDER_AUTO}, {"little", FILES_IMAGE_LITTLE}, {"big", FILES_IMAGE_BIG}};
static const cyaml_strval_t image_axes[] = {{"xyz", SCENE_IMAGE_XYZ}, {"xzy", SCENE_IMAGE_XZY},
                                            {"yxz", SCENE_IMAGE_YXZ}, {"yzx", SCENE_IMAGE_YZX},
                                            {"zxy", SCENE_IMAGE_ZXY}, {"zyx", SCENE_IMAGE_ZYX}};
static const cyaml_strval_t floatings[] = {
    {"keep", SCENE_FLOATING_KEEP}, {"remove", SCENE_FLOATING_REMOVE}, {"hold", SCENE_FLOATING_HOLD}};
static const cyaml_strval_t turns[] = {{"straight", 0}, {"left", 1}, {"right", -1}};
static const cyaml_strval_t depths[] = {{"layer", 0}, {"horizon", 1}};
static const cyaml_strval_t initial_shapes[] = {{"gaussian", SCENE_GAUSSIAN}, {"sine", SCENE_SINE}};
static const cyaml_strval_t refined_horizons[] = {{"scaled", 0}, {"kept", 1}};
static const cyaml_strval_t refined_interfaces[] = {{"plain", 0}, {"corrected", 1}};
static const cyaml_strval_t refined_held[] = {{"keep", 0}, {"refine", 1}};

static const cyaml_strval_t breakages[] = {{"brittle", SCENE_BRITTLE}, {"bilinear", SCENE_BILINEAR}};
static const cyaml_schema_field_t breakage_fields[] = {
    CHOICE("law", NEEDED, scene_material, breakage, breakages),
    NUMBER("tensile_strength", OPTIONAL, scene_material, tensile_strength),
    NUMBER("s00", OPTIONAL, scene_material, s00), NUMBER("alpha", OPTIONAL, scene_material, alpha), CYAML_FIELD_END};

static const cyaml_schema_field_t material_fields[] = {
    TEXT("name", NEEDED, scene_material, name),
    NUMBER("youngs_modulus", NEEDED, scene_material, youngs_modulus),
    NUMBER("density", NEEDED, scene_material, density),
    NUMBER("poisson_ratio", OPTIONAL, scene_material, poisson_ratio),
    NUMBER("fracture_energy", OPTIONAL, scene_material, fracture_energy),
    NUMBER("horizon_ratio", OPTIONAL, scene_material, horizon_ratio),
    CHOICE("micromodulus", OPTIONAL, scene_material, micromodulus, micromoduli),
    PART("breakage", OPTIONAL, scene_material, breakage_fields),
    CYAML_FIELD_END};
static const cyaml_schema_value_t material = {CYAML_VALUE_MAPPING(NEEDED, struct scene_material, material_fields)};

static const cyaml_schema_field_t cavity_fields[] = {
    NUMBER("period", NEEDED, scene_body, cavity_period), NUMBER("radius", NEEDED, scene_body, cavity_radius),
    VECTOR("centre", NEEDED, scene_body, cavity_centre), CYAML_FIELD_END};

static const cyaml_schema_field_t arrangement_fields[] = {
    CHOICE("kind", OPTIONAL, scene_body, arrangement, scene_schema_parts_arrangements),
    NUMBER("perturbation", OPTIONAL, scene_body, perturbation), WHOLE("seed", OPTIONAL, scene_body, arrangement_seed),
    CHOICE("volume", OPTIONAL, scene_body, volume, scene_schema_parts_volumes), CYAML_FIELD_END};

static const cyaml_schema_field_t corner_fields[] = {PAIR("at", NEEDED, scene_corner, at),
                                                     CHOICE("turn", OPTIONAL, scene_corner, turn, turns),
                                                     PAIR("centre", OPTIONAL, scene_corner, centre), CYAML_FIELD_END};
static const cyaml_schema_value_t corner = {CYAML_VALUE_MAPPING(NEEDED, struct scene_corner, corner_fields)};

/* The rotation of a box or a region of type; about one axis in a plate. */
static const cyaml_schema_value_t direction = {CYAML_VALUE_SEQUENCE_FIXED(NEEDED, double, &scene_schema_parts_real, 3)};
#define TURN_FIELDS(name, type)                                                                                        \
    static const cyaml_schema_field_t name[] = {                                                                       \
        VECTOR("axis", OPTIONAL, type, turn.axis), NUMBER("angle", OPTIONAL, type, turn.angle),                        \
        CYAML_FIELD_SEQUENCE_FIXED("axes", OPTIONAL, struct type, turn.axes, &direction, 2),                           \
        VECTOR("about", OPTIONAL, type, turn.about), CYAML_FIELD_END}
TURN_FIELDS(part_turn, scene_part);
TURN_FIELDS(body_turn, scene_body);
TURN_FIELDS(constraint_turn, scene_constraint);
TURN_FIELDS(region_turn, scene_region);
TURN_FIELDS(load_turn, scene_load);
#define PLATE_TURN_FIELDS(name, type)                                                                                  \
    static const cyaml_schema_field_t name[] = {NUMBER("angle", NEEDED, type, turn.angle),                             \
                                                VECTOR("about", OPTIONAL, type, turn.about), CYAML_FIELD_END}
PLATE_TURN_FIELDS(refined_turn, scene_refined);
PLATE_TURN_FIELDS(refinement_turn, scene_refinement);

static const cyaml_schema_value_t sphere = {CYAML_VALUE_SEQUENCE_FIXED(NEEDED, double, &scene_schema_parts_real, 4)};

static const cyaml_schema_field_t part_fields[] = {
    CHOICE("shape", NEEDED, scene_part, shape, part_shapes),
    VECTOR("low", OPTIONAL, scene_part, low),
    VECTOR("high", OPTIONAL, scene_part, high),
    VECTOR("centre", OPTIONAL, scene_part, centre),
    NUMBER("radius", OPTIONAL, scene_part, radius),
    VECTOR("radii", OPTIONAL, scene_part, radii),
    NUMBER("length", OPTIONAL, scene_part, length),
    CHOICE("axis", OPTIONAL, scene_part, axis, scene_schema_parts_axes),
    PART("rotation", OPTIONAL, scene_part, part_turn),
    ENTRIES("outline", LIST, scene_part, corner, corners, &corner, 1, LIST_MAX),
    TEXT("file", OPTIONAL, scene_part, file),
    ENTRIES("spheres", LIST, scene_part, sphere, spheres, &sphere, 1, LIST_MAX),
    CYAML_FIELD_END};
static const cyaml_schema_value_t part = {CYAML_VALUE_MAPPING(NEEDED, struct scene_part, part_fields)};

static const cyaml_schema_value_t whole = {CYAML_VALUE_INT(NEEDED, int)};
#define VOXELS(key, flags, type, member) CYAML_FIELD_SEQUENCE_FIXED(key, flags, struct type, member, &whole, 3)
static const cyaml_schema_field_t crop_fields[] = {VOXELS("low", NEEDED, scene_body, image.crop_low),
                                                   VOXELS("high", NEEDED, scene_body, image.crop_high),
                                                   CYAML_FIELD_END};

static const cyaml_schema_field_t image_material_fields[] = {WHOLE("label", NEEDED, scene_image_material, label),
                                                             TEXT("material", NEEDED, scene_image_material, material),
                                                             CYAML_FIELD_END};
static const cyaml_schema_value_t image_material = {
    CYAML_VALUE_MAPPING(NEEDED, struct scene_image_material, image_material_fields)};

static const cyaml_schema_field_t body_fields[] = {
    TEXT("name", OPTIONAL, scene_body, name),
    TEXT("material", OPTIONAL, scene_body, material),
    CHOICE("shape", NEEDED, scene_body, shape, shapes),
    VECTOR("low", OPTIONAL, scene_body, low),
    VECTOR("high", OPTIONAL, scene_body, high),
    VECTOR("centre", OPTIONAL, scene_body, centre),
    NUMBER("radius", OPTIONAL, scene_body, radius),
    VECTOR("radii", OPTIONAL, scene_body, radii),
    NUMBER("length", OPTIONAL, scene_body, length),
    CHOICE("axis", OPTIONAL, scene_body, axis, scene_schema_parts_axes),
    PART("rotation", OPTIONAL, scene_body, body_turn),
    ENTRIES("outline", LIST, scene_body, corner, corners, &corner, 1, LIST_MAX),
    ENTRIES("pieces", LIST, scene_body, piece, pieces, &part, 1, LIST_MAX),
    ENTRIES("holes", LIST, scene_body, hole, holes, &part, 1, LIST_MAX),
    TEXT("file", OPTIONAL, scene_body, file),
    ENTRIES("spheres", LIST, scene_body, sphere, spheres, &sphere, 1, LIST_MAX),
    CHOICE("contacts", OPTIONAL, scene_body, contacts_broken, contacts),
    VECTOR("velocity", OPTIONAL, scene_body, velocity),
    PART("cavities", OPTIONAL, scene_body, cavity_fields),
    PART("arrangement", OPTIONAL, scene_body, arrangement_fields),
    CHOICE("format", OPTIONAL, scene_body, image.format, image_formats),
    TEXT("dataset", OPTIONAL, scene_body, image.dataset),
    VOXELS("size", OPTIONAL, scene_body, image.size),
    CHOICE("type", OPTIONAL, scene_body, image.type, image_types),
    CHOICE("byte_order", OPTIONAL, scene_body, image.byte_order, image_orders),
    CHOICE("axes", OPTIONAL, scene_body, image.axes, image_axes),
    WHOLE("header_bytes", OPTIONAL, scene_body, image.header_bytes),
    NUMBER("voxel", OPTIONAL, scene_body, image.voxel),
    PART("crop", OPTIONAL, scene_body, crop_fields),
    ENTRIES("solid", LIST, scene_body, image.label, image.labels, &whole, 1, LIST_MAX),
    ENTRIES("materials", LIST, scene_body, image.material, image.materials, &image_material, 1, LIST_MAX),
    NUMBER("threshold", OPTIONAL, scene_body, image.threshold),
    TEXT("flip", OPTIONAL, scene_body, image.flip),
    TEXT("mirror", OPTIONAL, scene_body, image.mirror),
    CHOICE("floating", OPTIONAL, scene_body, image.floating, floatings),
    CYAML_FIELD_END};
static const cyaml_schema_value_t body = {CYAML_VALUE_MAPPING(NEEDED, struct scene_body, body_fields)};

static const cyaml_schema_value_t name_of_body = {CYAML_VALUE_STRING(NEEDED, char[SCENE_NAME], 1, SCENE_NAME - 1)};
static const cyaml_schema_field_t interface_fields[] = {
    CYAML_FIELD_SEQUENCE_FIXED("between", NEEDED, struct scene_interface, between, &name_of_body, 2),
    NUMBER("fracture_energy", NEEDED, scene_interface, fracture_energy), CYAML_FIELD_END};
static const cyaml_schema_value_t interface = {CYAML_VALUE_MAPPING(NEEDED, struct scene_interface, interface_fields)};

static const cyaml_schema_value_t triple = {CYAML_VALUE_SEQUENCE_FIXED(NEEDED, double, &scene_schema_parts_real, 3)};
static const cyaml_schema_value_t pair = {CYAML_VALUE_SEQUENCE_FIXED(NEEDED, double, &scene_schema_parts_real, 2)};

static const cyaml_schema_field_t crack_fields[] = {
    TEXT("name", OPTIONAL, scene_crack, name),
    ENTRIES("points", NEEDED, scene_crack, point, points, &triple, 2, LIST_MAX), CYAML_FIELD_END};
static const cyaml_schema_value_t crack = {CYAML_VALUE_MAPPING(NEEDED, struct scene_crack, crack_fields)};

#define TIME(type) ENTRIES("time", LIST, type, time.point, time.n, &pair, 1, LIST_MAX)
static const cyaml_schema_field_t constraint_fields[] = {
    VECTOR("low", NEEDED, scene_constraint, low),
    VECTOR("high", NEEDED, scene_constraint, high),
    PART("rotation", OPTIONAL, scene_constraint, constraint_turn),
    TEXT("directions", OPTIONAL, scene_constraint, directions),
    VECTOR("velocity", OPTIONAL, scene_constraint, velocity),
    VECTOR("displacement", OPTIONAL, scene_constraint, displacement),
    TIME(scene_constraint),
    CYAML_FIELD_END};
static const cyaml_schema_value_t constraint = {
    CYAML_VALUE_MAPPING(NEEDED, struct scene_constraint, constraint_fields)};

static const cyaml_schema_field_t region_fields[] = {
    VECTOR("low", NEEDED, scene_region, low), VECTOR("high", NEEDED, scene_region, high),
    PART("rotation", OPTIONAL, scene_region, region_turn), CYAML_FIELD_END};
static const cyaml_schema_value_t region = {CYAML_VALUE_MAPPING(NEEDED, struct scene_region, region_fields)};

static const cyaml_schema_field_t edge_fields[] = {PAIR("from", NEEDED, scene_load, edge[0]),
                                                   PAIR("to", NEEDED, scene_load, edge[1]), CYAML_FIELD_END};
static const cyaml_schema_field_t load_fields[] = {VECTOR("low", OPTIONAL, scene_load, low),
                                                   VECTOR("high", OPTIONAL, scene_load, high),
                                                   PART("rotation", OPTIONAL, scene_load, load_turn),
                                                   VECTOR("force", OPTIONAL, scene_load, force),
                                                   PART("edge", OPTIONAL, scene_load, edge_fields),
                                                   VECTOR("traction", OPTIONAL, scene_load, traction),
                                                   CHOICE("depth", OPTIONAL, scene_load, over_horizon, depths),
                                                   TIME(scene_load),
                                                   CYAML_FIELD_END};
static const cyaml_schema_value_t load = {CYAML_VALUE_MAPPING(NEEDED, struct scene_load, load_fields)};

static const cyaml_schema_field_t initial_fields[] = {
    CHOICE("shape", NEEDED, scene_initial, shape, initial_shapes),
    CHOICE("along", NEEDED, scene_initial, along, scene_schema_parts_axes),
    NUMBER("centre", NEEDED, scene_initial, centre),
    NUMBER("width", NEEDED, scene_initial, width),
    VECTOR("displacement", NEEDED, scene_initial, displacement),
    CYAML_FIELD_END};
static const cyaml_schema_value_t initial = {CYAML_VALUE_MAPPING(NEEDED, struct scene_initial, initial_fields)};

static const cyaml_strval_t indenter_shapes[] = {{"sphere", SCENE_INDENTER_SPHERE}};
static const cyaml_schema_field_t indenter_fields[] = {CHOICE("shape", NEEDED, scene_indenter, shape, indenter_shapes),
                                                       VECTOR("centre", NEEDED, scene_indenter, centre),
                                                       NUMBER("radius", NEEDED, scene_indenter, radius),
                                                       VECTOR("velocity", OPTIONAL, scene_indenter, velocity),
                                                       NUMBER("stiffness", NEEDED, scene_indenter, stiffness),
                                                       CYAML_FIELD_END};
static const cyaml_schema_value_t indenter = {CYAML_VALUE_MAPPING(NEEDED, struct scene_indenter, indenter_fields)};

static const cyaml_schema_field_t start_fields[] = {VECTOR("low", NEEDED, scene_refined, low),
                                                    VECTOR("high", NEEDED, scene_refined, high),
                                                    PART("rotation", OPTIONAL, scene_refined, refined_turn),
                                                    WHOLE("level", NEEDED, scene_refined, level), CYAML_FIELD_END};
static const cyaml_schema_value_t start = {CYAML_VALUE_MAPPING(NEEDED, struct scene_refined, start_fields)};

static const cyaml_schema_field_t refinement_fields[] = {
    WHOLE("levels", OPTIONAL, scene_refinement, levels),
    NUMBER("energy", OPTIONAL, scene_refinement, energy),
    NUMBER("damage", OPTIONAL, scene_refinement, damage),
    NUMBER("from", OPTIONAL, scene_refinement, from),
    VECTOR("low", OPTIONAL, scene_refinement, low),
    VECTOR("high", OPTIONAL, scene_refinement, high),
    PART("rotation", OPTIONAL, scene_refinement, refinement_turn),
    WHOLE("every", OPTIONAL, scene_refinement, every),
    CHOICE("horizon", OPTIONAL, scene_refinement, horizon_kept, refined_horizons),
    CHOICE("interface", OPTIONAL, scene_refinement, interface_corrected, refined_interfaces),
    CHOICE("held", OPTIONAL, scene_refinement, held_refine, refined_held),
    ENTRIES("start", LIST, scene_refinement, start, starts, &start, 1, LIST_MAX),
    CYAML_FIELD_END};

static const cyaml_schema_field_t contact_fields[] = {
    BOOLEAN("enabled", OPTIONAL, scene_solid, contact), NUMBER("stiffness", OPTIONAL, scene_solid, contact_stiffness),
    NUMBER("exponent", OPTIONAL, scene_solid, contact_exponent),
    NUMBER("radius", OPTIONAL, scene_solid, contact_radius), CYAML_FIELD_END};

static const cyaml_schema_field_t growth_fields[] = {NUMBER("step", NEEDED, scene_growth, step),
                                                     WHOLE("steps", OPTIONAL, scene_growth, steps),
                                                     NUMBER("until", OPTIONAL, scene_growth, until),
                                                     NUMBER("radius", OPTIONAL, scene_growth, radius),
                                                     NUMBER("toughness", OPTIONAL, scene_growth, toughness),
                                                     CYAML_FIELD_END};

static const cyaml_schema_field_t element_free_fields[] = {
    CHOICE("basis", OPTIONAL, scene_element_free, basis, free_bases),
    CHOICE("weight", OPTIONAL, scene_element_free, weight, free_weights),
    NUMBER("support", OPTIONAL, scene_element_free, support),
    NUMBER("tip_radius", OPTIONAL, scene_element_free, tip_radius),
    WHOLE("tip_levels", OPTIONAL, scene_element_free, tip_levels),
    NUMBER("tip_patch", OPTIONAL, scene_element_free, tip_patch),
    CYAML_FIELD_SEQUENCE_FIXED("cells", OPTIONAL, struct scene_element_free, cells, &whole, 2),
    WHOLE("gauss", OPTIONAL, scene_element_free, gauss),
    WHOLE("gauss_tip", OPTIONAL, scene_element_free, gauss_tip),
    CHOICE("crack", OPTIONAL, scene_element_free, crack, free_cracks),
    NUMBER("interface_spacing", OPTIONAL, scene_element_free, interface_spacing),
    NUMBER("penalty", OPTIONAL, scene_element_free, penalty),
    NUMBER("tolerance", OPTIONAL, scene_element_free, tolerance),
    WHOLE("iterations", OPTIONAL, scene_element_free, iterations),
    CHOICE("update", OPTIONAL, scene_element_free, update, free_updates),
    CYAML_FIELD_MAPPING_PTR("growth", OPTIONAL, struct scene_element_free, growth, growth_fields),
    CYAML_FIELD_END};

const cyaml_schema_field_t scene_schema_solid[] = {
    NUMBER("spacing", OPTIONAL, scene_solid, spacing),
    CHOICE("model", OPTIONAL, scene_solid, model, models),
    CHOICE("method", OPTIONAL, scene_solid, method, methods),
    CYAML_FIELD_MAPPING_PTR("element_free", OPTIONAL, struct scene_solid, element_free, element_free_fields),
    NUMBER("thickness", OPTIONAL, scene_solid, thickness),
    VECTOR("lattice_offset", OPTIONAL, scene_solid, lattice_offset),
    CHOICE("partial_volume", OPTIONAL, scene_solid, partial_volume, partials),
    CHOICE("horizons", OPTIONAL, scene_solid, horizons, horizons),
    ENTRIES("materials", NEEDED, scene_solid, material, materials, &material, 1, PHYSICS_BODIES_MAX),
    ENTRIES("bodies", NEEDED, scene_solid, body, bodies, &body, 1, PHYSICS_BODIES_MAX),
    ENTRIES("interfaces", LIST, scene_solid, interface, interfaces, &interface, 0, LIST_MAX),
    ENTRIES("cracks", LIST, scene_solid, crack, cracks, &crack, 0, LIST_MAX),
    ENTRIES("constraints", LIST, scene_solid, constraint, constraints, &constraint, 0, LIST_MAX),
    ENTRIES("unbreakable", LIST, scene_solid, unbreakable, unbreakables, &region, 0, LIST_MAX),
    ENTRIES("loads", LIST, scene_solid, load, loads, &load, 0, LIST_MAX),
    ENTRIES("initial", LIST, scene_solid, initial, initials, &initial, 0, LIST_MAX),
    ENTRIES("indenters", LIST, scene_solid, indenter, indenters, &indenter, 0, LIST_MAX),
    CYAML_FIELD_MAPPING_PTR("refinement", OPTIONAL, struct scene_solid, refinement, refinement_fields),
    CHOICE("surface_correction", OPTIONAL, scene_solid, surface_correction, corrections),
    CHOICE("precision", OPTIONAL, scene_solid, precision, precisions),
    VECTOR("body_force", OPTIONAL, scene_solid, body_force),
    PART("contact", OPTIONAL, scene_solid, contact_fields),
    CYAML_FIELD_END};
