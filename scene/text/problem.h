/* The mistakes found in a scene: one line each, in the order of the file. */
#pragma once
#include "scene/text/node.h"

struct scene_problems {
    const char *file; /* as the user named it; borrowed */
    int n, capacity;
    int *line;
    char **text;
};

void scene_problem_free(struct scene_problems *p);
/* Prints the sentences, the first LINES of many, as a terminal may get them. Not collective. */
enum { SCENE_PROBLEM_LINES = 100 };
void scene_problem_print(const struct scene_problems *p);
void scene_problem_sort(struct scene_problems *p); /* by line; in the order found within a line */

/* Reports "file:line: message", for a mistake without a key. */
void scene_problem_line(struct scene_problems *p, int line, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
/* Reports "file:line: path: message"; for a node from a --set, "--set path: message". */
void scene_problem_key(struct scene_problems *p, const struct scene_node *node, const char *path, const char *format,
                       ...) __attribute__((format(printf, 4, 5)));
/* Reports "file:line: path = value: message". */
void scene_problem_value(struct scene_problems *p, const struct scene_node *node, const char *path, const char *format,
                         ...) __attribute__((format(printf, 4, 5)));
/* Reports a mistake at a path: with its value if it has one, else at the line of its deepest existing ancestor. */
void scene_problem_at(struct scene_problems *p, const struct scene_node *root, const char *path, const char *format,
                      ...) __attribute__((format(printf, 4, 5)));

/* "; did you mean CANDIDATE?" of the candidate nearest to the word; "" if none is near enough. */
struct scene_problem_hint {
    char text[80];
};
struct scene_problem_hint scene_problem_hint(const char *word, int n, const char *const *candidate);
/* The candidate nearest to the word by edits (insert, delete, change, swap); NULL if none is near enough. */
const char *scene_problem_nearest(const char *word, int n, const char *const *candidate);
