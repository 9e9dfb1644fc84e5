/* Reads values to set in the scene from a study's file, as --set arguments. */
#include "base/arena.h"
#include "program/study/file/parts.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Writes a text in double quotes, as YAML and JSON need it. */
static void put_quoted(FILE *f, const char *text) {
    fputc('"', f);
    for (const unsigned char *c = (const unsigned char *)text; *c; c++) {
        if (*c == '"' || *c == '\\')
            fprintf(f, "\\%c", *c);
        else if (*c < 0x20)
            fprintf(f, "\\x%02x", *c);
        else
            fputc(*c, f);
    }
    fputc('"', f);
}

/* Writes the node on one line, in YAML's flow style. */
static void put_flow(FILE *f, const struct scene_node *node) {
    if (node->kind == SCENE_NODE_SCALAR) {
        if (node->quoted || strpbrk(node->value, ",[]{}:#&*!|>'\"%@`\n"))
            put_quoted(f, node->value);
        else
            fputs(node->value, f);
        return;
    }
    const int is_list = node->kind == SCENE_NODE_LIST;
    fputc(is_list ? '[' : '{', f);
    for (int i = 0; i < node->n; i++) {
        fputs(i ? ", " : "", f);
        if (!is_list) {
            put_quoted(f, node->child[i]->key);
            fputs(": ", f);
        }
        put_flow(f, node->child[i]);
    }
    fputc(is_list ? ']' : '}', f);
}

static void add(struct study_sets *sets, char *text) {
    sets->text = arena_grown(sets->text, (size_t)sets->n, sizeof *sets->text);
    sets->text[sets->n++] = text;
}

void study_sets_read(struct study_sets *sets, const struct scene_node *mapping, const char *path,
                     struct scene_problems *problems) {
    if (mapping->kind != SCENE_NODE_MAPPING) {
        scene_problem_value(problems, mapping, path, "must be a mapping (stages.flow.steps: 200, ...)");
        return;
    }
    for (int i = 0; i < mapping->n; i++) {
        char *text = NULL;
        size_t bytes = 0;
        FILE *f = open_memstream(&text, &bytes);
        fprintf(f, "%s=", mapping->child[i]->key);
        put_flow(f, mapping->child[i]);
        fclose(f);
        add(sets, arena_keep(text));
    }
}

void study_sets_read_values(struct study_sets *sets, const char *key, const struct scene_node *values, const char *path,
                            struct scene_problems *problems) {
    for (int i = 0; i < values->n; i++) {
        struct scene_node value = *values->child[i], *child = &value;
        value.key = arena_text("%s", key);
        study_sets_read(sets, &(struct scene_node){.kind = SCENE_NODE_MAPPING, .n = 1, .child = &child}, path,
                        problems);
    }
}

void study_sets_join(struct study_sets *sets, const struct study_sets *more) {
    for (int i = 0; i < more->n; i++) add(sets, arena_text("%s", more->text[i]));
}
