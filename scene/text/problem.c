/* Collects the scene's mistakes as sentences with file, line, key and value, and finds the nearest word. */
#include "scene/text/problem.h"
#include "base/die.h"
#include "base/sanitize.h"
#include "base/text.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SHOWN = 60, PATH = 160, WORD = 48 };

void scene_problem_free(struct scene_problems *p) {
    for (int i = 0; i < p->n; i++) free(p->text[i]);
    free(p->text);
    free(p->line);
    p->text = NULL;
    p->line = NULL;
    p->n = p->capacity = 0;
}

void scene_problem_print(const struct scene_problems *p) {
    for (int i = 0; i < p->n && i < SCENE_PROBLEM_LINES; i++) {
        sanitize_text(p->text[i]);
        fprintf(stderr, "frana: %s\n", p->text[i]);
    }
    if (p->n > SCENE_PROBLEM_LINES) fprintf(stderr, "frana: and %d more mistakes\n", p->n - SCENE_PROBLEM_LINES);
    fflush(stderr);
}

void scene_problem_sort(struct scene_problems *p) {
    for (int i = 1; i < p->n; i++)
        for (int j = i; j > 0 && p->line[j - 1] > p->line[j]; j--) {
            const int line = p->line[j];
            char *const text = p->text[j];
            p->line[j] = p->line[j - 1];
            p->text[j] = p->text[j - 1];
            p->line[j - 1] = line;
            p->text[j - 1] = text;
        }
}

/* Takes ownership of the text. */
static void add(struct scene_problems *p, int line, char *text) {
    if (p->n == p->capacity) {
        p->capacity = p->capacity ? 2 * p->capacity : 8;
        p->line = realloc(p->line, (size_t)p->capacity * sizeof *p->line);
        p->text = realloc(p->text, (size_t)p->capacity * sizeof *p->text);
        if (!p->line || !p->text) die(EXIT_CODE_FILE, "no memory left for the scene's mistakes");
    }
    p->line[p->n] = line;
    p->text[p->n++] = text;
}

static char *message_of(const char *format, va_list args) {
    char *message = NULL;
    if (vasprintf(&message, format, args) < 0) die(EXIT_CODE_FILE, "no memory left for the scene's mistakes");
    return message;
}

static int can_show(const struct scene_node *node) {
    if (node->kind == SCENE_NODE_SCALAR) return *node->value != '\0';
    if (node->kind == SCENE_NODE_MAPPING) return 0;
    for (int i = 0; i < node->n; i++)
        if (node->child[i]->kind != SCENE_NODE_SCALAR) return 0;
    return 1;
}

/* A copy of at most so many bytes, the last of them dots if it was longer. */
static char *shortened(const char *text, int bytes) {
    if ((int)strlen(text) <= bytes) return text_new("%s", text);
    int end = bytes - 3;
    while (((unsigned char)text[end] & 0xc0) == 0x80) end--; /* not inside a UTF-8 character */
    return text_new("%.*s...", end, text);
}

/* A scalar, or a list of scalars, as written; a long one is shortened. */
static char *shown(const struct scene_node *node) {
    char *text;
    if (node->kind == SCENE_NODE_SCALAR) {
        text = node->quoted ? text_new("\"%s\"", node->value) : text_new("%s", node->value);
    } else {
        text = text_new("[");
        for (int i = 0; i < node->n && strlen(text) <= SHOWN; i++) {
            char *longer = text_new("%s%s%s", text, i ? ", " : "", node->child[i]->value);
            free(text);
            text = longer;
        }
        char *closed = text_new("%s]", text);
        free(text);
        text = closed;
    }
    for (char *c = text; *c; c++)
        if ((unsigned char)*c < ' ' || *c == 0x7f) *c = ' ';
    char *cut = shortened(text, SHOWN);
    free(text);
    return cut;
}

