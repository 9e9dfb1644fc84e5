/* Checks the scene's tree against the tables of keys: unknown, missing and wrong keys, ranges, types. */
#include "base/ensure.h"
#include "base/text.h"
#include "scene/keys/walk.h"
#include "scene/text/yaml.h"

#include <stdlib.h>
#include <string.h>

static void check_value(struct scene_walk *w, struct scene_node *node, const struct scene_value *v,
                        const struct scene_key *key, const char *path);

/* Replaces a wrong or missing value by one that can be loaded. */
static void stand_in(struct scene_walk *w, struct scene_node *node, const struct scene_value *v, const char *path) {
    scene_node_clear(node);
    node->bad = 1;
    node->kind = v->type == SCENE_SECTION                           ? SCENE_NODE_MAPPING
                 : v->type == SCENE_LIST || v->type == SCENE_VECTOR ? SCENE_NODE_LIST
                                                                    : SCENE_NODE_SCALAR;
    if (node->kind == SCENE_NODE_SCALAR) {
        const char *value = v->type == SCENE_SWITCH ? "false" : v->type == SCENE_CHOICE ? v->words[0].word : "1";
        node->value = text_new("%s", value);
    }
    if (node->kind == SCENE_NODE_LIST)
        for (int i = 0; i < v->least; i++) {
            struct scene_node *item = scene_node_new(SCENE_NODE_SCALAR, NULL, NULL);
            scene_node_append(node, item);
            char *inner = text_new("%s[%d]", path, i);
            stand_in(w, item, v->entry, inner);
            free(inner);
        }
    if (node->kind == SCENE_NODE_MAPPING) {
        const int silent = w->silent;
        w->silent = 1;
        check_value(w, node, v, NULL, path);
        w->silent = silent;
    }
}

/* Wraps a list in a mapping: [x, y] becomes {at: [x, y]}. */
static void wrap(struct scene_node *node, const char *key) {
    struct scene_node *list = scene_node_new(SCENE_NODE_LIST, key, NULL);
    list->line = node->line;
    list->set = node->set ? text_new("%s", node->set) : NULL;
    list->set_inner = 1;
    while (node->n > 0) {
        scene_node_insert(list, 0, node->child[node->n - 1]);
        node->n--;
    }
    node->kind = SCENE_NODE_MAPPING;
    scene_node_append(node, list);
}

/* Turns a mapping into a list: {1: quartz} becomes [{label: 1, material: quartz}]. */
static void list_named(struct scene_node *node, const char *const named[2]) {
    node->kind = SCENE_NODE_LIST;
    for (int i = 0; i < node->n; i++) {
        struct scene_node *value = node->child[i], *entry = scene_node_new(SCENE_NODE_MAPPING, NULL, NULL),
                          *key = scene_node_new(SCENE_NODE_SCALAR, named[0], value->key);
        entry->line = key->line = value->line;
        if (value->set || node->set) entry->set = text_new("%s", value->set ? value->set : node->set);
        entry->set_inner = key->set_inner = value->set_inner = 1;
        free(value->key);
        value->key = text_new("%s", named[1]);
        scene_node_append(entry, key);
        scene_node_append(entry, value);
        node->child[i] = entry;
    }
}

static int check_list(struct scene_walk *w, struct scene_node *node, const struct scene_value *v,
                      const struct scene_key *key, const char *path) {
    const struct scene_value *entry = v->entry;
    if (key && key->named[0] && node->kind == SCENE_NODE_MAPPING) list_named(node, key->named);
    const int fixed = v->type == SCENE_VECTOR, is_list = node->kind == SCENE_NODE_LIST;
    if (v->repeats && node->kind == SCENE_NODE_SCALAR) {
        check_value(w, node, v->entry, key, path);
        return 1;
    }
    const int entries = fixed ? scene_walk_place_entries(w, v, path) : 0;
    if (fixed && (!is_list || (entries ? node->n != entries : node->n != 2 && node->n != 3))) {
        scene_walk_place_say_entries(w, node, v, key, path);
        return 0;
    }
    if (!is_list) {
        SCENE_WALK_PROBLEM(value, w, node, path, "must be a list of %s", scene_walk_place_entry_name(entry));
        return 0;
    }
    if (!fixed && node->n < v->least) {
        if (node->n == 0)
            SCENE_WALK_PROBLEM(key, w, node, path, "is empty: needs at least %s entr%s", v->least > 1 ? "two" : "one",
                               v->least > 1 ? "ies" : "y");
        else
            SCENE_WALK_PROBLEM(key, w, node, path, "has %d entry, needs at least %d", node->n, v->least);
        return 0;
    }
    if (node->n > v->most) {
        SCENE_WALK_PROBLEM(key, w, node, path, "has %d entries, at most %d are possible", node->n, v->most);
        return 0;
    }
    for (int i = 0; i < node->n; i++) {
        char *inner = text_new("%s[%d]", path, i);
        if (!fixed && key && key->bare && node->child[i]->kind == SCENE_NODE_LIST) wrap(node->child[i], key->bare);
        check_value(w, node->child[i], entry, fixed || entry->type == SCENE_VECTOR ? key : NULL, inner);
        free(inner);
    }
    return 1;
}

