/* The walk over a scene's tree along the tables of keys. */
#pragma once
#include "scene/keys/key.h"
#include "scene/text/problem.h"

enum { SCENE_WALK_KEYS = 64 }; /* the largest number of keys of a mapping, or of words of a choice */

/* Checks keys, types, ranges and missing keys; fills in the defaults that are constants and sorts the keys into the
 * tables' order. */
void scene_walk(struct scene_node *root, struct scene_problems *problems);

/* What follows is for the walk's files alone. */
struct scene_walk {
    struct scene_problems *problems;
    int parts;     /* enum scene_need: the parts of the scene */
    int dimension; /* 2: a plate; 3; 0: domain.size does not tell, and keys of either dimension are accepted */
    int silent;    /* inside a value that replaces a wrong one: nothing is reported */
};

#define SCENE_WALK_PROBLEM(kind, w, ...) ((w)->silent ? (void)0 : scene_problem_##kind((w)->problems, __VA_ARGS__))

/* Whether the scalar is such a number, choice or text; if not, that is reported. */
int scene_walk_scalar_number(struct scene_walk *w, struct scene_node *node, const struct scene_value *v,
                             const struct scene_key *key, const char *path);
int scene_walk_scalar_choice(struct scene_walk *w, struct scene_node *node, const struct scene_value *v,
                             const char *path);
int scene_walk_scalar_text(struct scene_walk *w, struct scene_node *node, const struct scene_value *v,
                           const char *path);

/* Why the key, one of the section's keys, is not allowed in this scene, malloc'ed; NULL if it is allowed. *unsure: 1 if
 * the answer depends on a key that is itself wrong. */
char *scene_walk_place_why_not(const struct scene_walk *w, const struct scene_node *mapping,
                               const struct scene_key *keys, const struct scene_key *key, int *unsure);
int scene_walk_place_is_galerkin(const struct scene_node *root); /* whether solid.method is element_free */
/* Number of entries of domain.size, 2 or 3, also if the key is misspelled; 0: not known. A scene with a fluid is in
 * 3D. */
int scene_walk_place_dimension(const struct scene_node *root);
const char *scene_walk_place_entry_name(const struct scene_value *entry); /* "numbers" */
/* Required number of entries of a vector; those of 3 numbers have two in a plate. 0: two or three. */
int scene_walk_place_entries(const struct scene_walk *w, const struct scene_value *v, const char *path);
/* Reports the required number of entries. */
void scene_walk_place_say_entries(struct scene_walk *w, const struct scene_node *node, const struct scene_value *v,
                                  const struct scene_key *key, const char *path);
