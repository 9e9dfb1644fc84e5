/* The part of the JSON Schema that says what a scene's parts, its dimension and its method allow and need elsewhere. */
#include "scene/rules/describe_where.h"
#include "base/text.h"
#include "scene/rules/describe_beside.h"

#include <stdlib.h>

/* What of a scene decides on keys elsewhere. has: 1 where the scene has it, 0 where it has not. */
struct where {
    enum scene_need part;
    int has;
};

/* The condition that domain.size has at most or at least so many numbers, in a scene without fluid or any. */
static void write_size(struct json *j, const char *limit, long numbers) {
    json_object(j, "properties");
    json_object(j, "domain");
    json_object(j, "properties");
    json_object(j, "size");
    json_text(j, "type", "array");
    json_long(j, limit, numbers);
    json_close(j);
    json_close(j);
    scene_describe_beside_required(j, "size");
    json_close(j);
    json_close(j);
    scene_describe_beside_required(j, "domain");
}

static void write_galerkin(struct json *j) {
    json_object(j, "properties");
    json_object(j, "solid");
    json_object(j, "properties");
    json_object(j, "method");
    scene_describe_beside_words(j, "enum", "element_free");
    json_close(j);
    json_close(j);
    scene_describe_beside_required(j, "method");
    json_close(j);
    json_close(j);
    scene_describe_beside_required(j, "solid");
}

/* Keywords of the condition that a scene has the part. */
static void write_has(struct json *j, enum scene_need part) {
    switch (part) {
    case SCENE_WITH_FLUID:
        scene_describe_beside_required(j, "fluid");
        break;
    case SCENE_WITH_SOLID:
        scene_describe_beside_required(j, "solid");
        break;
    case SCENE_WITHOUT_FLUID:
        json_object(j, "not");
        scene_describe_beside_required(j, "fluid");
        json_close(j);
        break;
    case SCENE_IN_3D:
        write_size(j, "minItems", 3);
        break;
    case SCENE_IN_PLATE: /* a scene with a fluid has none */
        json_object(j, "not");
        scene_describe_beside_required(j, "fluid");
        json_close(j);
        write_size(j, "maxItems", 2);
        break;
    case SCENE_GALERKIN:
        write_galerkin(j);
        break;
    case SCENE_STEPPED:
        json_object(j, "not");
        json_array(j, "anyOf");
        json_object(j, NULL);
        scene_describe_beside_required(j, "nonlocal");
        json_close(j);
        json_object(j, NULL);
        write_galerkin(j);
        for (int k = 0; k < 3; k++) json_close(j);
        break;
    case SCENE_ALWAYS:
        break;
    }
}

static int is_forbidden(const struct scene_rule *rule, const struct where *at) {
    return !at->has && rule->only & at->part;
}

static int is_asked(const struct scene_rule *rule, const struct where *at) {
    return at->has && (rule->needed & at->part || (rule->needed & SCENE_ALWAYS && rule->only == (int)at->part));
}

/* The words of a choice, or the numbers of a vector or of a list of vectors, that the dimension allows. */
static int is_narrowed(const cyaml_schema_value_t *v, const struct scene_rule *rule, const struct where *at) {
    const int plate = at->part == SCENE_IN_PLATE, any = at->has && (plate || at->part == SCENE_IN_3D);
    const int in_list = v->type == CYAML_SEQUENCE && (rule->bare || scene_describe_beside_is_vector(v->sequence.entry));
    if (v->type == CYAML_ENUM) return any && rule->choices[!plate] != NULL;
    return any && (scene_describe_beside_is_vector(v) || in_list) && !(rule->only & (SCENE_IN_3D | SCENE_WITH_FLUID));
}

static const cyaml_schema_value_t *entry_of(const cyaml_schema_value_t *v) {
    return v->type == CYAML_SEQUENCE ? v->sequence.entry : v;
}

