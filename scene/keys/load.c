/* Loads a tree whose keys have been checked into struct scene, and frees it. */
#include "scene/keys/load.h"
#include "base/die.h"
#include "base/ensure.h"
#include "scene/keys/key.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Zeros: what the file leaves out. */
static void *allocate(size_t n, size_t bytes) {
    void *data = calloc(n > 0 ? n : 1, bytes);
    if (!data) die(EXIT_CODE_FILE, "no memory left for the scene");
    return data;
}

static void put(const struct scene_node *node, const struct scene_value *v, const struct scene_key *key, char *to);

static void put_number(const struct scene_node *node, const struct scene_value *v, const struct scene_key *key,
                       char *to) {
    const int is_word = key && key->word && !strcmp(node->value, key->word);
    const double number = is_word ? key->word_value : v->type == SCENE_NUMBER ? strtod(node->value, NULL) : 0;
    const long counted = v->type == SCENE_WHOLE ? strtol(node->value, NULL, 10) : 0;
    const long whole = is_word && v->type != SCENE_NUMBER ? (long)number : counted; /* a word may stand for infinity */
    const int small = (int)whole;
    if (v->type == SCENE_NUMBER)
        memcpy(to, &number, sizeof number);
    else if (v->bytes == sizeof whole)
        memcpy(to, &whole, sizeof whole);
    else
        memcpy(to, &small, sizeof small);
}

static void put_choice(const struct scene_node *node, const struct scene_value *v, char *to) {
    for (int i = 0; i < v->most; i++)
        if (!strcmp(v->words[i].word, node->value)) {
            memcpy(to, &v->words[i].value, sizeof(int));
            return;
        }
    ENSURE(0, "%s is not a word of %s", node->value, node->key);
}

/* to: of the struct with the list. */
static void put_list(const struct scene_node *node, const struct scene_key *key, char *to) {
    const struct scene_value *v = &key->value;
    char *entries = allocate((size_t)node->n, v->bytes);
    for (int i = 0; i < node->n; i++) put(node->child[i], v->entry, NULL, entries + (size_t)i * v->bytes);
    memcpy(to + key->offset, &entries, sizeof entries);
    memcpy(to + v->count, &node->n, sizeof node->n);
}

static void put_section(const struct scene_node *node, const struct scene_value *v, char *to) {
    for (const struct scene_key *key = v->keys; key->name; key++) {
        const struct scene_node *child = scene_node_child(node, key->name);
        if (child && key->value.type == SCENE_LIST)
            put_list(child, key, to);
        else if (child)
            put(child, &key->value, key, to + key->offset);
    }
}

static void put(const struct scene_node *node, const struct scene_value *v, const struct scene_key *key, char *to) {
    const int is_true = node->kind == SCENE_NODE_SCALAR && !strcmp(node->value, "true");
    switch (v->type) {
    case SCENE_NUMBER:
    case SCENE_WHOLE:
        put_number(node, v, key, to);
        return;
    case SCENE_SWITCH:
        memcpy(to, &is_true, sizeof is_true);
        return;
    case SCENE_CHOICE:
        put_choice(node, v, to);
        return;
    case SCENE_TEXT:
        snprintf(to, v->bytes, "%s", node->value);
        return;
    case SCENE_VECTOR:
        for (int i = 0; v->repeats && node->kind == SCENE_NODE_SCALAR && i < v->most; i++)
            put(node, v->entry, NULL, to + (size_t)i * v->entry->bytes);
        for (int i = 0; i < node->n; i++) put(node->child[i], v->entry, NULL, to + (size_t)i * v->entry->bytes);
        return;
    case SCENE_SECTION:
        if (v->is_allocated) {
            char *section = allocate(1, v->bytes);
            memcpy(to, &section, sizeof section);
            to = section;
        }
        put_section(node, v, to);
        return;
    case SCENE_LIST:
        break;
    }
    ENSURE(0, "a value of type %d in %s", (int)v->type, key ? key->name : "a list");
}

struct scene *scene_load(const struct scene_node *root) {
    struct scene *s = NULL;
    put(root, &scene_table_scene, NULL, (char *)&s);
    return s;
}

/* Frees what a section holds; not the section. */
static void release(const struct scene_value *v, char *from) {
    for (const struct scene_key *key = v->type == SCENE_SECTION ? v->keys : NULL; key && key->name; key++) {
        const struct scene_value *its = &key->value;
        char *at = from + key->offset, *held = at;
        int n = 1;
        if (its->type == SCENE_LIST) memcpy(&n, from + its->count, sizeof n);
        if (its->type == SCENE_LIST || its->is_allocated) memcpy(&held, at, sizeof held);
        for (int i = 0; held && i < n; i++)
            release(its->type == SCENE_LIST ? its->entry : its, held + (size_t)i * its->bytes);
        if (held != at) free(held);
    }
}

void scene_load_free(struct scene *s) {
    if (s) release(&scene_table_scene, (char *)s);
    free(s);
}
