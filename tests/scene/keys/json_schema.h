/* Draft 7 of JSON Schema, as far as `frana schema` uses it, on trees of YAML. A keyword that is not known fails the
 * test. */
#pragma once
#include "scene/text/node.h"
#include "tests/check.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum json_kind { JSON_NULL, JSON_BOOL, JSON_NUMBER, JSON_STRING, JSON_ARRAY, JSON_OBJECT };

/* As YAML 1.2 reads a plain scalar. */
static inline enum json_kind json_kind_of(const struct scene_node *n, double *number) {
    if (n->kind == SCENE_NODE_MAPPING) return JSON_OBJECT;
    if (n->kind == SCENE_NODE_LIST) return JSON_ARRAY;
    if (n->quoted) return JSON_STRING;
    if (!*n->value || !strcmp(n->value, "null") || !strcmp(n->value, "~")) return JSON_NULL;
    if (!strcmp(n->value, "true") || !strcmp(n->value, "false")) return JSON_BOOL;
    char *end;
    *number = INFINITY;
    if (!strcmp(n->value, ".inf")) return JSON_NUMBER;
    *number = strtod(n->value, &end);
    return strchr("+-.0123456789", *n->value) && !*end ? JSON_NUMBER : JSON_STRING;
}

static inline int json_is_type(enum json_kind kind, double number, const char *type) {
    static const char *const name[] = {"null", "boolean", "number", "string", "array", "object"};
    if (!strcmp(type, "integer")) return kind == JSON_NUMBER && isfinite(number) && floor(number) == number;
    return !strcmp(type, name[kind]);
}

static inline int json_admits(const struct scene_node *schema, const struct scene_node *it);

static inline int json_among(const struct scene_node *list, const struct scene_node *it) {
    double a = 0, b = 0;
    for (int k = 0; k < list->n; k++) {
        const enum json_kind kind = json_kind_of(it, &a);
        if (kind == json_kind_of(list->child[k], &b) && !strcmp(list->child[k]->value, it->value)) return 1;
    }
    return 0;
}

static inline int json_has_all(const struct scene_node *it, const struct scene_node *keys) {
    for (int k = 0; k < keys->n; k++)
        if (!scene_node_child(it, keys->child[k]->value)) return 0;
    return 1;
}

static inline int json_admits_keys(const struct scene_node *schema, const struct scene_node *it) {
    const struct scene_node *properties = scene_node_child(schema, "properties");
    const struct scene_node *others = scene_node_child(schema, "additionalProperties");
    for (int i = 0; i < it->n; i++) {
        const struct scene_node *known = properties ? scene_node_child(properties, it->child[i]->key) : NULL;
        if (known && !json_admits(known, it->child[i])) return 0;
        if (known || !others) continue;
        if (others->kind == SCENE_NODE_SCALAR && !strcmp(others->value, "false")) return 0;
        if (others->kind == SCENE_NODE_MAPPING && !json_admits(others, it->child[i])) return 0;
    }
    return 1;
}

static inline int json_admits_by(const struct scene_node *schema, const struct scene_node *word,
                                 const struct scene_node *it, enum json_kind kind, double number) {
    const char *key = word->key;
    const double limit = word->kind == SCENE_NODE_SCALAR ? strtod(word->value, NULL) : 0;
    if (strstr("$schema title description default then", key)) return 1;
    if (!strcmp(key, "type") && word->kind == SCENE_NODE_SCALAR) return json_is_type(kind, number, word->value);
    if (!strcmp(key, "type")) {
        for (int k = 0; k < word->n; k++)
            if (json_is_type(kind, number, word->child[k]->value)) return 1;
        return 0;
    }
    if (!strcmp(key, "enum")) return it->kind == SCENE_NODE_SCALAR && json_among(word, it);
    if (!strcmp(key, "minimum")) return kind != JSON_NUMBER || number >= limit;
    if (!strcmp(key, "maximum")) return kind != JSON_NUMBER || number <= limit;
    if (!strcmp(key, "exclusiveMinimum")) return kind != JSON_NUMBER || number > limit;
    if (!strcmp(key, "exclusiveMaximum")) return kind != JSON_NUMBER || number < limit;
    if (!strcmp(key, "minLength")) return kind != JSON_STRING || strlen(it->value) >= (size_t)limit;
    if (!strcmp(key, "maxLength")) return kind != JSON_STRING || strlen(it->value) <= (size_t)limit;
    if (!strcmp(key, "minItems")) return kind != JSON_ARRAY || it->n >= limit;
    if (!strcmp(key, "maxItems")) return kind != JSON_ARRAY || it->n <= limit;
    if (!strcmp(key, "items")) {
        for (int k = 0; kind == JSON_ARRAY && k < it->n; k++)
            if (!json_admits(word, it->child[k])) return 0;
        return 1;
    }
    if (!strcmp(key, "properties")) return kind != JSON_OBJECT || json_admits_keys(schema, it);
    if (!strcmp(key, "additionalProperties"))
        return scene_node_child(schema, "properties") || kind != JSON_OBJECT || json_admits_keys(schema, it);
    if (!strcmp(key, "required")) return kind != JSON_OBJECT || json_has_all(it, word);
    if (!strcmp(key, "dependencies")) {
        for (int k = 0; kind == JSON_OBJECT && k < word->n; k++)
            if (scene_node_child(it, word->child[k]->key) && !json_has_all(it, word->child[k])) return 0;
        return 1;
    }
    if (!strcmp(key, "not")) return !json_admits(word, it);
    if (!strcmp(key, "if")) return !json_admits(word, it) || json_admits(scene_node_child(schema, "then"), it);
    const int any = !strcmp(key, "anyOf");
    if (!any && strcmp(key, "allOf") != 0) fail_msg("the keyword %s", key);
    for (int k = 0; k < word->n; k++)
        if (json_admits(word->child[k], it) == any) return any;
    return !any;
}

static inline int json_admits(const struct scene_node *schema, const struct scene_node *it) {
    double number = 0;
    const enum json_kind kind = json_kind_of(it, &number);
    for (int k = 0; k < schema->n; k++)
        if (!json_admits_by(schema, schema->child[k], it, kind, number)) return 0;
    return 1;
}
