/* Decides where a key may appear: together with which other keys, in which scenes, in a plate or in 3D. */
#include "base/ensure.h"
#include "base/text.h"
#include "scene/keys/walk.h"

#include <stdlib.h>
#include <string.h>

/* Turns "a b c" into "a, b or c": malloc'ed. */
static char *alternatives(const char *list) {
    char *text = text_new("%s", "");
    for (const char *at = list; *at; at += strcspn(at, " "), at += *at == ' ') {
        const int n = (int)strcspn(at, " ");
        char *longer = text_new("%s%s%.*s", text, at == list ? "" : at[n] ? ", " : " or ", n, at);
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

/* Why the key is not allowed with the parts that the scene has. */
static char *lacks(const struct scene_walk *w, int only, int *unsure) {
    const int both = SCENE_WITH_FLUID | SCENE_WITH_SOLID, lacking = only & ~w->parts;
    if (lacking & (SCENE_IN_3D | SCENE_IN_PLATE)) {
        *unsure = w->dimension == 0;
        if (*unsure) return NULL;
        return text_new("%s", lacking & SCENE_IN_3D ? "not in a plate, which has no fluid yet"
                                                    : "only in a plate, where domain.size has two numbers");
    }
    if (lacking & SCENE_STEPPED)
        return text_new("only in a scene that is stepped through stages; this one is solved at once");
    if (lacking & SCENE_WITHOUT_FLUID) return text_new("only in a scene without fluid");
    if (lacking && (only & both) == both) return text_new("only in a scene with both fluid and solid");
    if (lacking) return text_new("only in a scene with a %s", lacking & SCENE_WITH_SOLID ? "solid" : "fluid");
    return NULL;
}

char *scene_walk_place_why_not(const struct scene_walk *w, const struct scene_node *mapping,
                               const struct scene_key *keys, const struct scene_key *key, int *unsure) {
    *unsure = 0;
    char *reason = lacks(w, key->only, unsure);
    if (reason || *unsure) return reason;
    if (key->not_with && scene_node_child(mapping, key->not_with))
        return text_new("not together with %s", key->not_with);
    if (key->with && !scene_node_child(mapping, key->with)) {
        *unsure = has_bad_child(mapping);
        return *unsure ? NULL : text_new("only together with %s", key->with);
    }
    if (!key->sibling) return NULL;
    const struct scene_node *s = scene_node_child(mapping, key->sibling);
    *unsure = s ? s->bad : has_bad_child(mapping);
    if (*unsure) return NULL;
    char *values = scene_key_values(keys, key);
    if (s && s->kind == SCENE_NODE_SCALAR && scene_key_is_among(s->value, values)) {
        free(values);
        return NULL;
    }
    char *list = alternatives(values);
    free(values);
    reason = s ? text_new("only with %s %s, here it is %s", key->sibling, list, s->value)
               : text_new("only with %s %s", key->sibling, list);
    free(list);
    return reason;
}

int scene_walk_place_dimension(const struct scene_node *root) {
    static const char *const key[] = {"size", "cells", "periodic"};
    if (scene_node_child(root, "fluid")) return 3;
    const struct scene_node *domain = scene_node_child(root, "domain"), *size = NULL;
    for (int i = 0; domain && domain->kind == SCENE_NODE_MAPPING && i < domain->n; i++) {
        const char *nearest = scene_problem_nearest(domain->child[i]->key, 3, key);
        if (nearest == key[0]) size = domain->child[i];
    }
    return size && size->kind == SCENE_NODE_LIST && (size->n == 2 || size->n == 3) ? size->n : 0;
}

int scene_walk_place_is_galerkin(const struct scene_node *root) {
    const struct scene_node *solid = scene_node_child(root, "solid");
    const struct scene_node *method =
        solid && solid->kind == SCENE_NODE_MAPPING ? scene_node_child(solid, "method") : NULL;
    return method && method->kind == SCENE_NODE_SCALAR && !strcmp(method->value, "element_free");
}

const char *scene_walk_place_entry_name(const struct scene_value *entry) {
    switch (entry->type) {
    case SCENE_WHOLE:
        return "whole numbers";
    case SCENE_NUMBER:
        return "numbers";
    case SCENE_SWITCH:
        return "true or false";
    case SCENE_VECTOR:
        return "lists of numbers";
    case SCENE_TEXT:
        return "names";
    case SCENE_SECTION:
        return "mappings";
    case SCENE_CHOICE:
    case SCENE_LIST:
        break;
    }
    ENSURE(0, "a list of entries of type %d", (int)entry->type);
}

int scene_walk_place_entries(const struct scene_walk *w, const struct scene_value *v, const char *path) {
    const int most = v->most, is_size = !strcmp(path, "domain.size");
    if (most != 3 || (is_size && w->parts & SCENE_WITH_FLUID)) return most;
    return w->dimension;
}

void scene_walk_place_say_entries(struct scene_walk *w, const struct scene_node *node, const struct scene_value *v,
                                  const struct scene_key *key, const char *path) {
    const int is_size = !strcmp(path, "domain.size"), is_vector = v->most == 3;
    const char *more = is_size && w->dimension == 0                               ? ", or of 2 for a plate"
                       : is_size && node->kind == SCENE_NODE_LIST && node->n == 2 ? ": a plate, of 2, has no fluid yet"
                       : is_vector && w->dimension == 2                           ? " in a plate"
                       : v->repeats                                               ? ", or one that counts for all"
                                                                                  : "";
    char *unit = scene_key_in_units(key);
    SCENE_WALK_PROBLEM(value, w, node, path, "must be a list of %d %s%s%s",
                       is_vector && w->dimension == 2 ? 2 : v->most, scene_walk_place_entry_name(v->entry), unit, more);
    free(unit);
}
