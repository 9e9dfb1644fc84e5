/* Parses YAML into the scene's tree and writes the tree as YAML. */
#include "scene/text/yaml.h"
#include "base/die.h"
#include "base/ensure.h"
#include "base/text.h"
#include "base/files/read_file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <yaml.h>

enum { DEPTH = 32, LONGEST_KEY = 1024 /* of a YAML key without a question mark */ };

struct reader {
    yaml_parser_t parser;
    yaml_event_t event;
    int line;  /* of a mistake */
    char *why; /* NULL: none so far */
    const char *what;
    const char *text;
    size_t bytes;
};

static int fail(struct reader *r, int line, char *why) {
    if (r->why)
        free(why);
    else {
        r->why = why;
        r->line = line;
    }
    return 0;
}

static int line_at(const struct reader *r, size_t offset) {
    int line = 1;
    for (size_t i = 0; i < offset && i < r->bytes; i++) line += r->text[i] == '\n';
    return line;
}

/* Reads the next event into r->event. */
static int next(struct reader *r) {
    yaml_event_delete(&r->event);
    memset(&r->event, 0, sizeof r->event);
    if (yaml_parser_parse(&r->parser, &r->event)) return 1;
    const yaml_parser_t *p = &r->parser;
    int line = (int)(p->problem_mark.line ? p->problem_mark.line : p->context_mark.line) + 1;
    if (p->error == YAML_READER_ERROR) line = line_at(r, p->problem_offset); /* the bytes are not valid text */
    const char *problem = p->problem ? p->problem : "unreadable";
    if (!p->context) return fail(r, line, text_new("not valid YAML: %s", problem));
    const int begun = (int)p->context_mark.line + 1;
    if (p->problem_mark.index - p->context_mark.index > LONGEST_KEY && strstr(p->context, "simple key"))
        return fail(r, begun,
                    text_new("not valid YAML: a key is longer than %d characters, or has no ':'", LONGEST_KEY));
    if (begun < line &&
        strstr(p->context, "quoted scalar")) /* a quote that is not closed: the line is where the file ends */
        return fail(r, line, text_new("not valid YAML: %s that begins on line %d: %s", p->context, begun, problem));
    return fail(r, line, text_new("not valid YAML: %s: %s", p->context, problem));
}

static int line_of(const struct reader *r) { return (int)r->event.start_mark.line + 1; }

static struct scene_node *scalar(struct reader *r, const char *key) {
    const char *value = (const char *)r->event.data.scalar.value;
    if (strlen(value) != r->event.data.scalar.length) {
        fail(r, line_of(r), text_new("a text holds a zero byte"));
        return NULL;
    }
    struct scene_node *node = scene_node_new(SCENE_NODE_SCALAR, key, value);
    node->quoted = r->event.data.scalar.style != YAML_PLAIN_SCALAR_STYLE;
    node->line = line_of(r);
    return node;
}

static struct scene_node *value(struct reader *r, const char *key, int depth);

/* Key and value pairs until the mapping ends. */
static int pairs(struct reader *r, struct scene_node *mapping, int depth) {
    for (;;) {
        if (!next(r)) return 0;
        if (r->event.type == YAML_MAPPING_END_EVENT) return 1;
        if (r->event.type != YAML_SCALAR_EVENT) return fail(r, line_of(r), text_new("a key must be a word"));
        struct scene_node *key = scalar(r, NULL);
        if (!key) return 0;
        const int line = key->line;
        struct scene_node *node = next(r) ? value(r, key->value, depth + 1) : NULL;
        scene_node_free(key);
        if (!node) return 0;
        node->line = line;
        scene_node_append(mapping, node);
    }
}

static int items(struct reader *r, struct scene_node *list, int depth) {
    for (;;) {
        if (!next(r)) return 0;
        if (r->event.type == YAML_SEQUENCE_END_EVENT) return 1;
        struct scene_node *node = value(r, NULL, depth + 1);
        if (!node) return 0;
        scene_node_append(list, node);
    }
}

/* The value that r->event begins; NULL and r->why where it cannot be read. */
static struct scene_node *value(struct reader *r, const char *key, int depth) {
    const int line = line_of(r);
    if (depth > DEPTH) {
        fail(r, line, text_new("lists and mappings are nested more than %d deep", DEPTH));
        return NULL;
    }
    if (r->event.type == YAML_SCALAR_EVENT) return scalar(r, key);
    if (r->event.type == YAML_ALIAS_EVENT) {
        fail(r, line,
             text_new("an alias (*%s) is not read in a %s: write the value out",
                      (const char *)r->event.data.alias.anchor, r->what));
        return NULL;
    }
    if (r->event.type != YAML_MAPPING_START_EVENT && r->event.type != YAML_SEQUENCE_START_EVENT) {
        fail(r, line, text_new("a value is missing"));
        return NULL;
    }
    const int is_mapping = r->event.type == YAML_MAPPING_START_EVENT;
    struct scene_node *node = scene_node_new(is_mapping ? SCENE_NODE_MAPPING : SCENE_NODE_LIST, key, NULL);
    node->line = line;
    if (is_mapping ? pairs(r, node, depth) : items(r, node, depth)) return node;
    scene_node_free(node);
    return NULL;
}

/* Parses one document with one value. *empty: 1 if there is none. */
static struct scene_node *document(struct reader *r, const char *text, size_t bytes, int *empty) {
    struct scene_node *root = NULL;
    *empty = 0;
    r->text = text;
    r->bytes = bytes;
    if (!yaml_parser_initialize(&r->parser)) die(EXIT_CODE_FILE, "no memory left for the scene");
    yaml_parser_set_input_string(&r->parser, (const unsigned char *)text, bytes);
    if (next(r) && next(r)) { /* start of stream, start of document */
        if (r->event.type == YAML_STREAM_END_EVENT)
            *empty = 1;
        else if (next(r))
            root = value(r, NULL, 0);
        if (root && next(r) && next(r) && r->event.type != YAML_STREAM_END_EVENT)
            fail(r, line_of(r), text_new("a second document begins: a %s is one", r->what));
    }
    yaml_event_delete(&r->event);
    yaml_parser_delete(&r->parser);
    if (r->why) {
        scene_node_free(root);
        root = NULL;
    }
    return root;
}

