/* Parses a scene's text to its tree and writes the tree as text, by libyaml. */
#pragma once
#include "scene/text/problem.h"

/* Words for error messages about a file: its name, and how its mapping begins. */
struct scene_yaml_what {
    const char *name, *example;
};
/* The tree of a whole file, or NULL and a problem. */
struct scene_node *scene_yaml_parse(const char *text, size_t bytes, struct scene_problems *problems);
/* The same for a file that is not a scene. */
struct scene_node *scene_yaml_parse_as(const struct scene_yaml_what *what, const char *text, size_t bytes,
                                       struct scene_problems *problems);
/* The tree of a file (JSON is YAML too), without a word about its mistakes; NULL: missing or malformed. Not collective.
 */
struct scene_node *scene_yaml_read(const char *path);
/* The tree of one value, of a --set or a default; NULL and *why (malloc'ed) if it is not YAML. */
struct scene_node *scene_yaml_parse_value(const char *text, char **why);
/* The tree as text, malloc'ed. */
char *scene_yaml_emit(const struct scene_node *root);
