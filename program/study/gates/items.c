/* Walks through the items of a file of gates, and replaces names in their texts. */
#include "program/study/gates/items.h"
#include "base/arena.h"
#include "program/study/file/key.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *value_of(const struct study_gates_name *names, const char *name, size_t length) {
    for (; names; names = names->outer)
        if (!names->group && strlen(names->name) == length && !strncmp(names->name, name, length)) return names->value;
    return NULL;
}

static char *replaced(const char *text, const struct study_gates_name *names) {
    char *made = NULL;
    size_t bytes = 0;
    FILE *f = open_memstream(&made, &bytes);
    while (*text) {
        const size_t length = *text == '{' ? strcspn(text + 1, "{}") : 0;
        const char *value = length && text[1 + length] == '}' ? value_of(names, text + 1, length) : NULL;
        if (value)
            fputs(value, f);
        else
            fputc(*text, f);
        text += value ? length + 2 : 1;
    }
    fclose(f);
    return arena_keep(made);
}

char *study_gates_items_text(const struct scene_node *item, const char *key, const struct study_gates_name *names) {
    const struct scene_node *node = scene_node_child(item, key);
    for (const struct study_gates_name *around = names; around && !node; around = around->outer)
        if (around->group) node = scene_node_child(around->group, key);
    return node && node->kind == SCENE_NODE_SCALAR ? replaced(node->value, names) : NULL;
}

static int is_left_out(const struct scene_node *item, int quick) {
    const struct scene_node *when = scene_node_child(item, "when");
    return when && strcmp(when->value, quick ? "quick" : "whole") != 0;
}

/* The k-th mapping of `each`, which is a mapping or a list of mappings; NULL after the last. */
static const struct scene_node *mapping_of(const struct scene_node *each, int k) {
    if (!each) return NULL;
    if (each->kind == SCENE_NODE_LIST) return k < each->n ? each->child[k] : NULL;
    return k == 0 ? each : NULL;
}

/* For all values of the k-th mapping and of those after it: lists of one mapping go together. */
static void visit_from(const struct scene_node *item, int k, const struct study_gates_name *names,
                       const struct study_gates_visit *v) {
    const struct scene_node *mapping = mapping_of(scene_node_child(item, "each"), k);
    const struct scene_node *inner = scene_node_child(item, v->inner);
    const struct study_gates_name group = {.outer = names, .group = item};
    if (!mapping && inner) study_gates_items_visit(inner, &group, v);
    if (!mapping && !inner) v->item(item, names, v->with);
    if (!mapping) return;
    struct study_gates_name *more = arena_new((size_t)mapping->n, sizeof *more);
    for (int i = 0; i < mapping->child[0]->n; i++) {
        for (int m = 0; m < mapping->n; m++)
            more[m] = (struct study_gates_name){m ? &more[m - 1] : names, mapping->child[m]->key,
                                                mapping->child[m]->child[i]->value, NULL};
        visit_from(item, k + 1, &more[mapping->n - 1], v);
    }
}

void study_gates_items_visit(const struct scene_node *list, const struct study_gates_name *names,
                             const struct study_gates_visit *visit) {
    for (int i = 0; list && i < list->n; i++)
        if (!is_left_out(list->child[i], visit->quick)) visit_from(list->child[i], 0, names, visit);
}

static int is_list_of_scalars(const struct scene_node *node) {
    if (node->kind != SCENE_NODE_LIST || node->n == 0) return 0;
    for (int i = 0; i < node->n; i++)
        if (node->child[i]->kind != SCENE_NODE_SCALAR) return 0;
    return 1;
}

static void check_each(const struct scene_node *item, struct scene_problems *problems) {
    const struct scene_node *each = scene_node_child(item, "each"), *mapping;
    for (int k = 0; (mapping = mapping_of(each, k)); k++) {
        int good = mapping->kind == SCENE_NODE_MAPPING && mapping->n > 0;
        for (int m = 0; good && m < mapping->n; m++)
            good = is_list_of_scalars(mapping->child[m]) && mapping->child[m]->n == mapping->child[0]->n;
        if (!good)
            scene_problem_key(problems, each, "each",
                              "must be a mapping of names to lists of values of one length, or a "
                              "list of such mappings, of which every combination is taken");
    }
}

struct allowed {
    const char *inner;
    int n, shared;
    const char *const *word;
};

static void check_list(const struct scene_node *list, const struct allowed *a, struct scene_problems *problems);

static void check_item(const struct scene_node *item, int i, const struct allowed *a, struct scene_problems *problems) {
    static const char *const when[] = {"quick", "whole"};
    const char *group[16];
    const struct scene_node *items = item->kind == SCENE_NODE_MAPPING ? scene_node_child(item, a->inner) : NULL;
    const struct study_key k = {item, arena_text("%s[%d]", a->inner, i), problems};
    for (int w = 0; w < a->shared; w++) group[w] = a->word[w];
    group[a->shared] = a->inner;
    if (study_key_known(&k, items ? a->shared + 1 : a->n, items ? group : a->word)) {
        study_key_choice(&k, "when", 2, when, 0);
        check_each(item, problems);
    }
    if (items) check_list(items, a, problems);
}

static void check_list(const struct scene_node *list, const struct allowed *a, struct scene_problems *problems) {
    if (list->kind != SCENE_NODE_LIST) scene_problem_value(problems, list, a->inner, "must be a list");
    for (int i = 0; list->kind == SCENE_NODE_LIST && i < list->n; i++) check_item(list->child[i], i, a, problems);
}

void study_gates_items_check(const struct scene_node *root, const char *inner, int n, const char *const *word,
                             int shared, struct scene_problems *problems) {
    const struct scene_node *list = scene_node_child(root, inner);
    if (list) check_list(list, &(struct allowed){inner, n, shared, word}, problems);
}
