/* Reads values from a JSON file by path. */
#include "base/files/json_read.h"
#include "base/files/plain_file.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <yaml.h>

/* JSON is a subset of YAML, so libyaml reads both. */
struct json_read {
    yaml_document_t document;
};

struct json_read *json_read_new(const char *path) {
    FILE *file = plain_file_read(path);
    if (!file) return NULL;
    struct json_read *t = calloc(1, sizeof *t);
    yaml_parser_t parser;
    yaml_parser_initialize(&parser);
    yaml_parser_set_input_file(&parser, file);
    const int good = yaml_parser_load(&parser, &t->document);
    yaml_parser_delete(&parser);
    fclose(file);
    if (!good) { /* libyaml has already freed the document */
        free(t);
        return NULL;
    }
    if (yaml_document_get_root_node(&t->document)) return t;
    json_read_free(t);
    return NULL;
}

void json_read_free(struct json_read *t) {
    if (!t) return;
    yaml_document_delete(&t->document);
    free(t);
}

/* libyaml's functions do not change the document, but take a non-const pointer. */
static yaml_document_t *document_of(const struct json_read *t) { return (yaml_document_t *)(size_t)&t->document; }

static yaml_node_t *find(const struct json_read *t, const char *path) {
    if (!t) return NULL;
    yaml_document_t *d = document_of(t);
    yaml_node_t *node = yaml_document_get_root_node(d);
    while (node && *path) {
        const size_t length = strcspn(path, ".");
        yaml_node_t *next = NULL;
        if (node->type == YAML_SCALAR_NODE) return NULL;
        if (node->type == YAML_SEQUENCE_NODE) {
            char *end;
            const unsigned long item = strtoul(path, &end, 10);
            const yaml_node_item_t *items = node->data.sequence.items.start;
            if (length == 0 || end != path + length || item >= (size_t)(node->data.sequence.items.top - items))
                return NULL;
            node = yaml_document_get_node(d, items[item]);
            path += length + (*end == '.');
            continue;
        }
        for (yaml_node_pair_t *p = node->data.mapping.pairs.start; p < node->data.mapping.pairs.top; p++) {
            const yaml_node_t *key = yaml_document_get_node(d, p->key);
            if (key->type == YAML_SCALAR_NODE && key->data.scalar.length == length &&
                memcmp(key->data.scalar.value, path, length) == 0)
                next = yaml_document_get_node(d, p->value);
        }
        node = next;
        path += length;
        if (*path == '.') path++;
    }
    return node;
}

const char *json_read_text(const struct json_read *t, const char *path) {
    const yaml_node_t *node = find(t, path);
    return node && node->type == YAML_SCALAR_NODE ? (const char *)node->data.scalar.value : NULL;
}

double json_read_number(const struct json_read *t, const char *path) {
    const char *text = json_read_text(t, path);
    char *end;
    if (!text || !*text) return NAN;
    const double value = strtod(text, &end);
    return *end ? NAN : value;
}

const char *json_read_key(const struct json_read *t, const char *path, int k) {
    const yaml_node_t *node = find(t, path);
    if (!node || node->type != YAML_MAPPING_NODE || k >= node->data.mapping.pairs.top - node->data.mapping.pairs.start)
        return NULL;
    const yaml_node_t *key = yaml_document_get_node(document_of(t), node->data.mapping.pairs.start[k].key);
    return key->type == YAML_SCALAR_NODE ? (const char *)key->data.scalar.value : NULL;
}