/* Takes ownership of the message. */
static void add_problem(struct scene_problems *p, const struct scene_node *node, const char *path, int with_value,
                        char *message) {
    const int has_value = with_value && can_show(node);
    char *const value = has_value ? shown(node) : text_new("%s", "");
    char *where, *name;
    char *const brief = shortened(path, PATH);
    if (node->set) {
        char *const set = shortened(node->set, PATH);
        where = text_new("--set ");
        name = node->set_inner ? text_new("%s: %s", set, brief) : text_new("%s", set);
        free(set);
    } else {
        where = node->line ? text_new("%s:%d: ", p->file, node->line) : text_new("%s: ", p->file);
        name = text_new("%s", brief);
    }
    add(p, node->set ? 0 : node->line, text_new("%s%s%s%s: %s", where, name, has_value ? " = " : "", value, message));
    free(where);
    free(name);
    free(brief);
    free(value);
    free(message);
}

void scene_problem_line(struct scene_problems *p, int line, const char *format, ...) {
    va_list args;
    va_start(args, format);
    char *message = message_of(format, args);
    va_end(args);
    add(p, line, line ? text_new("%s:%d: %s", p->file, line, message) : text_new("%s: %s", p->file, message));
    free(message);
}

void scene_problem_key(struct scene_problems *p, const struct scene_node *node, const char *path, const char *format,
                       ...) {
    va_list args;
    va_start(args, format);
    add_problem(p, node, path, 0, message_of(format, args));
    va_end(args);
}

void scene_problem_value(struct scene_problems *p, const struct scene_node *node, const char *path, const char *format,
                         ...) {
    va_list args;
    va_start(args, format);
    add_problem(p, node, path, 1, message_of(format, args));
    va_end(args);
}

void scene_problem_at(struct scene_problems *p, const struct scene_node *root, const char *path, const char *format,
                      ...) {
    va_list args;
    va_start(args, format);
    const struct scene_node *node = scene_node_find(root, path), *near = scene_node_near(root, path);
    /* a missing key is reported on the line of its parent */
    const struct scene_node above = {.kind = SCENE_NODE_MAPPING, .line = near->line, .set = near->set, .set_inner = 1};
    add_problem(p, node ? node : &above, path, 1, message_of(format, args));
    va_end(args);
}

/* Number of edits between two words: insertions, deletions, changes and swaps of neighbours (optimal string
 * alignment). */
static int edits(const char *a, const char *b) {
    const int n = (int)strlen(a), m = (int)strlen(b);
    if (n >= WORD || m >= WORD) return WORD;
    int d[WORD + 1][WORD + 1];
    for (int i = 0; i <= n; i++) d[i][0] = i;
    for (int j = 0; j <= m; j++) d[0][j] = j;
    for (int i = 1; i <= n; i++)
        for (int j = 1; j <= m; j++) {
            int least = d[i - 1][j - 1] + (a[i - 1] != b[j - 1]);
            if (d[i - 1][j] + 1 < least) least = d[i - 1][j] + 1;
            if (d[i][j - 1] + 1 < least) least = d[i][j - 1] + 1;
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] && d[i - 2][j - 2] + 1 < least)
                least = d[i - 2][j - 2] + 1;
            d[i][j] = least;
        }
    return d[n][m];
}

const char *scene_problem_nearest(const char *word, int n, const char *const *candidate) {
    const char *nearest = NULL;
    int least = 0;
    for (int i = 0; i < n; i++) {
        const int e = edits(word, candidate[i]),
                  longest = (int)(strlen(word) > strlen(candidate[i]) ? strlen(word) : strlen(candidate[i]));
        const int allowed = longest < 4 ? 1 : (longest + 2) / 3;
        if (e <= allowed && e < (int)strlen(candidate[i]) && (!nearest || e < least)) {
            nearest = candidate[i];
            least = e;
        }
    }
    return nearest;
}

struct scene_problem_hint scene_problem_hint(const char *word, int n, const char *const *candidate) {
    const char *nearest = scene_problem_nearest(word, n, candidate);
    struct scene_problem_hint hint = {""};
    if (nearest) snprintf(hint.text, sizeof hint.text, "; did you mean %s?", nearest);
    return hint;
}
