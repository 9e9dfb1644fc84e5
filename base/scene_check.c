/* The tree against the schema and the rules. */
#include "base/scene_check.h"
#include "base/error.h"
#include "base/scene_walk.h"
#include "base/scene_yaml.h"

#include <stdlib.h>
#include <string.h>

static void check_value(struct scene_walk *w, struct scene_node *node, const cyaml_schema_value_t *v,
                        const struct scene_rule *rule, const char *path);

/* Puts a value that can be loaded where there is a wrong one or none. */
static void stand_in(struct scene_walk *w, struct scene_node *node, const cyaml_schema_value_t *v,
                     const char *path) {
    scene_node_clear(node);
    node->bad = 1;
    node->kind = v->type == CYAML_MAPPING                                       ? SCENE_NODE_MAPPING
                 : v->type == CYAML_SEQUENCE || v->type == CYAML_SEQUENCE_FIXED ? SCENE_NODE_LIST
                                                                                : SCENE_NODE_SCALAR;
    if (node->kind == SCENE_NODE_SCALAR) {
        const char *value = v->type == CYAML_BOOL   ? "false"
                            : v->type == CYAML_ENUM ? v->enumeration.strings[0].str
                                                    : "1";
        node->value = scene_text("%s", value);
    }
    if (node->kind == SCENE_NODE_LIST)
        for (uint32_t i = 0; i < v->sequence.min; i++) {
            struct scene_node *item = scene_node_new(SCENE_NODE_SCALAR, NULL, NULL);
            scene_node_append(node, item);
            char *inner = scene_text("%s[%u]", path, i);
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

static const char *entry_name(const cyaml_schema_value_t *entry) {
    switch (entry->type) {
    case CYAML_INT:
        return "whole numbers";
    case CYAML_FLOAT:
        return "numbers";
    case CYAML_BOOL:
        return "true or false";
    default:
        return "mappings";
    }
}

static int check_list(struct scene_walk *w, struct scene_node *node, const cyaml_schema_value_t *v,
                      const struct scene_rule *rule, const char *path) {
    const cyaml_schema_value_t *entry = v->sequence.entry;
    const int fixed = v->type == CYAML_SEQUENCE_FIXED, is_list = node->kind == SCENE_NODE_LIST;
    if (fixed && (!is_list || node->n != (int)v->sequence.max)) {
        char *unit = scene_walk_in_units(rule);
        SCENE_WALK_SAY(value, w, node, path, "must be a list of %u %s%s", v->sequence.max, entry_name(entry),
                       unit);
        free(unit);
        return 0;
    }
    if (!is_list) {
        SCENE_WALK_SAY(value, w, node, path, "must be a list of %s", entry_name(entry));
        return 0;
    }
    if (node->n < (int)v->sequence.min || node->n > (int)v->sequence.max) {
        SCENE_WALK_SAY(key, w, node, path,
                       node->n ? "has %d entries, at most %u are possible"
                               : "is empty: needs at least one entry",
                       node->n, v->sequence.max);
        return 0;
    }
    for (int i = 0; i < node->n; i++) {
        char *inner = scene_text("%s[%d]", path, i);
        check_value(w, node->child[i], entry, fixed ? rule : NULL, inner);
        free(inner);
    }
    return 1;
}

static char *path_of(const char *path, const char *key) {
    return *path ? scene_text("%s.%s", path, key) : scene_text("%s", key);
}

/* Keys given twice are dropped; unknown ones are taken for the key they come near to where that is not given, else dropped. */
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
                c->key = scene_text("%s", nearest);
                c->bad = 1;
                drop = 0;
            }
        }
        if (drop) scene_node_drop(node, i--);
        free(inner);
    }
}

static int is_among(const char *word, const char *list) {
    const size_t n = strlen(word);
    for (const char *at = list; *at; at += strcspn(at, " "), at += *at == ' ')
        if (strcspn(at, " ") == n && !strncmp(at, word, n)) return 1;
    return 0;
}

/* "a b c" as "a, b or c": malloc'ed. */
static char *alternatives(const char *list) {
    char *text = scene_text("%s", "");
    for (const char *at = list; *at; at += strcspn(at, " "), at += *at == ' ') {
        const int n = (int)strcspn(at, " ");
        char *longer = scene_text("%s%s%.*s", text, at == list ? "" : at[n] ? ", " : " or ", n, at);
        free(text);
        text = longer;
    }
    return text;
}

