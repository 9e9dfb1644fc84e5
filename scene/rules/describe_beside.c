/* Parts of the JSON Schema that are about one key: with which keys it may stand, and where it is needed. */
#include "scene/rules/describe_beside.h"
#include "base/text.h"
#include "scene/rules/walk.h"

#include <stdlib.h>
#include <string.h>

int scene_describe_beside_is_vector(const cyaml_schema_value_t *v) {
    return v->type == CYAML_SEQUENCE_FIXED && v->sequence.max == 3;
}

void scene_describe_beside_words(struct json *j, const char *key, const char *words) {
    json_array(j, key);
    for (const char *at = words; *at; at += strcspn(at, " "), at += *at == ' ') {
        char *word = text_new("%.*s", (int)strcspn(at, " "), at);
        json_text(j, NULL, word);
        free(word);
    }
    json_close(j);
}

void scene_describe_beside_required(struct json *j, const char *key) {
    json_array(j, "required");
    json_text(j, NULL, key);
    json_close(j);
}

/* The rule of a key beside `path`, or NULL. */
static const struct scene_rule *beside(const char *path, const char *key) {
    const char *dot = strrchr(path, '.');
    char *other = dot ? text_new("%.*s.%s", (int)(dot - path), path, key) : text_new("%s", key);
    const struct scene_rule *rule = scene_rule_find(other);
    free(other);
    return rule;
}

/* The condition that the rule's sibling has one of the values that the key needs: given, or, if `by_default`, left out
 * where its default is one of them and it is itself allowed. */
static void write_sibling(struct json *j, const char *path, const struct scene_rule *rule, int certain) {
    const struct scene_rule *s = beside(path, rule->sibling);
    const int may_be_left = s && s->fallback && scene_walk_place_is_among(s->fallback, rule->values) &&
                            !(certain && (s->only || s->with || s->not_with));
    json_object(j, "properties");
    json_object(j, rule->sibling);
    scene_describe_beside_words(j, "enum", rule->values);
    json_close(j);
    json_close(j);
    if (!may_be_left) scene_describe_beside_required(j, rule->sibling);
    if (!may_be_left || !certain || !s->sibling) return;
    json_array(j, "anyOf");
    json_object(j, NULL);
    scene_describe_beside_required(j, rule->sibling);
    json_close(j);
    json_object(j, NULL);
    write_sibling(j, path, s, certain);
    json_close(j);
    json_close(j);
}

/* An entry of allOf: the key is needed where its siblings allow it. */
void scene_describe_beside_need(struct json *j, const char *key, const struct scene_rule *rule, const char *path) {
    json_object(j, NULL);
    if (rule->sibling || rule->with) {
        json_object(j, "if");
        if (rule->sibling)
            write_sibling(j, path, rule, 1);
        else
            scene_describe_beside_required(j, rule->with);
        json_close(j);
        json_object(j, "then");
    }
    if (rule->not_with) {
        json_array(j, "anyOf");
        json_object(j, NULL);
        scene_describe_beside_required(j, rule->not_with);
        json_close(j);
        json_object(j, NULL);
    }
    scene_describe_beside_required(j, key);
    for (int k = 0; k < 2 * !!rule->not_with; k++) json_close(j);
    if (rule->sibling || rule->with) json_close(j);
    json_close(j);
}

/* Entries of allOf for a key: with which keys it may stand, and where it is needed. */
void scene_describe_beside_conditions(struct json *j, const char *key, const struct scene_rule *rule,
                                      const char *path) {
    if (rule->sibling) {
        json_object(j, NULL);
        json_object(j, "if");
        scene_describe_beside_required(j, key);
        json_close(j);
        json_object(j, "then");
        write_sibling(j, path, rule, 0);
        json_close(j);
        json_close(j);
    }
    if (rule->with) {
        json_object(j, NULL);
        json_object(j, "dependencies");
        json_array(j, key);
        json_text(j, NULL, rule->with);
        json_close(j);
        json_close(j);
        json_close(j);
    }
    if (rule->not_with) {
        json_object(j, NULL);
        json_object(j, "not");
        json_array(j, "required");
        json_text(j, NULL, key);
        json_text(j, NULL, rule->not_with);
        for (int k = 0; k < 3; k++) json_close(j);
    }
    if (rule->needed & SCENE_ALWAYS && !rule->only) scene_describe_beside_need(j, key, rule, path);
}
