/* The part of the JSON Schema that says what a scene's parts, its dimension and its method allow and need elsewhere. */
#include "scene/keys/describe_where.h"
#include "scene/keys/describe_beside.h"

#include <stdlib.h>

/* What of a scene decides on keys elsewhere. has: 1 where the scene has it, 0 where it has not. */
struct where {
    enum scene_need part;
    int has;
};

/* The condition that domain.size has at most or at least so many numbers, in a scene without fluid or any. */
static void write_size(struct json *j, const char *limit, long numbers) {
    const int open = json_open(j, "properties domain properties size");
    json_text(j, "type", "array");
    json_long(j, limit, numbers);
    json_close_to(j, open + 2);
    scene_describe_beside_required(j, "size");
    json_close_to(j, open);
    scene_describe_beside_required(j, "domain");
}

static void write_galerkin(struct json *j) {
    const int open = json_open(j, "properties solid properties method");
    scene_describe_beside_words(j, "enum", "element_free");
    json_close_to(j, open + 2);
    scene_describe_beside_required(j, "method");
    json_close_to(j, open);
    scene_describe_beside_required(j, "solid");
}

static void write_not(struct json *j, const char *key) {
    json_object(j, "not");
    scene_describe_beside_required(j, key);
    json_close(j);
}

/* Keywords of the condition that a scene has the part. */
static void write_has(struct json *j, enum scene_need part) {
    int open;
    switch (part) {
    case SCENE_WITH_FLUID:
        scene_describe_beside_required(j, "fluid");
        break;
    case SCENE_WITH_SOLID:
        scene_describe_beside_required(j, "solid");
        break;
    case SCENE_WITHOUT_FLUID:
        write_not(j, "fluid");
        break;
    case SCENE_IN_3D:
        write_size(j, "minItems", 3);
        break;
    case SCENE_IN_PLATE: /* a scene with a fluid has none */
        write_not(j, "fluid");
        write_size(j, "maxItems", 2);
        break;
    case SCENE_GALERKIN:
        write_galerkin(j);
        break;
    case SCENE_STEPPED:
        open = json_open(j, "not anyOf[] -");
        scene_describe_beside_required(j, "nonlocal");
        json_close(j);
        json_object(j, NULL);
        write_galerkin(j);
        json_close_to(j, open);
        break;
    case SCENE_ALWAYS:
        break;
    }
}

static int is_forbidden(const struct scene_key *key, const struct where *at) {
    return !at->has && key->only & at->part;
}

static int is_asked(const struct scene_key *key, const struct where *at) {
    return at->has && (key->needed & at->part || (key->needed & SCENE_ALWAYS && key->only == (int)at->part));
}

/* The words of a choice, or the numbers of a vector or of a list of vectors, that the dimension allows. */
static int is_narrowed(const struct scene_key *key, const struct where *at) {
    const struct scene_value *v = &key->value;
    const int any = at->has && (at->part == SCENE_IN_PLATE || at->part == SCENE_IN_3D);
    const int in_list = v->type == SCENE_LIST && (key->bare || scene_describe_beside_is_vector(v->entry));
    if (v->type == SCENE_CHOICE) {
        char *words = any ? scene_key_words(key, at->part) : NULL;
        free(words);
        return words != NULL;
    }
    return any && (scene_describe_beside_is_vector(v) || in_list) && !(key->only & (SCENE_IN_3D | SCENE_WITH_FLUID));
}

/* The keys of a section, or of the sections in a list; NULL for other values. */
static const struct scene_key *keys_of(const struct scene_value *v) {
    return v->type == SCENE_LIST ? v->entry->keys : v->keys;
}

/* Whether one of the keys, or of those below them, depends on the part. */
static int depends(const struct scene_key *keys, const struct where *at) {
    for (const struct scene_key *key = keys; key && key->name; key++)
        if (is_forbidden(key, at) || is_asked(key, at) || is_narrowed(key, at) || depends(keys_of(&key->value), at))
            return 1;
    return 0;
}

static void write_there(struct json *j, const struct scene_key *keys, const struct where *at);

/* One key of a mapping: what the part narrows of its value, and what is below it. */
static void write_below(struct json *j, const struct scene_key *key, const struct where *at) {
    const int plate = at->part == SCENE_IN_PLATE;
    const int further = depends(keys_of(&key->value), at), narrowed = is_narrowed(key, at);
    char *words = narrowed ? scene_key_words(key, at->part) : NULL;
    if (!further && !narrowed) return;
    const int open = json_open(j, key->name);
    if (words) scene_describe_beside_words(j, "enum", words);
    if (key->value.type == SCENE_LIST) json_object(j, "items");
    if (narrowed && !words) json_long(j, plate ? "maxItems" : "minItems", plate ? 2 : 3);
    if (further) write_there(j, keys_of(&key->value), at);
    json_close_to(j, open);
    free(words);
}

/* Keywords of a mapping in scenes that have the part, or have it not. */
static void write_there(struct json *j, const struct scene_key *keys, const struct where *at) {
    int conditions = 0;
    json_object(j, "properties");
    for (const struct scene_key *key = keys; key->name; key++) {
        conditions += is_forbidden(key, at) || is_asked(key, at);
        write_below(j, key, at);
    }
    json_close(j);
    if (conditions) json_array(j, "allOf");
    for (const struct scene_key *key = keys; conditions && key->name; key++) {
        if (is_asked(key, at)) scene_describe_beside_need(j, keys, key);
        if (is_forbidden(key, at)) {
            json_object(j, NULL);
            write_not(j, key->name);
            json_close(j);
        }
    }
    if (conditions) json_close(j);
}

/* Entries of the scene's allOf: what its parts, its dimension and its method say of keys elsewhere. */
void scene_describe_where(struct json *j) {
    static const enum scene_need part[] = {SCENE_WITH_FLUID, SCENE_WITH_SOLID, SCENE_WITHOUT_FLUID, SCENE_IN_3D,
                                           SCENE_IN_PLATE,   SCENE_STEPPED,    SCENE_GALERKIN};
    for (size_t k = 0; k < 2 * sizeof part / sizeof *part; k++) {
        const struct where at = {part[k / 2], k % 2 == 0};
        if (!depends(scene_table_scene.keys, &at)) continue;
        const int open = json_open(j, at.has ? "- if" : "- if not");
        write_has(j, at.part);
        json_close_to(j, open + 1);
        json_object(j, "then");
        write_there(j, scene_table_scene.keys, &at);
        json_close_to(j, open);
    }
}
