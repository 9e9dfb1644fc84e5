/* Macros of the tables of keys. A line is KEY(name, type(member), unit, ...): after the unit come the default, the
 * range and where the key applies, each left out if there is none. Members are those of OF, which each table defines.
 */
#pragma once
#include "scene/keys/key.h"

#include <math.h>

enum {
    FLUID = SCENE_WITH_FLUID,
    SOLID = SCENE_WITH_SOLID,
    NO_FLUID = SCENE_WITHOUT_FLUID,
    BOTH = FLUID | SOLID,
    SPACE = SCENE_IN_3D,
    PLATE = SCENE_IN_PLATE,
    STEPPED = SCENE_STEPPED,
    GALERKIN = SCENE_GALERKIN,
    ALWAYS = SCENE_ALWAYS
};
enum { LIST_MAX = 10000 };
#define CELLS_MAX 1e6

#define KEY(its_name, type, its_unit, ...)                                                                             \
    { .name = its_name, type, .unit = its_unit, ##__VA_ARGS__ }
#define WORD(its_word, its_value, ...)                                                                                 \
    { .word = its_word, .value = its_value, ##__VA_ARGS__ }
#define END                                                                                                            \
    { .name = NULL }

#define BYTES(member) sizeof(((struct OF *)0)->member)
#define AT(member, ...) .offset = offsetof(struct OF, member), .value = {.bytes = BYTES(member), __VA_ARGS__}
#define NUMBER(member) AT(member, .type = SCENE_NUMBER)
#define WHOLE(member) AT(member, .type = SCENE_WHOLE) /* int or long */
#define SWITCH(member) AT(member, .type = SCENE_SWITCH)
#define TEXT(member) AT(member, .type = SCENE_TEXT, .least = 1, .most = BYTES(member) - 1)
#define CHOICE(member, its_words)                                                                                      \
    AT(member, .type = SCENE_CHOICE, .words = its_words, .most = sizeof its_words / sizeof *its_words)
#define VECTOR_OF(n, its_entry, member) AT(member, .type = SCENE_VECTOR, .least = n, .most = n, .entry = &its_entry)
/* One number that counts for all three, or three. */
#define NUMBER_OR_VECTOR(member)                                                                                       \
    AT(member, .type = SCENE_VECTOR, .least = 3, .most = 3, .entry = &scene_table_number, .repeats = 1)
#define VECTOR(member) VECTOR_OF(3, scene_table_number, member)
#define PAIR(member) VECTOR_OF(2, scene_table_number, member)
#define LIST(its_entry, member, n, its_least, its_most)                                                                \
    .offset = offsetof(struct OF, member), .value = {.type = SCENE_LIST,                                               \
                                                     .bytes = sizeof *((struct OF *)0)->member,                        \
                                                     .count = offsetof(struct OF, n),                                  \
                                                     .entry = &its_entry,                                              \
                                                     .least = its_least,                                               \
                                                     .most = its_most}
/* A section: allocated; a struct in this one; keys that are members of this struct. */
#define SECTION(member, its_keys)                                                                                      \
    .offset = offsetof(struct OF, member),                                                                             \
    .value = {.type = SCENE_SECTION, .bytes = sizeof *((struct OF *)0)->member, .keys = its_keys, .is_allocated = 1}
#define INNER(member, its_keys) AT(member, .type = SCENE_SECTION, .keys = its_keys)
#define PART(its_keys) .offset = 0, .value = {.type = SCENE_SECTION, .bytes = sizeof(struct OF), .keys = its_keys}
/* An entry of a list that is a section. */
#define ENTRY(name, its_struct, its_keys)                                                                              \
    static const struct scene_value name = {.type = SCENE_SECTION, .bytes = sizeof(struct its_struct), .keys = its_keys}

#define DEFAULT(text) .fallback = (text)
#define ABOVE(x) .low = (x), .high = INFINITY, .open = 1
#define FROM(x) .low = (x), .high = INFINITY
#define WITHIN(a, b) .low = (a), .high = (b)
#define WITHOUT_LOW .open = 1
#define WITHOUT_HIGH .open = 2
#define WITHOUT_ENDS .open = 3
#define OR(its_word, number) .word = (its_word), .word_value = (number)
#define ONLY(parts) .only = (parts)
#define NEEDED .needed = ALWAYS
#define NEEDED_IN(parts) .needed = (parts)
#define WHERE(key, list) .sibling = (key), .values = (list)
#define BY_SHAPE WHERE("shape", SCENE_BY_WORD)
#define WITH(key) .with = (key)
#define NOT_WITH(key) .not_with = (key)

extern const struct scene_value scene_table_number, scene_table_whole, scene_table_switch, scene_table_pair,
    scene_table_triple;
extern const struct scene_word scene_table_axes[3]; /* x, y, z */
/* The tables of the sections. */
extern const struct scene_key scene_table_fluid[], scene_table_solid[], scene_table_body[], scene_table_element_free[],
    scene_table_refinement[], scene_table_coupling[], scene_table_crack_fluid[], scene_table_nonlocal[],
    scene_table_output[];
/* Sub-tables of several sections. */
extern const struct scene_key scene_table_rotation[];       /* of struct scene_turn */
extern const struct scene_key scene_table_plate_rotation[]; /* the same in sections of a plate */
extern const struct scene_key scene_table_arrangement[];    /* of struct scene_arranged: particles of a body */
extern const struct scene_key scene_table_points[];         /* the same: points of a scene that is solved at once */
