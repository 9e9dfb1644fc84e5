/* Reads keys of a mapping in a study's file by type and reports what is wrong with them. */
#include "program/study/file/key.h"
#include "base/arena.h"
#include "base/sanitize.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

char *study_key_path(const struct study_key *k, const char *key) {
    return arena_text("%s%s%s", k->path, *k->path ? "." : "", key);
}

static const struct scene_node *find(const struct study_key *k, const char *key) {
    return scene_node_child(k->mapping, key);
}

#define PROBLEM(k, node, key, ...) scene_problem_value((k)->problems, node, study_key_path(k, key), __VA_ARGS__)

int study_key_known(const struct study_key *k, int n, const char *const *word) {
    if (k->mapping->kind != SCENE_NODE_MAPPING) {
        scene_problem_value(k->problems, k->mapping, k->path, "must be a mapping (%s: ...)", word[0]);
        return 0;
    }
    for (int i = 0; i < k->mapping->n; i++) {
        const struct scene_node *node = k->mapping->child[i];
        int known = 0;
        for (int w = 0; w < n; w++) known |= !strcmp(node->key, word[w]);
        for (int j = 0; j < i; j++)
            if (!strcmp(k->mapping->child[j]->key, node->key)) PROBLEM(k, node, node->key, "is there twice");
        if (known) continue;
        PROBLEM(k, node, node->key, "unknown key%s", scene_problem_hint(node->key, n, word).text);
    }
    return 1;
}

void study_key_missing(const struct study_key *k, const char *key, const char *what) {
    if (!find(k, key)) scene_problem_key(k->problems, k->mapping, study_key_path(k, key), "is missing: %s", what);
}

int study_key_number_of(const struct scene_node *node, double *value) {
    if (node->kind != SCENE_NODE_SCALAR || node->quoted || !*node->value) return 0;
    if (strspn(node->value, "+-.0123456789eE") != strlen(node->value)) return 0;
    char *end;
    *value = strtod(node->value, &end);
    return *end == '\0' && isfinite(*value);
}

double study_key_number(const struct study_key *k, const char *key, enum study_key_range range, double fallback) {
    static const char *const allowed[] = {"", ", greater than 0", ", at least 0"};
    const struct scene_node *node = find(k, key);
    double value;
    if (!node) return fallback;
    const int form = study_key_number_of(node, &value);
    if (form && (range == STUDY_KEY_ANY || value > 0 || (range == STUDY_KEY_NOT_NEGATIVE && value == 0))) return value;
    PROBLEM(k, node, key, "must be a number%s", allowed[range]);
    return fallback;
}

int study_key_whole(const struct study_key *k, const char *key, int low, int high, int fallback) {
    const struct scene_node *node = find(k, key);
    double value;
    if (!node) return fallback;
    if (study_key_number_of(node, &value) && value == rint(value) && value >= low && value <= high) return (int)value;
    PROBLEM(k, node, key, "must be a whole number, %d to %d", low, high);
    return fallback;
}

int study_key_choice(const struct study_key *k, const char *key, int n, const char *const *word, int fallback) {
    const struct scene_node *node = find(k, key);
    if (!node) return fallback;
    char *all = arena_text("%s", "");
    for (int w = 0; w < n; w++) {
        if (node->kind == SCENE_NODE_SCALAR && !strcmp(node->value, word[w])) return w;
        all = arena_text("%s%s%s", all, w ? ", " : "", word[w]);
    }
    PROBLEM(k, node, key, "must be one of %s", all);
    return fallback;
}

int study_key_true(const struct study_key *k, const char *key) {
    const struct scene_node *node = find(k, key);
    if (!node) return 0;
    if (node->kind != SCENE_NODE_SCALAR || strcmp(node->value, "true"))
        PROBLEM(k, node, key, "can only be true: leave it out otherwise");
    return 1;
}

char *study_key_text(const struct study_key *k, const char *key, const char *fallback) {
    const struct scene_node *node = find(k, key);
    const int is_text = node && node->kind == SCENE_NODE_SCALAR && *node->value;
    if (is_text && strcmp(key, "command") && sanitize_has_control(node->value))
        PROBLEM(k, node, key, "must be one line without control characters");
    if (is_text) return arena_text("%s", node->value);
    if (node) PROBLEM(k, node, key, "must be a text");
    return fallback ? arena_text("%s", fallback) : NULL;
}

const struct scene_node *study_key_list(const struct study_key *k, const char *key, int needed) {
    const struct scene_node *node = find(k, key);
    if (!node) {
        if (needed) study_key_missing(k, key, "a list");
        return NULL;
    }
    if (node->kind == SCENE_NODE_LIST && node->n > 0) return node;
    PROBLEM(k, node, key, "must be a list that is not empty");
    return NULL;
}
