/* What a scene's parts, its dimension and its method say of keys elsewhere, for its JSON Schema. */
#pragma once
#include "base/files/json.h"

/* Entries of the whole scene's allOf: if it has a part, keys that are needed, words and lengths of vectors that are
 * left; if it has not, keys that are not allowed. */
void scene_describe_where(struct json *j);
