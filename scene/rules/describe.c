/* Writes the scene's JSON Schema, and the list of its keys. */
#include "scene/rules/describe.h"
#include "base/ensure.h"
#include "base/text.h"
#include "base/version.h"
#include "base/files/json.h"
#include "frana_scene_page.h"
#include "scene/rules/describe_beside.h"
#include "scene/rules/describe_where.h"
#include "scene/rules/rule.h"
#include "scene/rules/schema.h"
#include "scene/rules/walk.h"
#include "scene/text/yaml.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static void write_value(struct json *j, const cyaml_schema_value_t *v, const struct scene_rule *rule, const char *path);

/* What docs/scene.md says of the key: the last cell of its row; malloc'ed. */
static char *meaning(const struct scene_rule *rule) {
    const char *page = (const char *)frana_scene_page;
    char *start = text_new("| `%s` | ", rule->path);
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

static void write_description(struct json *j, const struct scene_rule *rule, int needed) {
    char *text = meaning(rule), *range = scene_rule_range(rule), *only = places(rule->only);
    char *unit = scene_rule_in_units(rule), *parts = places(rule->needed);
    if (*unit) text = with(text, text_new("Unit: %s", rule->unit));
    if (range)
        text = with(text, text_new("Must be %s%s%s", range, rule->word ? ", or " : "", rule->word ? rule->word : ""));
    if (rule->plate_high > 0) text = with(text, text_new("In a plate at most %.15g", rule->plate_high));
    if (rule->choices[0]) text = with(text, text_new("In a plate: %s; in 3D: %s", rule->choices[0], rule->choices[1]));
    if (rule->sibling) text = with(text, text_new("Only with %s: %s", rule->sibling, rule->values));
    if (rule->with) text = with(text, text_new("Only together with %s", rule->with));
    if (rule->not_with) text = with(text, text_new("Not together with %s", rule->not_with));
    if (rule->only) text = with(text, text_new("Only in scenes %s", only));
    if (rule->fallback)
        text = with(text, text_new("Default: %s", rule->fallback));
    else if (needed || rule->needed)
        text = with(text, needed || rule->needed & SCENE_ALWAYS ? text_new("Needed")
                                                                : text_new("Needed in scenes %s", parts));
    json_text(j, "description", text);
    free(text);
    free(range);
    free(only);
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

static void write_default(struct json *j, const struct scene_rule *rule) {
    char *why = NULL;
    struct scene_node *node = scene_yaml_parse_value(rule->fallback, &why);
    ENSURE(node, "default of %s: %s", rule->path, why);
    write_node(j, "default", node);
    scene_node_free(node);
}

static void write_number(struct json *j, const cyaml_schema_value_t *v, const struct scene_rule *rule) {
    const int whole = v->type == CYAML_INT, ranged = rule && rule->low != rule->high;
    const int in_plate = ranged && rule->plate_high > rule->high,
              or_infinite = rule && rule->word && rule->word[0] == '.';
    const double most = whole ? v->data_size == sizeof(int) ? INT_MAX : 9e15 : 1e300;
    if (rule && rule->word && !or_infinite) {
        json_array(j, "anyOf");
        json_object(j, NULL);
        scene_describe_beside_words(j, "enum", rule->word);
        json_close(j);
        json_object(j, NULL);
    }
    json_text(j, "type", whole ? "integer" : "number");
    json_number(j, ranged && rule->open & 1 ? "exclusiveMinimum" : "minimum", ranged ? rule->low : -most);
    if (ranged && isfinite(rule->high))
        json_number(j, rule->open & 2 && !in_plate ? "exclusiveMaximum" : "maximum",
                    in_plate ? rule->plate_high : rule->high);
    else if (!or_infinite)
        json_number(j, "maximum", most);
    if (rule && rule->word && !or_infinite) {
        json_close(j);
        json_close(j);
    }
}

/* Words that YAML reads as true and false are these. */
static void write_choice(struct json *j, const cyaml_schema_value_t *v) {
    json_array(j, "enum");
    for (uint32_t i = 0; i < v->enumeration.count; i++) {
        const char *word = v->enumeration.strings[i].str;
        if (!strcmp(word, "true") || !strcmp(word, "false"))
            json_bool(j, NULL, *word == 't');
        else
            json_text(j, NULL, word);
    }
    json_close(j);
}

/* YAML reads a text such as 12 or true as a number or a switch. */
static void write_text(struct json *j, const cyaml_schema_value_t *v) {
    scene_describe_beside_words(j, "type", "string number boolean");
    json_long(j, "minLength", v->string.min);
    json_long(j, "maxLength", v->string.max);
}

static void write_list(struct json *j, const cyaml_schema_value_t *v, const struct scene_rule *rule, const char *path) {
    const int fixed = v->type == CYAML_SEQUENCE_FIXED, named = rule && rule->named[0];
    const cyaml_schema_value_t *entry = v->sequence.entry;
    char *inner = text_new("%s[]", path);
    if (named) { /* {1: quartz} */
        json_array(j, "anyOf");
        json_object(j, NULL);
        json_text(j, "type", "object");
        json_object(j, "additionalProperties");
        scene_describe_beside_words(j, "type", "string number boolean");
        json_close(j);
        json_close(j);
        json_object(j, NULL);
    }
    json_text(j, "type", "array");
    json_long(j, "minItems",
              scene_describe_beside_is_vector(v) && !(rule && rule->only & (SCENE_IN_3D | SCENE_WITH_FLUID))
                  ? 2
                  : v->sequence.min);
    json_long(j, "maxItems", v->sequence.max);
    json_object(j, "items");
    if (rule && rule->bare) { /* [x, y] for {at: [x, y]} */
        char *list = text_new("%s.%s", inner, rule->bare);
        const cyaml_schema_field_t *f = entry->mapping.fields;
        while (strcmp(f->key, rule->bare) != 0) f++;
        json_array(j, "anyOf");
        json_object(j, NULL);
        write_value(j, &f->value, scene_rule_find(list), list);
        json_close(j);
        json_object(j, NULL);
        free(list);
    }
    write_value(j, entry, fixed || entry->type == CYAML_SEQUENCE_FIXED ? rule : NULL, inner);
    for (int k = 0; k < 2 * (rule && rule->bare); k++) json_close(j);
    json_close(j);
    for (int k = 0; k < 2 * named; k++) json_close(j);
    free(inner);
}

static int is_needed(const cyaml_schema_field_t *f, const struct scene_rule *rule) {
    return !(f->value.flags & CYAML_FLAG_OPTIONAL) && !(rule && (rule->fallback || rule->only));
}

static void write_mapping(struct json *j, const cyaml_schema_value_t *v, const char *path) {
    json_text(j, "type", "object");
    json_bool(j, "additionalProperties", 0);
    int needed = 0, conditions = 0;
    json_object(j, "properties");
    for (const cyaml_schema_field_t *f = v->mapping.fields; f->key; f++) {
        char *inner = *path ? text_new("%s.%s", path, f->key) : text_new("%s", f->key);
        const struct scene_rule *rule = scene_rule_find(inner);
        ENSURE(rule, "no rule of %s", inner);
        json_object(j, f->key);
        write_description(j, rule, is_needed(f, rule));
        if (rule->fallback) write_default(j, rule);
        write_value(j, &f->value, rule, inner);
        json_close(j);
        needed += is_needed(f, rule);
        conditions += rule->sibling || rule->with || rule->not_with || (rule->needed & SCENE_ALWAYS && !rule->only);
        free(inner);
    }
    json_close(j);
    if (needed) json_array(j, "required");
    for (const cyaml_schema_field_t *f = v->mapping.fields; needed && f->key; f++) {
        char *inner = *path ? text_new("%s.%s", path, f->key) : text_new("%s", f->key);
        if (is_needed(f, scene_rule_find(inner))) json_text(j, NULL, f->key);
        free(inner);
    }
    if (needed) json_close(j);
    if (conditions) json_array(j, "allOf");
    for (const cyaml_schema_field_t *f = v->mapping.fields; conditions && f->key; f++) {
        char *inner = *path ? text_new("%s.%s", path, f->key) : text_new("%s", f->key);
        scene_describe_beside_conditions(j, f->key, scene_rule_find(inner), inner);
        free(inner);
    }
    if (!*path) scene_describe_where(j);
    if (conditions) json_close(j);
}

static void write_value(struct json *j, const cyaml_schema_value_t *v, const struct scene_rule *rule,
                        const char *path) {
    switch (v->type) {
    case CYAML_INT:
    case CYAML_FLOAT:
        write_number(j, v, rule);
        return;
    case CYAML_BOOL:
        json_text(j, "type", "boolean");
        return;
    case CYAML_ENUM:
        write_choice(j, v);
        return;
    case CYAML_STRING:
        write_text(j, v);
        return;
    case CYAML_SEQUENCE:
    case CYAML_SEQUENCE_FIXED:
        write_list(j, v, rule, path);
        return;
    case CYAML_MAPPING:
        write_mapping(j, v, path);
        return;
    case CYAML_UINT:
    case CYAML_FLAGS:
    case CYAML_BITFIELD:
    case CYAML_IGNORE:
    case CYAML__TYPE_COUNT:
        break;
    }
    ENSURE(0, "%s has a type that no schema describes", path);
}

void scene_describe_schema(FILE *to) {
    struct json *j = json_begin_stream(to);
    json_text(j, "$schema", "http://json-schema.org/draft-07/schema#");
    json_text(j, "title", "A scene of frana " FRANA_VERSION);
    write_mapping(j, &scene_schema, "");
    json_end(j);
}

/* Returns the number of keys written. */
static int write_keys(FILE *to, const cyaml_schema_value_t *v, const char *path, const char *beginning) {
    int written = 0;
    const int is_side = !strcmp(path, "fluid.sides");
    if (v->type == CYAML_SEQUENCE) {
        char *inner = text_new("%s[]", path);
        written += write_keys(to, v->sequence.entry, inner, beginning);
        free(inner);
    }
    if (v->type != CYAML_MAPPING) return written;
    for (const cyaml_schema_field_t *f = v->mapping.fields; f->key; f++) {
        char *inner = is_side ? text_new("fluid.sides.SIDE") : text_new("%s%s%s", path, *path ? "." : "", f->key);
        const struct scene_rule *rule = scene_rule_find(inner);
        const int needed = !(f->value.flags & CYAML_FLAG_OPTIONAL) || rule->needed;
        char *what = meaning(rule), *range = scene_rule_range(rule);
        if (!strncmp(inner, beginning, strlen(beginning)))
            written +=
                0 < fprintf(to, "%s\t%s\t%s\t%s%s%s\t%s\n", inner, rule->unit,
                            rule->fallback ? rule->fallback
                            : needed       ? "needed"
                                           : "none",
                            range ? range : "", range && rule->word ? ", or " : "", rule->word ? rule->word : "", what);
        free(what);
        free(range);
        written += write_keys(to, &f->value, inner, beginning);
        free(inner);
        if (is_side) break; /* all six are alike */
    }
    return written;
}

int scene_describe_keys(FILE *to, const char *beginning) { return write_keys(to, &scene_schema, "", beginning); }

char *scene_describe_key(const char *path) {
    const struct scene_rule *rule = scene_rule_find(path);
    char *what = rule ? meaning(rule) : NULL, *unit = scene_rule_in_units(rule);
    const char *dot = strrchr(path, '.');
    char *text = what && *what ? text_new("%s%s: %s", dot ? dot + 1 : path, unit, what) : NULL;
    free(what);
    free(unit);
    return text;
}
