/* Parts of the JSON Schema that are about one key. */
#pragma once
#include "base/files/json.h"
#include "scene/keys/key.h"

int scene_describe_beside_is_vector(const struct scene_value *v); /* of three numbers, in a plate of two */
/* An array of words that are separated by blanks. */
void scene_describe_beside_words(struct json *j, const char *name, const char *words);
void scene_describe_beside_required(struct json *j, const char *name); /* the keyword required, of one key */
/* An entry of allOf: a key of the section is needed where the keys beside it allow it. */
void scene_describe_beside_need(struct json *j, const struct scene_key *keys, const struct scene_key *key);
/* Entries of allOf: with which keys the key may stand, and where it is needed in every scene. */
void scene_describe_beside_conditions(struct json *j, const struct scene_key *keys, const struct scene_key *key);
int scene_describe_beside_has_conditions(const struct scene_key *key);
