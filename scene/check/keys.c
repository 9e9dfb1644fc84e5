/* Checks the scene's tree against the schema and the rules: unknown, missing and wrong keys, ranges, types. */
#include "base/ensure.h"
#include "base/text.h"
#include "scene/check/check.h"
#include "scene/rules/walk.h"
#include "scene/text/yaml.h"

#include <stdlib.h>
#include <string.h>

static void check_value(struct scene_walk *w, struct scene_node *node, const cyaml_schema_value_t *v,
                        const struct scene_rule *rule, const char *path);

/* Replaces a wrong or missing value by one that can be loaded. */
static void stand_in(struct scene_walk *w, struct scene_node *node, const cyaml_schema_value_t *v, const char *path) {
    scene_node_clear(node);
    node->bad = 1;
    node->kind = v->type == CYAML_MAPPING                                       ? SCENE_NODE_MAPPING
                 : v->type == CYAML_SEQUENCE || v->type == CYAML_SEQUENCE_FIXED ? SCENE_NODE_LIST
                                                                                : SCENE_NODE_SCALAR;
    if (node->kind == SCENE_NODE_SCALAR) {
        const char *value = v->type == CYAML_BOOL   ? "false"
                            : v->type == CYAML_ENUM ? v->enumeration.strings[0].str
                                                    : "1";
        node->value = text_new("%s", value);
    }
    if (node->kind == SCENE_NODE_LIST)
        for (uint32_t i = 0; i < v->sequence.min; i++) {
            struct scene_node *item = scene_node_new(SCENE_NODE_SCALAR, NULL, NULL);
            scene_node_append(node, item);
            char *inner = text_new("%s[%u]", path, i);
            stand_in(w, item, v->sequence.entry, inner);
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

static int check_list(struct scene_walk *w, struct scene_node *node, const cyaml_schema_value_t *v,
                      const struct scene_rule *rule, const char *path) {
    const cyaml_schema_value_t *entry = v->sequence.entry;
    if (rule && rule->named[0] && node->kind == SCENE_NODE_MAPPING) list_named(node, rule->named);
    const int fixed = v->type == CYAML_SEQUENCE_FIXED, is_list = node->kind == SCENE_NODE_LIST;
    const int entries = fixed ? scene_walk_place_entries(w, v, path) : 0;
    if (fixed && (!is_list || (entries ? node->n != entries : node->n != 2 && node->n != 3))) {
        scene_walk_place_say_entries(w, node, v, rule, path);
        return 0;
    }
    if (!is_list) {
        SCENE_WALK_SAY(value, w, node, path, "must be a list of %s", scene_walk_place_entry_name(entry));
        return 0;
    }
    if (!fixed && node->n < (int)v->sequence.min) {
        if (node->n == 0)
            SCENE_WALK_SAY(key, w, node, path, "is empty: needs at least %s entr%s",
                           v->sequence.min > 1 ? "two" : "one", v->sequence.min > 1 ? "ies" : "y");
        else
            SCENE_WALK_SAY(key, w, node, path, "has %d entry, needs at least %u", node->n, v->sequence.min);
        return 0;
    }
    if (node->n > (int)v->sequence.max) {
        SCENE_WALK_SAY(key, w, node, path, "has %d entries, at most %u are possible", node->n, v->sequence.max);
        return 0;
    }
    for (int i = 0; i < node->n; i++) {
        char *inner = text_new("%s[%d]", path, i);
        if (!fixed && rule && rule->bare && node->child[i]->kind == SCENE_NODE_LIST) wrap(node->child[i], rule->bare);
        check_value(w, node->child[i], entry, fixed || entry->type == CYAML_SEQUENCE_FIXED ? rule : NULL, inner);
        free(inner);
    }
    if (fixed && node->n == 2 && v->sequence.max == 3) node->pad = entry->type == CYAML_BOOL ? "false" : "0";
    return 1;
}

static char *path_of(const char *path, const char *key) {
    return *path ? text_new("%s.%s", path, key) : text_new("%s", key);
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
            SCENE_WALK_SAY(key, w, c, inner, "is given twice, first on line %d", node->child[first]->line);
        } else if (k == n) {
            const char *nearest = scene_problem_nearest(c->key, n, known);
            char *allowed = scene_walk_joined(n, known);
            if (nearest)
                SCENE_WALK_SAY(key, w, c, inner, "unknown key; did you mean %s?", nearest);
            else
                SCENE_WALK_SAY(key, w, c, inner, "unknown key; known here: %s", allowed);
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
static void check_missing(struct scene_walk *w, struct scene_node *node, const cyaml_schema_field_t *field,
                          const struct scene_rule *rule, const char *path) {
    const int asked = rule && rule->needed & (w->parts | SCENE_ALWAYS),
              needed = !(field->value.flags & CYAML_FLAG_OPTIONAL) || asked;
    struct scene_node *c = NULL;
    if (rule && rule->fallback && !asked) {
        char *why = NULL;
        const int in_plate = w->dimension == 2;
        c = scene_yaml_parse_value(in_plate && rule->in_plate ? rule->in_plate : rule->fallback, &why);
        ENSURE(c, "default of %s: %s", path, why);
        if (in_plate && c->kind == SCENE_NODE_LIST && c->n == 3) scene_node_drop(c, 2);
        c->key = text_new("%s", field->key);
        c->line = node->line;
    } else if (needed) {
        const struct scene_node place = {
            .kind = SCENE_NODE_MAPPING, .line = node->line, .set = node->set, .set_inner = 1};
        const struct scene_node *s = rule && rule->sibling ? scene_node_child(node, rule->sibling) : NULL;
        char *unit = scene_rule_in_units(rule);
        c = scene_node_new(SCENE_NODE_SCALAR, field->key, NULL);
        c->line = node->line;
        if (s)
            SCENE_WALK_SAY(key, w, &place, path, "missing; %s %s needs it%s", rule->sibling, s->value, unit);
        else
            SCENE_WALK_SAY(key, w, &place, path, "missing%s%s",
                           rule && rule->needed & SCENE_WITH_FLUID ? "; a scene with a fluid needs it" : "", unit);
        free(unit);
        stand_in(w, c, &field->value, path);
    }
    if (!c) return;
    scene_node_append(node, c);
    if (!c->bad) check_value(w, c, &field->value, rule, path);
}

static int check_mapping(struct scene_walk *w, struct scene_node *node, const cyaml_schema_value_t *v,
                         const char *path) {
    if (node->kind != SCENE_NODE_MAPPING) {
        SCENE_WALK_SAY(value, w, node, path, "must be a mapping of keys to values%s",
                       node->kind == SCENE_NODE_SCALAR && !*node->value ? ", is empty" : "");
        return 0;
    }
    const cyaml_schema_field_t *fields = v->mapping.fields;
    const char *known[SCENE_WALK_KEYS];
    int n = 0;
    for (; fields[n].key; n++) {
        ENSURE(n < SCENE_WALK_KEYS, "more than %d keys in %s", SCENE_WALK_KEYS, path);
        known[n] = fields[n].key;
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
        const struct scene_rule *rule = scene_rule_find(inner);
        int at = 0, unsure = 0;
        while (at < node->n && strcmp(node->child[at]->key, known[k]) != 0) at++;
        char *why = scene_walk_place_why_not(w, node, rule, &unsure);
        if (at < node->n && why) {
            SCENE_WALK_SAY(value, w, node->child[at], inner, "%s", why);
            scene_node_drop(node, at);
        } else if (at < node->n) {
            check_value(w, node->child[at], &fields[k].value, rule, inner);
        } else if (!why && !unsure) {
            check_missing(w, node, &fields[k], rule, inner);
        }
        free(why);
        free(inner);
    }
    for (int k = n - 1; k >= 0; k--) /* sorts into the schema's order: each key is moved to the front, the last one
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

static void check_value(struct scene_walk *w, struct scene_node *node, const cyaml_schema_value_t *v,
                        const struct scene_rule *rule, const char *path) {
    int good = 0;
    switch (v->type) {
    case CYAML_INT:
    case CYAML_FLOAT:
        good = scene_walk_number(w, node, v, rule, path);
        break;
    case CYAML_BOOL:
        good = node->kind == SCENE_NODE_SCALAR && (!strcmp(node->value, "true") || !strcmp(node->value, "false"));
        if (!good) SCENE_WALK_SAY(value, w, node, path, "must be true or false");
        break;
    case CYAML_ENUM:
        good = scene_walk_choice(w, node, v, rule, path);
        break;
    case CYAML_STRING:
        good = scene_walk_text(w, node, v, path);
        break;
    case CYAML_SEQUENCE:
    case CYAML_SEQUENCE_FIXED:
        good = check_list(w, node, v, rule, path);
        break;
    case CYAML_MAPPING:
        good = check_mapping(w, node, v, path);
        break;
    case CYAML_UINT:
    case CYAML_FLAGS:
    case CYAML_BITFIELD:
    case CYAML_IGNORE:
    case CYAML__TYPE_COUNT:
        ENSURE(0, "%s has a type that no check knows", path);
    }
    if (!good) stand_in(w, node, v, path);
}

void scene_check_keys(struct scene_node *root, struct scene_problems *problems) {
    struct scene_walk w = {.problems = problems};
    check_value(&w, root, &scene_schema, NULL, "");
}
