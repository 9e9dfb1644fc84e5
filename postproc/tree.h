/* Reads a small JSON (or YAML) file, such as run.json. */
#pragma once

struct postproc_tree; /* opaque, owned by the caller */

struct postproc_tree *postproc_tree_new(const char *path); /* NULL: missing or unreadable */
void postproc_tree_free(struct postproc_tree *t);
/* Value by path: "wall_seconds_by_part.poisson", "timeline.0.seconds" of an array's first item. NULL or NAN if there is
 * no such scalar; t may be NULL. */
const char *postproc_tree_text(const struct postproc_tree *t, const char *path);
double postproc_tree_number(const struct postproc_tree *t, const char *path);
/* The k-th key of the mapping at the path (""), or NULL after the last. */
const char *postproc_tree_key(const struct postproc_tree *t, const char *path, int k);
