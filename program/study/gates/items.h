/* Items of a file of gates: lists whose items may stand for several, by names that take values.  (docs/study.md) */
#pragma once
#include "scene/text/problem.h"

/* A name and the text that {name} stands for, or a group, whose texts its items share; NULL: the end. */
struct study_gates_name {
    const struct study_gates_name *outer;
    const char *name, *value;
    const struct scene_node *group; /* NULL: a name */
};

/* What is done with an item and the values of its names. */
struct study_gates_visit {
    void (*item)(const struct scene_node *item, const struct study_gates_name *names, void *with);
    void *with;
    const char *inner; /* the key under which an item holds items, such as gates */
    int quick;         /* 1: items with when: whole are left out; 0: those with when: quick */
};

/* Visits all items of a list in order, for each value of `each`; list may be NULL. */
void study_gates_items_visit(const struct scene_node *list, const struct study_gates_name *names,
                             const struct study_gates_visit *visit);
/* The text of a key of the item, or of the nearest group around it, with the names replaced; NULL: none. */
char *study_gates_items_text(const struct scene_node *item, const char *key, const struct study_gates_name *names);
/* Reports unknown keys and lists of different lengths; word[n]: keys of an item; the first `shared` of them may stand
 * in a group too. */
void study_gates_items_check(const struct scene_node *root, const char *inner, int n, const char *const *word,
                             int shared, struct scene_problems *problems);
