/* Keys of solid.bodies: shapes with their pieces and holes, rotations, arrangements of particles, images. */
#include "scene/keys/table.h"

/* Each word of a shape names the keys that it takes: those with BY_SHAPE. Pieces and holes have all but the last two.
 */
#define PIECE " pieces holes arrangement"
#define SOLID_PIECE PIECE " contacts cavities"
#define IN_SPACE(constant, its_word, keys) WORD(#its_word, SOLID_##constant, .only = SPACE, .takes = keys SOLID_PIECE),
#define AND_ONE(...) +1
static const struct scene_word shapes[] = {
    SOLID_LATTICE_SHAPES(IN_SPACE) /* and: */
    WORD("rectangle", SOLID_RECTANGLE, .only = PLATE, .takes = "low high rotation" PIECE),
    WORD("disc", SOLID_DISC, .only = PLATE, .takes = "centre radius" PIECE),
    WORD("polygon", SOLID_POLYGON, .only = PLATE, .takes = "outline" PIECE),
    WORD("points", SOLID_POINTS, .takes = "file arrangement"),
    WORD("image", SOLID_IMAGE, .only = SPACE, .takes = "low file")};
enum { PIECES = SOLID_LATTICE_SHAPES(AND_ONE) + 3 /* of plates */ };
static const struct scene_word turns[] = {WORD("straight", 0), WORD("left", 1), WORD("right", -1)};
static const struct scene_word contacts[] = {WORD("bonded", 0), WORD("broken", 1)};
static const struct scene_word image_formats[] = {WORD("auto", FILES_IMAGE_AUTO), WORD("raw", FILES_IMAGE_RAW),
                                                  WORD("mhd", FILES_IMAGE_MHD),   WORD("nrrd", FILES_IMAGE_NRRD),
                                                  WORD("tiff", FILES_IMAGE_TIFF), WORD("hdf5", FILES_IMAGE_HDF5),
                                                  WORD("npy", FILES_IMAGE_NPY),   WORD("stl", FILES_IMAGE_STL)};
static const struct scene_word image_types[] = {
    WORD("header", FILES_IMAGE_HEADER),   WORD("int8", FILES_IMAGE_INT8),      WORD("uint8", FILES_IMAGE_UINT8),
    WORD("int16", FILES_IMAGE_INT16),     WORD("uint16", FILES_IMAGE_UINT16),  WORD("int32", FILES_IMAGE_INT32),
    WORD("uint32", FILES_IMAGE_UINT32),   WORD("int64", FILES_IMAGE_INT64),    WORD("uint64", FILES_IMAGE_UINT64),
    WORD("float32", FILES_IMAGE_FLOAT32), WORD("float64", FILES_IMAGE_FLOAT64)};
static const struct scene_word image_orders[] = {WORD("header", FILES_IMAGE_ORDER_AUTO),
                                                 WORD("little", FILES_IMAGE_LITTLE), WORD("big", FILES_IMAGE_BIG)};
static const struct scene_word image_axes[] = {WORD("xyz", SCENE_IMAGE_XYZ), WORD("xzy", SCENE_IMAGE_XZY),
                                               WORD("yxz", SCENE_IMAGE_YXZ), WORD("yzx", SCENE_IMAGE_YZX),
                                               WORD("zxy", SCENE_IMAGE_ZXY), WORD("zyx", SCENE_IMAGE_ZYX)};
static const struct scene_word floatings[] = {WORD("keep", SCENE_FLOATING_KEEP), WORD("remove", SCENE_FLOATING_REMOVE),
                                              WORD("hold", SCENE_FLOATING_HOLD)};

/* clang-format off */
#define OF scene_corner
static const struct scene_key corners[] = {
    KEY("at", PAIR(at), "m", NEEDED),
    KEY("turn", CHOICE(turn, turns), "choice", DEFAULT("straight")),
    KEY("centre", PAIR(centre), "m", NEEDED, WHERE("turn", "left right")),
    END};
#undef OF
ENTRY(corner, scene_corner, corners);

static const struct scene_value sphere = {
    .type = SCENE_VECTOR, .bytes = sizeof(double[4]), .least = 4, .most = 4, .entry = &scene_table_number};

/* A body and its pieces and holes have the same keys of shapes: of the body's member part, and of struct scene_part. */
#define SHAPE_KEYS(part)                                                                                               \
    KEY("low", VECTOR(part low), "m", NEEDED, BY_SHAPE),                                                               \
    KEY("high", VECTOR(part high), "m", NEEDED, BY_SHAPE),                                                             \
    KEY("centre", VECTOR(part centre), "m", NEEDED, BY_SHAPE),                                                         \
    KEY("radius", NUMBER(part radius), "m", NEEDED, ABOVE(0), BY_SHAPE),                                               \
    KEY("radii", VECTOR(part radii), "m", NEEDED, ABOVE(0), BY_SHAPE),                                                 \
    KEY("length", NUMBER(part length), "m", NEEDED, ABOVE(0), BY_SHAPE),                                               \
    KEY("axis", CHOICE(part axis, scene_table_axes), "choice", DEFAULT("z"), BY_SHAPE),                                \
    KEY("rotation", INNER(part turn, scene_table_rotation), "section", BY_SHAPE),                                      \
    KEY("outline", LIST(corner, part corner, part corners, 1, LIST_MAX), "list", NEEDED, BY_SHAPE, .bare = "at")
