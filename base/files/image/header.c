/* Reads text headers of images: lines, words, numbers. */
#include "base/files/image/header.h"

#include <ctype.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>

char *image_header_load(struct image_source *s, const char *path, size_t *bytes) {
    long long all;
    const int fd = image_source_file(s, path, &all);
    if (fd < 0) return NULL;
    *bytes = all < IMAGE_HEADER_MOST ? (size_t)all : IMAGE_HEADER_MOST;
    char *text = malloc(*bytes + 1);
    if (text)
        text[*bytes] = '\0';
    else
        image_source_refuse(s, "no memory left to read it");
    if (text && image_source_take(s, fd, 0, text, *bytes)) {
        free(text);
        text = NULL;
    }
    close(fd);
    return text;
}

int image_header_line(struct image_header_text *text, char line[IMAGE_HEADER_LINE]) {
    if (text->at >= text->end) return 0;
    const char *end = memchr(text->at, '\n', (size_t)(text->end - text->at));
    const char *next = end ? end + 1 : text->end;
    if (!end) end = text->end;
    if (end > text->at && end[-1] == '\r') end--;
    size_t n = (size_t)(end - text->at);
    if (n >= IMAGE_HEADER_LINE) n = IMAGE_HEADER_LINE - 1;
    memcpy(line, text->at, n);
    line[n] = '\0';
    text->at = next;
    return 1;
}

static int is_blank(char c) { return isspace((unsigned char)c); }

char *image_header_trim(char *word) {
    while (is_blank(*word)) word++;
    char *end = word + strlen(word);
    while (end > word && is_blank(end[-1])) end--;
    *end = '\0';
    return word;
}

int image_header_find(const char *word, const char *const *list, int n) {
    for (int k = 0; k < n; k++)
        if (strcasecmp(word, list[k]) == 0) return k;
    return -1;
}

int image_header_integers(const char *text, int n, long *value) {
    for (int k = 0; k < n; k++) {
        char *end;
        errno = 0;
        value[k] = strtol(text, &end, 10);
        if (end == text || errno || (*end && !is_blank(*end))) return 0;
        text = end;
    }
    while (is_blank(*text)) text++;
    return *text == '\0';
}

int image_header_numbers(const char *text, int n, double *value) {
    for (int k = 0; k < n; k++) {
        char *end;
        value[k] = strtod(text, &end);
        if (end == text || (*end && !is_blank(*end))) return 0;
        text = end;
    }
    while (is_blank(*text)) text++;
    return *text == '\0';
}

double image_header_metres(const char *unit) {
    static const struct {
        const char *word;
        double metres;
    } known[] = {{"m", 1},
                 {"meter", 1},
                 {"metre", 1},
                 {"cm", 1e-2},
                 {"mm", 1e-3},
                 {"um", 1e-6},
                 {"µm", 1e-6},
                 /* U+00B5 */ {"μm", 1e-6}, /* U+03BC */
                 {"\\u00B5m", 1e-6},
                 {"micron", 1e-6},
                 {"microns", 1e-6},
                 {"nm", 1e-9},
                 {"millimeter", 1e-3},
                 {"millimetre", 1e-3},
                 {"micrometer", 1e-6},
                 {"micrometre", 1e-6}};
    for (size_t k = 0; k < sizeof known / sizeof *known; k++)
        if (strcasecmp(unit, known[k].word) == 0) return known[k].metres;
    return 0;
}

int image_header_path(struct image_source *s, const char *file, const char *data, char *path, size_t capacity) {
    const char *slash = strrchr(file, '/');
    const int folder = data[0] == '/' || !slash ? 0 : (int)(slash + 1 - file);
    snprintf(s->subject, sizeof s->subject, "its data file %s", data);
    if (snprintf(path, capacity, "%.*s%s", folder, file, data) < (int)capacity) return 0;
    return image_source_refuse(s, "%s has too long a name", s->subject);
}

int image_header_order(struct image_source *s, struct image_header *h, enum files_image_order given) {
    if (h->order == FILES_IMAGE_ORDER_AUTO) h->order = given;
    if (given == FILES_IMAGE_ORDER_AUTO || given == h->order) return 0;
    return image_source_refuse(s, "its byte order is %s, and is given as %s",
                               h->order == FILES_IMAGE_BIG ? "big" : "little",
                               given == FILES_IMAGE_BIG ? "big" : "little");
}
