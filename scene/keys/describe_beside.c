/* Parts of the JSON Schema that are about one key: with which keys it may stand, and where it is needed. */
#include "scene/keys/describe_beside.h"
#include "base/text.h"

#include <stdlib.h>
#include <string.h>

int scene_describe_beside_is_vector(const struct scene_value *v) { return v->type == SCENE_VECTOR && v->most == 3; }

void scene_describe_beside_words(struct json *j, const char *name, const char *words) {
    json_array(j, name);
    for (const char *at = words; *at; at += strcspn(at, " "), at += *at == ' ') {
        char *word = text_new("%.*s", (int)strcspn(at, " "), at);
        json_text(j, NULL, word);
        free(word);
    }
    json_close(j);
}

void scene_describe_beside_required(struct json *j, const char *name) {
    json_array(j, "required");
    json_text(j, NULL, name);
    json_close(j);
}

/* The condition that the key's sibling has one of the values that the key needs: given, or, if `by_default`, left out
 * where its default is one of them and it is itself allowed. */
static void write_sibling(struct json *j, const struct scene_key *keys, const struct scene_key *key, int certain) {
    const struct scene_key *s = scene_key_beside(keys, key->sibling);
    char *values = scene_key_values(keys, key);
    const int may_be_left = s && s->fallback && scene_key_is_among(s->fallback, values) &&
                            !(certain && (s->only || s->with || s->not_with));
    const int open = json_open(j, "properties");
    json_object(j, key->sibling);
    scene_describe_beside_words(j, "enum", values);
    free(values);
    json_close_to(j, open);
    if (!may_be_left) scene_describe_beside_required(j, key->sibling);
    if (!may_be_left || !certain || !s->sibling) return;
    json_open(j, "anyOf[] -");
    scene_describe_beside_required(j, key->sibling);
    json_close(j);
    json_object(j, NULL);
    write_sibling(j, keys, s, certain);
    json_close_to(j, open);
}

/* An entry of allOf: the key is needed where its siblings allow it. */
void scene_describe_beside_need(struct json *j, const struct scene_key *keys, const struct scene_key *key) {
    const int open = json_open(j, "-");
    if (key->sibling || key->with) {
        json_object(j, "if");
        if (key->sibling)
            write_sibling(j, keys, key, 1);
        else
            scene_describe_beside_required(j, key->with);
        json_close(j);
        json_object(j, "then");
    }
    if (key->not_with) {
        json_open(j, "anyOf[] -");
        scene_describe_beside_required(j, key->not_with);
        json_close(j);
        json_object(j, NULL);
    }
    scene_describe_beside_required(j, key->name);
    json_close_to(j, open);
}

/* Whether the key is needed in each scene, where the keys beside it allow it. */
static int is_needed_beside(const struct scene_key *key) {
    return key->needed & SCENE_ALWAYS && !key->only && !scene_key_is_needed(key);
}

int scene_describe_beside_has_conditions(const struct scene_key *key) {
    return key->sibling || key->with || key->not_with || is_needed_beside(key);
}

/* Entries of allOf for a key: with which keys it may stand, and where it is needed. */
void scene_describe_beside_conditions(struct json *j, const struct scene_key *keys, const struct scene_key *key) {
    if (key->sibling) {
        const int open = json_open(j, "- if");
        scene_describe_beside_required(j, key->name);
        json_close_to(j, open + 1);
        json_object(j, "then");
        write_sibling(j, keys, key, 0);
        json_close_to(j, open);
    }
    if (key->with) {
        const int open = json_open(j, "- dependencies");
        scene_describe_beside_words(j, key->name, key->with);
        json_close_to(j, open);
    }
    if (key->not_with) {
        const int open = json_open(j, "- not required[]");
        json_text(j, NULL, key->name);
        json_text(j, NULL, key->not_with);
        json_close_to(j, open);
    }
    if (is_needed_beside(key)) scene_describe_beside_need(j, keys, key);
}
