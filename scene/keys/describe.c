/* Writes the scene's JSON Schema, and the list of its keys. */
#include "scene/keys/describe.h"
#include "base/ensure.h"
#include "base/text.h"
#include "base/version.h"
#include "base/files/json.h"
#include "frana_scene_page.h"
#include "scene/keys/describe_beside.h"
#include "scene/keys/describe_where.h"
#include "scene/text/yaml.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* path: in docs/scene.md. */
static void write_value(struct json *j, const struct scene_value *v, const struct scene_key *key, const char *path);

/* What docs/scene.md says of the key at such a path: the last cell of its row; malloc'ed. */
static char *meaning(const char *path) {
    const char *page = (const char *)frana_scene_page;
    char *start = text_new("| `%s` | ", path);
    const char *row = strstr(page, start), *cell = row ? row + strlen(start) : NULL;
    for (int k = 0; cell && k < 3; k++) cell = strstr(cell, "|") ? strstr(cell, "|") + 1 : NULL;
    free(start);
    if (!cell) return text_new("%s", "");
    while (*cell == ' ') cell++;
    int n = (int)strcspn(cell, "\n");
    while (n > 0 && (cell[n - 1] == '|' || cell[n - 1] == ' ')) n--;
    return text_new("%.*s", n, cell);
}

/* "in a plate", "in a scene with a fluid and in 3D": malloc'ed. */
static char *places(int parts) {
    static const struct {
        int part;
        const char *text;
    } place[] = {{SCENE_WITH_FLUID, "with a fluid"},
                 {SCENE_WITH_SOLID, "with a solid"},
                 {SCENE_WITHOUT_FLUID, "without fluid"},
                 {SCENE_IN_3D, "in 3D"},
                 {SCENE_IN_PLATE, "in a plate"},
                 {SCENE_STEPPED, "stepped through stages"},
                 {SCENE_GALERKIN, "solved by element_free"},
                 {SCENE_ALWAYS, "of any kind"}};
    char *text = text_new("%s", "");
    for (size_t k = 0; k < sizeof place / sizeof *place; k++) {
        if (!(parts & place[k].part)) continue;
        char *longer = text_new("%s%s%s", text, *text ? " and " : "", place[k].text);
        free(text);
        text = longer;
    }
    return text;
}

/* Appends a sentence; frees both. */
static char *with(char *text, char *sentence) {
    char *longer = text_new("%s%s%s", text, *text && *sentence ? ". " : "", sentence);
    free(text);
    free(sentence);
    return longer;
}

/* The sentences on the places of a key. */
static char *with_place(char *text, const struct scene_key *keys, const struct scene_key *key) {
    char *plate = scene_key_words(key, SCENE_IN_PLATE), *space = scene_key_words(key, SCENE_IN_3D);
    char *only = places(key->only), *values = key->sibling ? scene_key_values(keys, key) : NULL;
    if (key->plate_high > 0) text = with(text, text_new("In a plate at most %.15g", key->plate_high));
    if (plate) text = with(text, text_new("In a plate: %s; in 3D: %s", plate, space));
    if (values) text = with(text, text_new("Only with %s: %s", key->sibling, values));
    if (key->with) text = with(text, text_new("Only together with %s", key->with));
    if (key->not_with) text = with(text, text_new("Not together with %s", key->not_with));
    if (key->only) text = with(text, text_new("Only in scenes %s", only));
    free(plate);
    free(space);
    free(only);
    free(values);
    return text;
}

static void write_description(struct json *j, const struct scene_key *keys, const struct scene_key *key,
                              const char *path) {
    char *text = meaning(path), *range = scene_key_range(key), *unit = scene_key_in_units(key),
         *parts = places(key->needed);
    if (*unit) text = with(text, text_new("Unit: %s", key->unit));
    if (range)
        text = with(text, text_new("Must be %s%s%s", range, key->word ? ", or " : "", key->word ? key->word : ""));
    text = with_place(text, keys, key);
    if (key->fallback)
        text = with(text, text_new("Default: %s", key->fallback));
    else if (key->needed)
        text = with(text, key->needed & SCENE_ALWAYS ? text_new("Needed") : text_new("Needed in scenes %s", parts));
    json_text(j, "description", text);
    free(text);
    free(range);
    free(unit);
    free(parts);
}

