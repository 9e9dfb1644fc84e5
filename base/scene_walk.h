/* The walk over a scene's keys: what its parts share. */
#pragma once
#include "base/scene_problem.h"
#include "base/scene_rule.h"
#include "base/scene_schema.h"

enum { SCENE_WALK_KEYS = 32 }; /* the most that a mapping or a choice may have */

struct scene_walk {
    struct scene_problems *problems;
    int parts;  /* enum scene_need: what the scene has */
    int silent; /* inside something that stands in for a mistake */
};

#define SCENE_WALK_SAY(kind, w, ...)                                                                         \
    ((w)->silent ? (void)0 : scene_problem_##kind((w)->problems, __VA_ARGS__))

/* Whether the scalar is such a number, choice or text; if not, that is said. */
int scene_walk_number(struct scene_walk *w, struct scene_node *node, const cyaml_schema_value_t *v,
                      const struct scene_rule *rule, const char *path);
int scene_walk_choice(struct scene_walk *w, struct scene_node *node, const cyaml_schema_value_t *v,
                      const char *path);
int scene_walk_text(struct scene_walk *w, struct scene_node *node, const cyaml_schema_value_t *v,
                    const char *path);

char *scene_walk_in_units(const struct scene_rule *rule); /* " (m)" where the key has a unit: malloc'ed */
char *scene_walk_joined(int n, const char *const *word);  /* "a, b, c": malloc'ed */
