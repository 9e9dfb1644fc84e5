/* Parts of the JSON Schema that are about one key. */
#pragma once
#include "base/files/json.h"
#include "scene/rules/rule.h"
#include "scene/rules/schema.h"

int scene_describe_beside_is_vector(const cyaml_schema_value_t *v); /* of three numbers, in a plate of two */
/* An array of words that are separated by blanks. */
void scene_describe_beside_words(struct json *j, const char *key, const char *words);
void scene_describe_beside_required(struct json *j, const char *key); /* the keyword required, of one key */
/* An entry of allOf: the key is needed where its siblings allow it. */
void scene_describe_beside_need(struct json *j, const char *key, const struct scene_rule *rule, const char *path);
/* Entries of allOf: with which keys the key may stand, and where it is needed in every scene. */
void scene_describe_beside_conditions(struct json *j, const char *key, const struct scene_rule *rule, const char *path);