static char *path_of(const char *path, const char *key) {
    return *path ? text_new("%s.%s", path, key) : text_new("%s", key);
}

/* Why a key of earlier scenes is no longer there, or NULL. */
static const char *why_gone(const char *path) {
    static const char *const strong[] = {"coupling.scheme", "coupling.relaxation", "coupling.tolerance",
                                         "coupling.iterations"};
    for (size_t k = 0; k < sizeof strong / sizeof *strong; k++)
        if (!strcmp(path, strong[k]))
            return "no longer a key, leave it out: with coupling.load: reaction, the default, fluid and solid need no "
                   "iterations within a step";
    return NULL;
}

/* Drops keys that are given twice. An unknown key is taken for the known key that it is nearest to, unless that one is
 * given as well; other unknown keys are dropped. */
static void check_unknown(struct scene_walk *w, struct scene_node *node, int n, const char *const *known,
                          const char *path) {
    for (int i = 0; i < node->n; i++) {
        struct scene_node *c = node->child[i];
        char *inner = path_of(path, c->key);
        int first = 0, k = 0;
        while (strcmp(node->child[first]->key, c->key) != 0) first++;
        while (k < n && strcmp(known[k], c->key) != 0) k++;
        int drop = first < i || k == n;
        if (first < i) {
            SCENE_WALK_PROBLEM(key, w, c, inner, "is given twice, first on line %d", node->child[first]->line);
        } else if (k == n) {
            const char *gone = why_gone(inner), *nearest = gone ? NULL : scene_problem_nearest(c->key, n, known);
            char *allowed = scene_key_joined(n, known);
            if (gone)
                SCENE_WALK_PROBLEM(key, w, c, inner, "%s", gone);
            else if (nearest)
                SCENE_WALK_PROBLEM(key, w, c, inner, "unknown key; did you mean %s?", nearest);
            else
                SCENE_WALK_PROBLEM(key, w, c, inner, "unknown key; known here: %s", allowed);
            free(allowed);
            if (nearest && !scene_node_child(node, nearest)) {
                free(c->key);
                c->key = text_new("%s", nearest);
                c->bad = 1;
                drop = 0;
            }
        }
        if (drop) scene_node_drop(node, i--);
        free(inner);
    }
}

/* Fills in the default of a key that is left out, or reports the missing key. */
static void check_missing(struct scene_walk *w, struct scene_node *node, const struct scene_key *key,
                          const char *path) {
    const int asked = key->needed & (w->parts | SCENE_ALWAYS);
    struct scene_node *c = NULL;
    if (key->fallback && !asked) {
        char *why = NULL;
        const int in_plate = w->dimension == 2;
        c = scene_yaml_parse_value(in_plate && key->in_plate ? key->in_plate : key->fallback, &why);
        ENSURE(c, "default of %s: %s", path, why);
        if (in_plate && c->kind == SCENE_NODE_LIST && c->n == 3) scene_node_drop(c, 2);
        c->key = text_new("%s", key->name);
        c->line = node->line;
    } else if (asked) {
        const struct scene_node place = {
            .kind = SCENE_NODE_MAPPING, .line = node->line, .set = node->set, .set_inner = 1};
        const struct scene_node *s = key->sibling ? scene_node_child(node, key->sibling) : NULL;
        char *unit = scene_key_in_units(key);
        c = scene_node_new(SCENE_NODE_SCALAR, key->name, NULL);
        c->line = node->line;
        if (s)
            SCENE_WALK_PROBLEM(key, w, &place, path, "missing; %s %s needs it%s", key->sibling, s->value, unit);
        else
            SCENE_WALK_PROBLEM(key, w, &place, path, "missing%s%s",
                               key->needed & SCENE_WITH_FLUID ? "; a scene with a fluid needs it" : "", unit);
        free(unit);
        stand_in(w, c, &key->value, path);
    }
    if (!c) return;
    scene_node_append(node, c);
    if (!c->bad) check_value(w, c, &key->value, key, path);
}

