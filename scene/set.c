/* Applies --set key.path=value to the scene's tree. */
#include "scene/set.h"
#include "base/text.h"
#include "scene/keys/key.h"
#include "scene/text/yaml.h"

#include <stdlib.h>
#include <string.h>

enum { NAMES = 64 };

struct setting {
    struct scene_problems *problems;
    const char *path; /* as the user typed it */
};

/* The next part of the path: a word or the inside of brackets, malloc'ed; NULL if it is malformed. */
static char *step_of(const char **path) {
    const char *at = *path;
    if (*at == '[') {
        const size_t n = strcspn(at + 1, "]");
        if (n == 0 || at[1 + n] != ']') return NULL;
        *path = at + n + 2;
        if (**path == '.' && !*++*path) return NULL;
        return text_new("%.*s", (int)n, at + 1);
    }
    const size_t n = strcspn(at, ".[");
    if (n == 0) return NULL;
    *path = at + n;
    if (**path == '.' && !*++*path) return NULL;
    return text_new("%.*s", (int)n, at);
}

static void mark(struct scene_node *node, const char *path, int inner) {
    free(node->set);
    node->set = text_new("%s", path);
    node->set_inner = inner;
    node->line = 0;
    for (int i = 0; i < node->n; i++) mark(node->child[i], path, 1);
}

static void refuse(const struct setting *s, char *message) {
    const struct scene_node place = {.kind = SCENE_NODE_MAPPING, .set = (char *)s->path};
    scene_problem_key(s->problems, &place, s->path, "%s", message);
    free(message);
}

/* Index of a list's entry given by index or name; -1 and a problem if there is none. */
static int entry_of(const struct setting *s, const struct scene_node *list, const char *step) {
    const char *list_name = list->key ? list->key : "the list";
    if (strspn(step, "0123456789") == strlen(step)) {
        const long i = strtol(step, NULL, 10);
        if (i < list->n) return (int)i;
        refuse(s, list->n ? text_new("there is no entry %s: %s has 0 to %d", step, list_name, list->n - 1)
                          : text_new("there is no entry %s: %s is empty", step, list_name));
        return -1;
    }
    const char *name[NAMES] = {0};
    int n = 0;
    for (int i = 0; i < list->n; i++) {
        const struct scene_node *c = scene_node_child(list->child[i], "name");
        if (!c || c->kind != SCENE_NODE_SCALAR) continue;
        if (!strcmp(c->value, step)) return i;
        if (n < NAMES) name[n++] = c->value;
    }
    const char *nearest = scene_problem_nearest(step, n, name);
    char *known = scene_key_joined(n, name);
    refuse(s, nearest ? text_new("there is no entry named %s; did you mean %s?", step, nearest)
              : n     ? text_new("there is no entry named %s in %s; named here: %s", step, list_name, known)
                      : text_new("there is no entry named %s in %s", step, list_name));
    free(known);
    return -1;
}

static int child_index(const struct scene_node *mapping, const char *key) {
    for (int i = 0; i < mapping->n; i++)
        if (!strcmp(mapping->child[i]->key, key)) return i;
    return -1;
}

/* Puts the value into the node; takes ownership of the value. */
static void put(const struct setting *s, struct scene_node *node, struct scene_node *value) {
    const char *path = s->path;
    char *step;
    while ((step = step_of(&path))) {
        int at;
        if (node->kind == SCENE_NODE_LIST) {
            at = entry_of(s, node, step);
        } else if (node->kind == SCENE_NODE_MAPPING) {
            at = child_index(node, step);
            if (at < 0) {
                struct scene_node *made = scene_node_new(SCENE_NODE_MAPPING, step, NULL);
                mark(made, s->path, 0);
                scene_node_append(node, made);
                at = node->n - 1;
            }
        } else {
            refuse(s, text_new("%s is a value: nothing is in it", node->key ? node->key : "the entry"));
            at = -1;
        }
        free(step);
        if (at < 0) {
            scene_node_free(value);
            return;
        }
        if (!*path) {
            value->key = node->child[at]->key ? text_new("%s", node->child[at]->key) : NULL;
            scene_node_free(node->child[at]);
            node->child[at] = value;
            mark(value, s->path, 0);
            return;
        }
        node = node->child[at];
    }
    refuse(s, text_new("not a path: write it as stages[0].steps or stages.flow.steps"));
    scene_node_free(value);
}

void scene_set(struct scene_node *root, int n, const char *const *set, struct scene_problems *problems) {
    for (int i = 0; i < n; i++) {
        const char *equals = strchr(set[i], '=');
        char *path = equals ? text_new("%.*s", (int)(equals - set[i]), set[i]) : text_new("%s", set[i]), *why = NULL;
        const struct setting s = {problems, path};
        struct scene_node *value = equals ? scene_yaml_parse_value(equals + 1, &why) : NULL;
        if (!equals)
            refuse(&s, text_new("needs a value: --set key.path=value"));
        else if (!value)
            refuse(&s, text_new("%s", why));
        else
            put(&s, root, value);
        free(why);
        free(path);
    }
}