/* A value of YAML as JSON; .inf, which JSON lacks, is left out. */
static void write_node(struct json *j, const char *key, const struct scene_node *node) {
    char *end = NULL;
    const double value = node->kind == SCENE_NODE_SCALAR ? strtod(node->value, &end) : 0;
    switch (node->kind) {
    case SCENE_NODE_SCALAR:
        if (!strcmp(node->value, "true") || !strcmp(node->value, "false"))
            json_bool(j, key, node->value[0] == 't');
        else if (!strcmp(node->value, ".inf"))
            return;
        else if (*node->value && !*end)
            json_number(j, key, value);
        else
            json_text(j, key, node->value);
        return;
    case SCENE_NODE_LIST:
        json_array(j, key);
        break;
    case SCENE_NODE_MAPPING:
        json_object(j, key);
        break;
    }
    for (int i = 0; i < node->n; i++) write_node(j, node->child[i]->key, node->child[i]);
    json_close(j);
}

static void write_default(struct json *j, const struct scene_key *key) {
    char *why = NULL;
    struct scene_node *node = scene_yaml_parse_value(key->fallback, &why);
    ENSURE(node, "default of %s: %s", key->name, why);
    write_node(j, "default", node);
    scene_node_free(node);
}

static void write_number(struct json *j, const struct scene_value *v, const struct scene_key *key) {
    const int whole = v->type == SCENE_WHOLE, ranged = key && key->low != key->high;
    const int in_plate = ranged && key->plate_high > key->high, or_infinite = key && key->word && key->word[0] == '.';
    const double most = whole ? v->bytes == sizeof(int) ? INT_MAX : 9e15 : 1e300;
    const int or_word = key && key->word && !or_infinite, open = json_open(j, or_word ? "anyOf[] -" : "");
    if (or_word) {
        scene_describe_beside_words(j, "enum", key->word);
        json_close(j);
        json_object(j, NULL);
    }
    json_text(j, "type", whole ? "integer" : "number");
    json_number(j, ranged && key->open & 1 ? "exclusiveMinimum" : "minimum", ranged ? key->low : -most);
    if (ranged && isfinite(key->high))
        json_number(j, key->open & 2 && !in_plate ? "exclusiveMaximum" : "maximum",
                    in_plate ? key->plate_high : key->high);
    else if (!or_infinite)
        json_number(j, "maximum", most);
    json_close_to(j, open);
}

/* Words that YAML reads as true and false are these. */
static void write_choice(struct json *j, const struct scene_value *v) {
    json_array(j, "enum");
    for (int i = 0; i < v->most; i++) {
        const char *word = v->words[i].word;
        if (!strcmp(word, "true") || !strcmp(word, "false"))
            json_bool(j, NULL, *word == 't');
        else
            json_text(j, NULL, word);
    }
    json_close(j);
}

/* YAML reads a text such as 12 or true as a number or a switch. */
static void write_text(struct json *j, const struct scene_value *v) {
    scene_describe_beside_words(j, "type", "string number boolean");
    json_long(j, "minLength", v->least);
    json_long(j, "maxLength", v->most);
}

static void write_list(struct json *j, const struct scene_value *v, const struct scene_key *key, const char *path) {
    const int fixed = v->type == SCENE_VECTOR, named = key && key->named[0];
    const struct scene_value *entry = v->entry;
    char *inner = text_new("%s[]", path);
    const int open = json_open(j, v->repeats ? "anyOf[] -" : "");
    if (v->repeats) { /* 1.0e-6 for [1.0e-6, 1.0e-6, 1.0e-6] */
        write_value(j, entry, key, path);
        json_close(j);
        json_object(j, NULL);
    }
    if (named) { /* {1: quartz} */
        const int named_open = json_open(j, "anyOf[] -");
        json_text(j, "type", "object");
        json_object(j, "additionalProperties");
        scene_describe_beside_words(j, "type", "string number boolean");
        json_close_to(j, named_open + 1);
        json_object(j, NULL);
    }
    json_text(j, "type", "array");
    json_long(j, "minItems",
              scene_describe_beside_is_vector(v) && !(key && key->only & (SCENE_IN_3D | SCENE_WITH_FLUID)) ? 2
                                                                                                           : v->least);
    json_long(j, "maxItems", v->most);
    json_object(j, "items");
    if (key && key->bare) { /* [x, y] for {at: [x, y]} */
        const struct scene_key *bare = scene_key_beside(entry->keys, key->bare);
        char *list = scene_key_path(inner, bare);
        json_open(j, "anyOf[] -");
        write_value(j, &bare->value, bare, list);
        json_close(j);
        json_object(j, NULL);
        free(list);
    }
    write_value(j, entry, fixed || entry->type == SCENE_VECTOR ? key : NULL, inner);
    json_close_to(j, open);
    free(inner);
}

