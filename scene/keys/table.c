/* What several tables of keys share: numbers and vectors, axes, rotations, arrangements of particles. */
#include "scene/keys/table.h"

const struct scene_value scene_table_number = {.type = SCENE_NUMBER, .bytes = sizeof(double)};
const struct scene_value scene_table_whole = {.type = SCENE_WHOLE, .bytes = sizeof(int)};
const struct scene_value scene_table_switch = {.type = SCENE_SWITCH, .bytes = sizeof(int)};
const struct scene_value scene_table_pair = {
    .type = SCENE_VECTOR, .bytes = sizeof(double[2]), .least = 2, .most = 2, .entry = &scene_table_number};
const struct scene_value scene_table_triple = {
    .type = SCENE_VECTOR, .bytes = sizeof(double[3]), .least = 3, .most = 3, .entry = &scene_table_number};
const struct scene_word scene_table_axes[3] = {WORD("x", 0), WORD("y", 1), WORD("z", 2)};
static const struct scene_word arrangements[] = {
    WORD("lattice", MESHLESS_LATTICE), WORD("hexagonal", MESHLESS_HEXAGONAL), WORD("perturbed", MESHLESS_PERTURBED),
    WORD("centroidal", MESHLESS_CENTROIDAL), WORD("random", MESHLESS_RANDOM)};
static const struct scene_word volumes[] = {WORD("equal", MESHLESS_EQUAL), WORD("cell", MESHLESS_CELL)};

/* clang-format off */
#define OF scene_turn
const struct scene_key scene_table_rotation[] = {
    KEY("axis", VECTOR(axis), "1", NEEDED_IN(SPACE), ONLY(SPACE), NOT_WITH("axes")),
    KEY("angle", NUMBER(angle), "degrees", NEEDED, NOT_WITH("axes")),
    KEY("axes", VECTOR_OF(2, scene_table_triple, axes), "1", ONLY(SPACE)),
    /* several shapes that turn as one turn about the same point */
    KEY("about", VECTOR(about), "m"),
    END};
const struct scene_key scene_table_plate_rotation[] = {
    KEY("angle", NUMBER(angle), "degrees", NEEDED),
    KEY("about", VECTOR(about), "m"),
    END};
#undef OF

#define OF scene_arranged
#define ARRANGEMENT(...)                                                                                               \
    KEY("kind", CHOICE(kind, arrangements), "choice", DEFAULT("lattice")),                                             \
    KEY("perturbation", NUMBER(perturbation), "spacings", NEEDED, WITHIN(0, 0.4), WITHOUT_LOW,                         \
        WHERE("kind", "perturbed")),                                                                                   \
    KEY("seed", WHOLE(seed), "1", DEFAULT("1"), FROM(0), WHERE("kind", "perturbed centroidal random")),                \
    KEY("volume", CHOICE(volume, volumes), "choice", DEFAULT("equal"), ##__VA_ARGS__)
const struct scene_key scene_table_points[] = {ARRANGEMENT(), END};
const struct scene_key scene_table_arrangement[] = {ARRANGEMENT(WHERE("kind", "hexagonal centroidal random")), END};
#undef OF
/* clang-format on */
