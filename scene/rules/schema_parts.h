/* Macros and shared entries of the schema's tables. */
#pragma once
#include "scene/rules/schema.h"

enum { NEEDED = CYAML_FLAG_DEFAULT, OPTIONAL = CYAML_FLAG_OPTIONAL, LIST = CYAML_FLAG_OPTIONAL | CYAML_FLAG_POINTER };
enum { LIST_MAX = 10000 };

extern const cyaml_schema_value_t scene_schema_parts_real;
extern const cyaml_strval_t scene_schema_parts_axes[3];
extern const cyaml_strval_t scene_schema_parts_arrangements[5], scene_schema_parts_volumes[2];
extern const cyaml_schema_field_t scene_schema_solid[]; /* of struct scene_solid */

#define VECTOR(key, flags, type, member)                                                                               \
    CYAML_FIELD_SEQUENCE_FIXED(key, flags, struct type, member, &scene_schema_parts_real, 3)
#define PAIR(key, flags, type, member)                                                                                 \
    CYAML_FIELD_SEQUENCE_FIXED(key, flags, struct type, member, &scene_schema_parts_real, 2)
#define NUMBER(key, flags, type, member) CYAML_FIELD_FLOAT(key, flags, struct type, member)
#define WHOLE(key, flags, type, member) CYAML_FIELD_INT(key, flags, struct type, member)
#define BOOLEAN(key, flags, type, member) CYAML_FIELD_BOOL(key, flags, struct type, member)
#define TEXT(key, flags, type, member) CYAML_FIELD_STRING(key, flags, struct type, member, 1)
#define CHOICE(key, flags, type, member, words)                                                                        \
    CYAML_FIELD_ENUM(key, flags | CYAML_FLAG_STRICT, struct type, member, words, CYAML_ARRAY_LEN(words))
/* A mapping of the file whose keys are members of the surrounding struct. */
#define PART(name, optional, type, its_fields)                                                                         \
    {                                                                                                                  \
        .key = name, .data_offset = 0, .value = { CYAML_VALUE_MAPPING(optional, struct type, its_fields) }             \
    }
#define ENTRIES(key, flags, type, member, count, entry, least, most)                                                   \
    CYAML_FIELD_SEQUENCE_COUNT(key, (flags) | CYAML_FLAG_POINTER, struct type, member, count, entry, least, most)