/* Whether a mapping, or something in it, has a key that depends on the part. */
static int depends(const cyaml_schema_value_t *v, const char *path, const struct where *at) {
    int found = 0;
    v = entry_of(v);
    for (const cyaml_schema_field_t *f = v->type == CYAML_MAPPING ? v->mapping.fields : NULL; f && f->key && !found;
         f++) {
        char *inner = *path ? text_new("%s.%s", path, f->key) : text_new("%s", f->key);
        const struct scene_rule *rule = scene_rule_find(inner);
        found = is_forbidden(rule, at) || is_asked(rule, at) || is_narrowed(&f->value, rule, at);
        char *deeper = text_new("%s%s", inner, f->value.type == CYAML_SEQUENCE ? "[]" : "");
        found = found || depends(&f->value, deeper, at);
        free(deeper);
        free(inner);
    }
    return found;
}

static void write_there(struct json *j, const cyaml_schema_value_t *v, const char *path, const struct where *at);

/* One key of a mapping: what the part narrows of its value, and what is below it. */
static void write_below(struct json *j, const cyaml_schema_field_t *f, const char *path, const struct where *at) {
    const struct scene_rule *rule = scene_rule_find(path);
    const int is_list = f->value.type == CYAML_SEQUENCE, plate = at->part == SCENE_IN_PLATE;
    char *deeper = text_new("%s%s", path, is_list ? "[]" : "");
    const int further = depends(&f->value, deeper, at), narrowed = is_narrowed(&f->value, rule, at);
    if (further || narrowed) json_object(j, f->key);
    if (narrowed && f->value.type == CYAML_ENUM) scene_describe_beside_words(j, "enum", rule->choices[!plate]);
    if (is_list && (further || narrowed)) json_object(j, "items");
    if (narrowed && f->value.type != CYAML_ENUM) json_long(j, plate ? "maxItems" : "minItems", plate ? 2 : 3);
    if (further) write_there(j, entry_of(&f->value), deeper, at);
    if (is_list && (further || narrowed)) json_close(j);
    if (further || narrowed) json_close(j);
    free(deeper);
}

/* Keywords of a mapping in scenes that have the part, or have it not. */
static void write_there(struct json *j, const cyaml_schema_value_t *v, const char *path, const struct where *at) {
    int forbidden = 0, asked = 0;
    json_object(j, "properties");
    for (const cyaml_schema_field_t *f = v->mapping.fields; f->key; f++) {
        char *inner = *path ? text_new("%s.%s", path, f->key) : text_new("%s", f->key);
        forbidden += is_forbidden(scene_rule_find(inner), at);
        asked += is_asked(scene_rule_find(inner), at);
        write_below(j, f, inner, at);
        free(inner);
    }
    json_close(j);
    if (forbidden + asked) json_array(j, "allOf");
    for (const cyaml_schema_field_t *f = v->mapping.fields; forbidden + asked && f->key; f++) {
        char *inner = *path ? text_new("%s.%s", path, f->key) : text_new("%s", f->key);
        const struct scene_rule *rule = scene_rule_find(inner);
        if (is_asked(rule, at)) scene_describe_beside_need(j, f->key, rule, inner);
        if (is_forbidden(rule, at)) {
            json_object(j, NULL);
            json_object(j, "not");
            scene_describe_beside_required(j, f->key);
            json_close(j);
            json_close(j);
        }
        free(inner);
    }
    if (forbidden + asked) json_close(j);
}

/* Entries of the scene's allOf: what its parts, its dimension and its method say of keys elsewhere. */
void scene_describe_where(struct json *j) {
    static const enum scene_need part[] = {SCENE_WITH_FLUID, SCENE_WITH_SOLID, SCENE_WITHOUT_FLUID, SCENE_IN_3D,
                                           SCENE_IN_PLATE,   SCENE_STEPPED,    SCENE_GALERKIN};
    for (size_t k = 0; k < 2 * sizeof part / sizeof *part; k++) {
        const struct where at = {part[k / 2], k % 2 == 0};
        if (!depends(&scene_schema, "", &at)) continue;
        json_object(j, NULL);
        json_object(j, "if");
        if (!at.has) json_object(j, "not");
        write_has(j, at.part);
        if (!at.has) json_close(j);
        json_close(j);
        json_object(j, "then");
        write_there(j, &scene_schema, "", &at);
        json_close(j);
        json_close(j);
    }
}
