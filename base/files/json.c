/* Writes a JSON file value by value. */
#include "base/files/json.h"
#include "base/ensure.h"
#include "base/text.h"
#include "base/files/atomic_write.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { DEPTH = 32 };

struct json {
    struct atomic_write writer; /* path "": a stream of the caller's */
    int depth;
    char closing[DEPTH]; /* the closing brackets of the open objects and arrays */
    int items[DEPTH];    /* number of items written to each so far */
};

/* Writes "..." with the escapes that JSON requires. */
static void quote(FILE *f, const char *text) {
    fputc('"', f);
    for (const unsigned char *c = (const unsigned char *)text; *c; c++) {
        if (*c == '"' || *c == '\\')
            fprintf(f, "\\%c", *c);
        else if (*c == '\n')
            fputs("\\n", f);
        else if (*c == '\t')
            fputs("\\t", f);
        else if (*c < 0x20)
            fprintf(f, "\\u%04x", *c);
        else
            fputc(*c, f);
    }
    fputc('"', f);
}

/* Writes the comma, the new line and the key before a value. */
static FILE *next(struct json *j, const char *key) {
    FILE *f = j->writer.file;
    const int in_array = j->closing[j->depth - 1] == ']';
    ENSURE((key == NULL) == in_array, "JSON: a key belongs to every item of an object and to none of an array");
    fputs(j->items[j->depth - 1]++ ? ",\n" : "\n", f);
    for (int k = 0; k < j->depth; k++) fputs("  ", f);
    if (key) {
        quote(f, key);
        fputs(": ", f);
    }
    return f;
}

static void opened(struct json *j, char opening, char closing) {
    ENSURE(j->depth < DEPTH, "JSON nests %d deep", j->depth);
    fputc(opening, j->writer.file);
    j->closing[j->depth] = closing;
    j->items[j->depth++] = 0;
}

struct json *json_begin(const char *path) {
    struct json *j = calloc(1, sizeof *j);
    atomic_write_begin(&j->writer, path);
    opened(j, '{', '}');
    return j;
}

struct json *json_begin_stream(FILE *stream) {
    struct json *j = calloc(1, sizeof *j);
    j->writer.file = stream;
    opened(j, '{', '}');
    return j;
}

void json_close(struct json *j) {
    FILE *f = j->writer.file;
    ENSURE(j->depth > 0, "JSON: nothing is open");
    j->depth--;
    if (j->items[j->depth]) {
        fputc('\n', f);
        for (int k = 0; k < j->depth; k++) fputs("  ", f);
    }
    fputc(j->closing[j->depth], f);
}

void json_end(struct json *j) {
    while (j->depth > 0) json_close(j);
    fputc('\n', j->writer.file);
    if (j->writer.path[0]) atomic_write_end(&j->writer);
    free(j);
}

void json_object(struct json *j, const char *key) {
    next(j, key);
    opened(j, '{', '}');
}

void json_array(struct json *j, const char *key) {
    next(j, key);
    opened(j, '[', ']');
}

int json_open(struct json *j, const char *words) {
    const int open = j->depth;
    for (const char *at = words; *at; at += strspn(at, " ")) {
        const int n = (int)strcspn(at, " "), is_array = n > 2 && at[n - 1] == ']';
        char *key = text_new("%.*s", is_array ? n - 2 : n, at);
        if (is_array)
            json_array(j, key);
        else
            json_object(j, *key == '-' ? NULL : key);
        free(key);
        at += n;
    }
    return open;
}

void json_close_to(struct json *j, int open) {
    while (j->depth > open) json_close(j);
}

void json_text(struct json *j, const char *key, const char *value) { quote(next(j, key), value); }

void json_number(struct json *j, const char *key, double value) {
    if (isfinite(value))
        fprintf(next(j, key), "%.15g", value);
    else
        fputs("null", next(j, key));
}

void json_long(struct json *j, const char *key, long value) { fprintf(next(j, key), "%ld", value); }

void json_bool(struct json *j, const char *key, int value) { fputs(value ? "true" : "false", next(j, key)); }