static int check_mapping(struct scene_walk *w, struct scene_node *node, const struct scene_value *v, const char *path) {
    if (node->kind != SCENE_NODE_MAPPING) {
        SCENE_WALK_PROBLEM(value, w, node, path, "must be a mapping of keys to values%s",
                           node->kind == SCENE_NODE_SCALAR && !*node->value ? ", is empty" : "");
        return 0;
    }
    const char *known[SCENE_WALK_KEYS];
    int n = 0;
    for (; v->keys[n].name; n++) {
        ENSURE(n < SCENE_WALK_KEYS, "more than %d keys in %s", SCENE_WALK_KEYS, path);
        known[n] = v->keys[n].name;
    }
    check_unknown(w, node, n, known, path);
    if (!*path) {
        w->dimension = scene_walk_place_dimension(node);
        w->parts = (w->dimension == 2   ? SCENE_IN_PLATE
                    : w->dimension == 3 ? SCENE_IN_3D
                                        : 0) |
                   (scene_node_child(node, "fluid") ? SCENE_WITH_FLUID : SCENE_WITHOUT_FLUID) |
                   (scene_node_child(node, "solid") ? SCENE_WITH_SOLID : 0) |
                   (scene_walk_place_is_galerkin(node)   ? SCENE_GALERKIN
                    : scene_node_child(node, "nonlocal") ? 0
                                                         : SCENE_STEPPED);
    }
    for (int k = 0; k < n; k++) {
        char *inner = path_of(path, known[k]);
        const struct scene_key *key = &v->keys[k];
        int at = 0, unsure = 0;
        while (at < node->n && strcmp(node->child[at]->key, known[k]) != 0) at++;
        char *why = scene_walk_place_why_not(w, node, v->keys, key, &unsure);
        if (at < node->n && why) {
            SCENE_WALK_PROBLEM(value, w, node->child[at], inner, "%s", why);
            scene_node_drop(node, at);
        } else if (at < node->n) {
            check_value(w, node->child[at], &key->value, key, inner);
        } else if (!why && !unsure) {
            check_missing(w, node, key, inner);
        }
        free(why);
        free(inner);
    }
    for (int k = n - 1; k >= 0; k--) /* sorts into the table's order: each key is moved to the front, the last one
                                      * first */
        for (int i = 0; i < node->n; i++)
            if (!strcmp(node->child[i]->key, known[k])) {
                struct scene_node *c = node->child[i];
                memmove(node->child + 1, node->child, (size_t)i * sizeof(struct scene_node *));
                node->child[0] = c;
                break;
            }
    return 1;
}

static void check_value(struct scene_walk *w, struct scene_node *node, const struct scene_value *v,
                        const struct scene_key *key, const char *path) {
    int good = 0;
    switch (v->type) {
    case SCENE_WHOLE:
    case SCENE_NUMBER:
        good = scene_walk_scalar_number(w, node, v, key, path);
        break;
    case SCENE_SWITCH:
        good = node->kind == SCENE_NODE_SCALAR && (!strcmp(node->value, "true") || !strcmp(node->value, "false"));
        if (!good) SCENE_WALK_PROBLEM(value, w, node, path, "must be true or false");
        break;
    case SCENE_CHOICE:
        good = scene_walk_scalar_choice(w, node, v, path);
        break;
    case SCENE_TEXT:
        good = scene_walk_scalar_text(w, node, v, path);
        break;
    case SCENE_LIST:
    case SCENE_VECTOR:
        good = check_list(w, node, v, key, path);
        break;
    case SCENE_SECTION:
        good = check_mapping(w, node, v, path);
        break;
    }
    if (!good) stand_in(w, node, v, path);
}

void scene_walk(struct scene_node *root, struct scene_problems *problems) {
    struct scene_walk w = {.problems = problems};
    check_value(&w, root, &scene_table_scene, NULL, "");
}
