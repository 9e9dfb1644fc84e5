/* Keeps memory in a list until all of it is freed at once. */
#include "base/arena.h"
#include "base/die.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static struct block {
    struct block *next;
    void *p;
} * first;

void *arena_keep(void *p) {
    if (!p) return NULL;
    struct block *b = malloc(sizeof *b);
    if (!b) die(EXIT_CODE_FILE, "no memory left");
    *b = (struct block){first, p};
    first = b;
    return p;
}

void *arena_new(size_t count, size_t size) {
    void *p = calloc(count + 1, size);
    if (!p) die(EXIT_CODE_FILE, "no memory left for %zu x %zu bytes", count, size);
    return arena_keep(p);
}

void *arena_grown(const void *old, size_t n, size_t size) {
    void *p = arena_new(n + 1, size);
    return n > 0 ? memcpy(p, old, n * size) : p;
}

char *arena_text(const char *format, ...) {
    va_list args;
    va_start(args, format);
    char *text = NULL;
    if (vasprintf(&text, format, args) < 0) die(EXIT_CODE_FILE, "no memory left for a text");
    va_end(args);
    return arena_keep(text);
}

void arena_free(void) {
    for (struct block *next; first; first = next) {
        next = first->next;
        free(first->p);
        free(first);
    }
}