/* Whether the line is indented by a tab, which YAML does not allow. */
static int has_tab(const char *text, size_t bytes, int line) {
    size_t i = 0;
    for (int l = 1; l < line && i < bytes; i++) l += text[i] == '\n';
    while (i < bytes && text[i] == ' ') i++;
    return i < bytes && text[i] == '\t';
}

struct scene_node *scene_yaml_parse(const char *text, size_t bytes, struct scene_problems *problems) {
    static const struct scene_yaml_what scene = {"scene", "domain: ..., fluid: ..., stages: ..."};
    return scene_yaml_parse_as(&scene, text, bytes, problems);
}

struct scene_node *scene_yaml_parse_as(const struct scene_yaml_what *what, const char *text, size_t bytes,
                                       struct scene_problems *problems) {
    struct reader r = {.what = what->name};
    int empty;
    struct scene_node *root = document(&r, text, bytes, &empty);
    if (r.why)
        scene_problem_line(problems, r.line, "%s%s", r.why,
                           has_tab(text, bytes, r.line) ? " (the line is indented by a tab: use spaces)" : "");
    free(r.why);
    if (empty || (root && root->kind == SCENE_NODE_SCALAR && !*root->value && !root->quoted)) {
        scene_problem_line(problems, 0, "the %s is empty", what->name);
    } else if (root && root->kind != SCENE_NODE_MAPPING) {
        scene_problem_line(problems, root->line, "a %s must be a mapping (%s)", what->name, what->example);
    } else {
        return root;
    }
    scene_node_free(root);
    return NULL;
}

struct scene_node *scene_yaml_read(const char *path) {
    struct scene_problems problems = {.file = path};
    char *text = read_file(path);
    struct scene_node *root = text ? scene_yaml_parse(text, strlen(text), &problems) : NULL;
    scene_problem_free(&problems);
    free(text);
    return root;
}

struct scene_node *scene_yaml_parse_value(const char *text, char **why) {
    struct reader r = {.what = "scene"};
    int empty;
    struct scene_node *node = document(&r, text, strlen(text), &empty);
    *why = r.why;
    if (empty) node = scene_node_new(SCENE_NODE_SCALAR, NULL, "");
    return node;
}

static int all_scalars(const struct scene_node *list) {
    for (int i = 0; i < list->n; i++)
        if (list->child[i]->kind != SCENE_NODE_SCALAR) return 0;
    return 1;
}

static int emit_scalar(yaml_emitter_t *e, const char *text, int quoted) {
    yaml_event_t event;
    return yaml_scalar_event_initialize(&event, NULL, NULL, (const yaml_char_t *)text, -1, 1, 1,
                                        quoted ? YAML_DOUBLE_QUOTED_SCALAR_STYLE : YAML_ANY_SCALAR_STYLE) &&
           yaml_emitter_emit(e, &event);
}

static int emit_node(yaml_emitter_t *e, const struct scene_node *node) {
    yaml_event_t event;
    if (node->kind == SCENE_NODE_SCALAR) return emit_scalar(e, node->value, node->quoted);
    const int is_mapping = node->kind == SCENE_NODE_MAPPING;
    int ok = is_mapping
                 ? yaml_mapping_start_event_initialize(&event, NULL, NULL, 1,
                                                       node->n ? YAML_BLOCK_MAPPING_STYLE : YAML_FLOW_MAPPING_STYLE)
                 : yaml_sequence_start_event_initialize(
                       &event, NULL, NULL, 1, all_scalars(node) ? YAML_FLOW_SEQUENCE_STYLE : YAML_BLOCK_SEQUENCE_STYLE);
    ok = ok && yaml_emitter_emit(e, &event);
    for (int i = 0; ok && i < node->n; i++)
        ok = (!is_mapping || emit_scalar(e, node->child[i]->key, 0)) && emit_node(e, node->child[i]);
    ok = ok && (is_mapping ? yaml_mapping_end_event_initialize(&event) : yaml_sequence_end_event_initialize(&event));
    return ok && yaml_emitter_emit(e, &event);
}

char *scene_yaml_emit(const struct scene_node *root) {
    char *text = NULL;
    size_t bytes = 0;
    FILE *out = open_memstream(&text, &bytes);
    yaml_emitter_t e;
    yaml_event_t event;
    if (!out || !yaml_emitter_initialize(&e)) die(EXIT_CODE_FILE, "no memory left for the scene");
    yaml_emitter_set_output_file(&e, out);
    yaml_emitter_set_width(&e, -1);
    yaml_emitter_set_unicode(&e, 1);
    const int ok = yaml_stream_start_event_initialize(&event, YAML_UTF8_ENCODING) && yaml_emitter_emit(&e, &event) &&
                   yaml_document_start_event_initialize(&event, NULL, NULL, NULL, 1) && yaml_emitter_emit(&e, &event) &&
                   emit_node(&e, root) && yaml_document_end_event_initialize(&event, 1) &&
                   yaml_emitter_emit(&e, &event) && yaml_stream_end_event_initialize(&event) &&
                   yaml_emitter_emit(&e, &event);
    ENSURE(ok, "%s", e.problem ? e.problem : "the scene could not be written as YAML");
    yaml_emitter_delete(&e);
    fclose(out);
    return text;
}
