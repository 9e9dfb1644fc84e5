/* The walk over a scene's keys: what its parts share. */
#pragma once
#include "scene/rules/rule.h"
#include "scene/rules/schema.h"
#include "scene/text/problem.h"

enum { SCENE_WALK_KEYS = 32 }; /* the most that a mapping or a choice may have */

struct scene_walk {
    struct scene_problems *problems;
    int parts;     /* enum scene_need: what the scene has */
    int dimension; /* 2: a plate; 3; 0: domain.size does not say, and both are looked at kindly */
    int silent;    /* inside something that stands in for a mistake */
};

#define SCENE_WALK_SAY(kind, w, ...) ((w)->silent ? (void)0 : scene_problem_##kind((w)->problems, __VA_ARGS__))

/* Whether the scalar is such a number, choice or text; if not, that is said. */
int scene_walk_number(struct scene_walk *w, struct scene_node *node, const cyaml_schema_value_t *v,
                      const struct scene_rule *rule, const char *path);
int scene_walk_choice(struct scene_walk *w, struct scene_node *node, const cyaml_schema_value_t *v,
                      const struct scene_rule *rule, const char *path);
int scene_walk_text(struct scene_walk *w, struct scene_node *node, const cyaml_schema_value_t *v, const char *path);

/* Why the key makes no sense in this scene, malloc'ed; NULL if it does. *unsure: what that rests on is itself wrong. */
char *scene_walk_place_why_not(const struct scene_walk *w, const struct scene_node *mapping,
                               const struct scene_rule *rule, int *unsure);
/* How many numbers domain.size has, 2 or 3, whatever the key is misspelled as; 0: it cannot be said. A fluid is in 3D.
 */
int scene_walk_place_dimension(const struct scene_node *root);
const char *scene_walk_place_entry_name(const cyaml_schema_value_t *entry); /* "numbers" */
/* How many entries a list of a fixed number has to have: vectors of a plate have two. 0: two or three. */
int scene_walk_place_entries(const struct scene_walk *w, const cyaml_schema_value_t *v, const char *path);
/* Says that the list has to have that many. */
void scene_walk_place_say_entries(struct scene_walk *w, const struct scene_node *node, const cyaml_schema_value_t *v,
                                  const struct scene_rule *rule, const char *path);

int scene_walk_place_is_among(const char *word, const char *list); /* a list as "a b c" */
char *scene_walk_joined(int n, const char *const *word);           /* "a, b, c": malloc'ed */
