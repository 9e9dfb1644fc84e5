/* Tree of the scene's YAML: scalars, lists and mappings; creation, search and removal of nodes. */
#include "scene/text/node.h"
#include "base/die.h"
#include "base/text.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct scene_node *scene_node_new(enum scene_node_kind kind, const char *key, const char *value) {
    struct scene_node *node = calloc(1, sizeof *node);
    if (!node) die(EXIT_CODE_FILE, "no memory left for the scene");
    node->kind = kind;
    node->key = key ? text_new("%s", key) : NULL;
    node->value = value ? text_new("%s", value) : NULL;
    return node;
}

void scene_node_clear(struct scene_node *node) {
    for (int i = 0; i < node->n; i++) scene_node_free(node->child[i]);
    free(node->child);
    free(node->value);
    node->child = NULL;
    node->value = NULL;
    node->n = node->capacity = node->quoted = 0;
}

void scene_node_free(struct scene_node *node) {
    if (!node) return;
    scene_node_clear(node);
    free(node->key);
    free(node->set);
    free(node);
}

void scene_node_insert(struct scene_node *parent, int i, struct scene_node *child) {
    if (parent->n == parent->capacity) {
        parent->capacity = parent->capacity ? 2 * parent->capacity : 8;
        parent->child = realloc(parent->child, (size_t)parent->capacity * sizeof(struct scene_node *));
        if (!parent->child) die(EXIT_CODE_FILE, "no memory left for the scene");
    }
    memmove(parent->child + i + 1, parent->child + i, (size_t)(parent->n - i) * sizeof(struct scene_node *));
    parent->child[i] = child;
    parent->n++;
}

void scene_node_append(struct scene_node *parent, struct scene_node *child) {
    scene_node_insert(parent, parent->n, child);
}

void scene_node_drop(struct scene_node *parent, int i) {
    scene_node_free(parent->child[i]);
    parent->n--;
    memmove(parent->child + i, parent->child + i + 1, (size_t)(parent->n - i) * sizeof(struct scene_node *));
}

static struct scene_node *child_of(const struct scene_node *node, const char *key, size_t length) {
    if (node->kind != SCENE_NODE_MAPPING) return NULL;
    for (int i = 0; i < node->n; i++)
        if (strlen(node->child[i]->key) == length && !memcmp(node->child[i]->key, key, length)) return node->child[i];
    return NULL;
}

struct scene_node *scene_node_child(const struct scene_node *mapping, const char *key) {
    return child_of(mapping, key, strlen(key));
}

/* Follows the path as far as it exists; *rest is the rest of it. */
static const struct scene_node *walk(const struct scene_node *node, const char *path, const char **rest) {
    while (*path) {
        const struct scene_node *next = NULL;
        const char *end = path;
        if (*path == '[') {
            const long i = strtol(path + 1, (char **)&end, 10);
            if (*end == ']') end++;
            if (node->kind == SCENE_NODE_LIST && i >= 0 && i < node->n) next = node->child[i];
        } else {
            end = path + strcspn(path, ".[");
            next = child_of(node, path, (size_t)(end - path));
        }
        if (!next) break;
        node = next;
        path = *end == '.' ? end + 1 : end;
    }
    *rest = path;
    return node;
}

struct scene_node *scene_node_find(const struct scene_node *root, const char *path) {
    const char *rest;
    const struct scene_node *node = walk(root, path, &rest);
    return *rest ? NULL : (struct scene_node *)node;
}

const struct scene_node *scene_node_near(const struct scene_node *root, const char *path) {
    const char *rest;
    return walk(root, path, &rest);
}

static int is_clean(const struct scene_node *node) {
    if (node->bad) return 0;
    for (int i = 0; i < node->n; i++)
        if (!is_clean(node->child[i])) return 0;
    return 1;
}

int scene_node_is_clean(const struct scene_node *root, const char *path) {
    const struct scene_node *node = scene_node_find(root, path);
    return node && is_clean(node);
}