#define SHAPE_LISTS(part)                                                                                              \
    KEY("file", TEXT(part file), "file", NEEDED, BY_SHAPE, NOT_WITH("spheres")),                                       \
    KEY("spheres", LIST(sphere, part sphere, part spheres, 1, LIST_MAX), "m", BY_SHAPE, NOT_WITH("file"))

#define OF scene_part
static const struct scene_key parts[] = {
    KEY("shape", AT(shape, .type = SCENE_CHOICE, .words = shapes, .most = PIECES), "choice", NEEDED),
    SHAPE_KEYS(),
    SHAPE_LISTS(),
    END};
#undef OF
ENTRY(part, scene_part, parts);

#define OF scene_image_material
static const struct scene_key image_materials[] = {
    KEY("label", WHOLE(label), "1", NEEDED),
    KEY("material", TEXT(material), "text", NEEDED),
    END};
#undef OF
ENTRY(image_material, scene_image_material, image_materials);

#define OF scene_body
#define VOXELS(member) VECTOR_OF(3, scene_table_whole, member)
static const struct scene_key crop[] = {
    KEY("low", VOXELS(image.crop_low), "voxels", NEEDED, WITHIN(0, CELLS_MAX)),
    KEY("high", VOXELS(image.crop_high), "voxels", NEEDED, WITHIN(1, CELLS_MAX)),
    END};
static const struct scene_key cavities[] = {
    KEY("period", NUMBER(cavity_period), "m", NEEDED, ABOVE(0)),
    KEY("radius", NUMBER(cavity_radius), "m", NEEDED, ABOVE(0)),
    KEY("centre", VECTOR(cavity_centre), "m", NEEDED),
    END};
#define IMAGE WHERE("shape", "image")
const struct scene_key scene_table_body[] = {
    KEY("name", TEXT(name), "text"),
    KEY("material", TEXT(material), "text", NOT_WITH("materials")),
    KEY("shape", CHOICE(own.shape, shapes), "choice", NEEDED),
    SHAPE_KEYS(own.),
    KEY("pieces", LIST(part, piece, pieces, 1, LIST_MAX), "list", BY_SHAPE, ONLY(STEPPED)),
    KEY("holes", LIST(part, hole, holes, 1, LIST_MAX), "list", BY_SHAPE),
    SHAPE_LISTS(own.),
    KEY("contacts", CHOICE(contacts_broken, contacts), "choice", DEFAULT("bonded"), BY_SHAPE),
    KEY("velocity", VECTOR(velocity), "m/s", DEFAULT("[0, 0, 0]"), ONLY(STEPPED)),
    KEY("cavities", PART(cavities), "section", BY_SHAPE),
    KEY("arrangement", INNER(arrangement, scene_table_arrangement), "section", BY_SHAPE),
    KEY("format", CHOICE(image.format, image_formats), "choice", DEFAULT("auto"), IMAGE),
    /* what the file's own header does not tell: HDF5 with several datasets; raw files of other programs */
    KEY("dataset", TEXT(image.dataset), "text", WHERE("format", "auto hdf5")),
    KEY("size", VOXELS(image.size), "voxels", WITHIN(1, CELLS_MAX), IMAGE),
    KEY("type", CHOICE(image.type, image_types), "choice", DEFAULT("header"), IMAGE),
    KEY("byte_order", CHOICE(image.byte_order, image_orders), "choice", DEFAULT("header"), IMAGE),
    KEY("axes", CHOICE(image.axes, image_axes), "choice", DEFAULT("xyz"), IMAGE),
    KEY("header_bytes", WHOLE(image.header_bytes), "bytes", FROM(0), WHERE("format", "auto raw")),
    KEY("voxel", NUMBER_OR_VECTOR(image.voxel), "m", ABOVE(0), IMAGE),
    KEY("unit", NUMBER(image.unit), "m", ABOVE(0), WHERE("format", "auto stl")),
    KEY("crop", PART(crop), "section", IMAGE),
    KEY("solid", LIST(scene_table_whole, image.label, image.labels, 1, LIST_MAX), "list", NEEDED, IMAGE,
        NOT_WITH("threshold")),
    KEY("materials", LIST(image_material, image.material, image.materials, 1, LIST_MAX), "list", IMAGE,
        NOT_WITH("threshold"), .named = {"label", "material"}),
    KEY("threshold", NUMBER(image.threshold), "1", IMAGE),
    /* images of other programs count from another corner; a mirrored image is periodic */
    KEY("flip", TEXT(image.flip), "text", IMAGE),
    KEY("mirror", TEXT(image.mirror), "text", IMAGE),
    KEY("floating", CHOICE(image.floating, floatings), "choice", DEFAULT("keep"), IMAGE),
    END};
#undef OF
/* clang-format on */