static int has_bad_child(const struct scene_node *mapping) {
    for (int i = 0; i < mapping->n; i++)
        if (mapping->child[i]->bad) return 1;
    return 0;
}

/* Why the key makes no sense in this scene, malloc'ed; NULL if it does. *unsure: what that rests on is itself wrong. */
static char *why_not(const struct scene_walk *w, const struct scene_node *mapping,
                     const struct scene_rule *rule, int *unsure) {
    const int both = SCENE_WITH_FLUID | SCENE_WITH_SOLID, lacking = rule ? rule->only & ~w->parts : 0;
    *unsure = 0;
    if (lacking & SCENE_WITHOUT_FLUID) return scene_text("only in a scene without fluid");
    if (lacking && (rule->only & both) == both)
        return scene_text("only in a scene with both fluid and solid");
    if (lacking) return scene_text("only in a scene with a solid");
    if (!rule || !rule->sibling) return NULL;
    const struct scene_node *s = scene_node_child(mapping, rule->sibling);
    *unsure = s ? s->bad : has_bad_child(mapping);
    if (*unsure || (s && s->kind == SCENE_NODE_SCALAR && is_among(s->value, rule->values))) return NULL;
    char *list = alternatives(rule->values);
    char *reason = s ? scene_text("only with %s %s, here it is %s", rule->sibling, list, s->value)
                     : scene_text("only with %s %s", rule->sibling, list);
    free(list);
    return reason;
}

/* What is left out: a default, or a mistake. */
static void check_missing(struct scene_walk *w, struct scene_node *node, const cyaml_schema_field_t *field,
                          const struct scene_rule *rule, const char *path) {
    const int needed =
        !(field->value.flags & CYAML_FLAG_OPTIONAL) || (rule && rule->needed & (w->parts | SCENE_ALWAYS));
    struct scene_node *c = NULL;
    if (rule && rule->fallback) {
        char *why = NULL;
        c = scene_yaml_parse_value(rule->fallback, &why);
        ENSURE(c, "default of %s: %s", path, why);
        c->key = scene_text("%s", field->key);
        c->line = node->line;
    } else if (needed) {
        const struct scene_node place = {
            .kind = SCENE_NODE_MAPPING, .line = node->line, .set = node->set, .set_inner = 1};
        const struct scene_node *s = rule && rule->sibling ? scene_node_child(node, rule->sibling) : NULL;
        char *unit = scene_walk_in_units(rule);
        c = scene_node_new(SCENE_NODE_SCALAR, field->key, NULL);
        c->line = node->line;
        if (s)
            SCENE_WALK_SAY(key, w, &place, path, "missing; %s %s needs it%s", rule->sibling, s->value, unit);
        else
            SCENE_WALK_SAY(key, w, &place, path, "missing%s%s",
                           rule && rule->needed & SCENE_WITH_FLUID ? "; a scene with a fluid needs it" : "",
                           unit);
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
    if (!*path)
        w->parts = (scene_node_child(node, "fluid") ? SCENE_WITH_FLUID : SCENE_WITHOUT_FLUID) |
                   (scene_node_child(node, "solid") ? SCENE_WITH_SOLID : 0);
    for (int k = 0; k < n; k++) {
        char *inner = path_of(path, known[k]);
        const struct scene_rule *rule = scene_rule_find(inner);
        int at = 0, unsure = 0;
        while (at < node->n && strcmp(node->child[at]->key, known[k]) != 0) at++;
        char *why = why_not(w, node, rule, &unsure);
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
    for (int k = n - 1; k >= 0; k--) /* into the schema's order: each to the front, last key first */
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
        good = node->kind == SCENE_NODE_SCALAR &&
               (!strcmp(node->value, "true") || !strcmp(node->value, "false"));
        if (!good) SCENE_WALK_SAY(value, w, node, path, "must be true or false");
        break;
    case CYAML_ENUM:
        good = scene_walk_choice(w, node, v, path);
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
    default:
        ENSURE(0, "%s has a type that no check knows", path);
    }
    if (!good) stand_in(w, node, v, path);
}

void scene_check_keys(struct scene_node *root, struct scene_problems *problems) {
    struct scene_walk w = {.problems = problems};
    check_value(&w, root, &scene_schema, NULL, "");
}