static void write_mapping(struct json *j, const struct scene_value *v, const char *path) {
    json_text(j, "type", "object");
    json_bool(j, "additionalProperties", 0);
    int needed = 0, conditions = 0;
    json_object(j, "properties");
    for (const struct scene_key *key = v->keys; key->name; key++) {
        char *inner = scene_key_path(path, key);
        json_object(j, key->name);
        write_description(j, v->keys, key, inner);
        if (key->fallback) write_default(j, key);
        write_value(j, &key->value, key, inner);
        json_close(j);
        needed += scene_key_is_needed(key);
        conditions += scene_describe_beside_has_conditions(key);
        free(inner);
    }
    json_close(j);
    if (needed) json_array(j, "required");
    for (const struct scene_key *key = v->keys; needed && key->name; key++)
        if (scene_key_is_needed(key)) json_text(j, NULL, key->name);
    if (needed) json_close(j);
    if (conditions) json_array(j, "allOf");
    for (const struct scene_key *key = v->keys; conditions && key->name; key++)
        scene_describe_beside_conditions(j, v->keys, key);
    if (!*path) scene_describe_where(j);
    if (conditions) json_close(j);
}

static void write_value(struct json *j, const struct scene_value *v, const struct scene_key *key, const char *path) {
    switch (v->type) {
    case SCENE_WHOLE:
    case SCENE_NUMBER:
        write_number(j, v, key);
        return;
    case SCENE_SWITCH:
        json_text(j, "type", "boolean");
        return;
    case SCENE_CHOICE:
        write_choice(j, v);
        return;
    case SCENE_TEXT:
        write_text(j, v);
        return;
    case SCENE_LIST:
    case SCENE_VECTOR:
        write_list(j, v, key, path);
        return;
    case SCENE_SECTION:
        write_mapping(j, v, path);
        return;
    }
    ENSURE(0, "%s has a type that no schema describes", path);
}

void scene_describe_schema(FILE *to) {
    struct json *j = json_begin_stream(to);
    json_text(j, "$schema", "http://json-schema.org/draft-07/schema#");
    json_text(j, "title", "A scene of frana " FRANA_VERSION);
    write_mapping(j, &scene_table_scene, "");
    json_end(j);
}

/* Returns the number of keys written. */
static int write_keys(FILE *to, const struct scene_value *v, const char *path, const char *beginning) {
    int written = 0;
    const struct scene_value *element = v->type == SCENE_LIST ? v->entry : v;
    for (const struct scene_key *key = element->type == SCENE_SECTION ? element->keys : NULL; key && key->name; key++) {
        char *section = text_new("%s%s", path, v->type == SCENE_LIST ? "[]" : "");
        char *inner = scene_key_path(section, key), *what = meaning(inner), *range = scene_key_range(key);
        if (!strncmp(inner, beginning, strlen(beginning)))
            written +=
                0 < fprintf(to, "%s\t%s\t%s\t%s%s%s\t%s\n", inner, key->unit,
                            key->fallback ? key->fallback
                            : key->needed ? "needed"
                                          : "none",
                            range ? range : "", range && key->word ? ", or " : "", key->word ? key->word : "", what);
        written += write_keys(to, &key->value, inner, beginning);
        free(section);
        free(inner);
        free(what);
        free(range);
        if (key->described) break; /* those after it are alike */
    }
    return written;
}

int scene_describe_keys(FILE *to, const char *beginning) { return write_keys(to, &scene_table_scene, "", beginning); }

char *scene_describe_key(const char *path) {
    char *described;
    const struct scene_key *key = scene_key_find(path, &described);
    char *what = key ? meaning(described) : NULL, *unit = scene_key_in_units(key);
    char *text = what && *what ? text_new("%s%s: %s", key->name, unit, what) : NULL;
    free(described);
    free(what);
    free(unit);
    return text;
}
