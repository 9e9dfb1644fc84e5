/* Reads a small JSON (or YAML) file, such as run.json. */
#pragma once

struct json_read; /* opaque, owned by the caller */

struct json_read *json_read_new(const char *path); /* NULL: missing or unreadable */
void json_read_free(struct json_read *t);
/* Value by path: "wall_seconds_by_part.poisson", "timeline.0.seconds" of an array's first item. NULL or NAN if there is
 * no such scalar; t may be NULL. */
const char *json_read_text(const struct json_read *t, const char *path);
double json_read_number(const struct json_read *t, const char *path);
/* The k-th key of the mapping at the path (""), or NULL after the last. */
const char *json_read_key(const struct json_read *t, const char *path, int k);
