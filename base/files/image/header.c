/* Reads text headers of images: lines, words, numbers. */
#include "base/files/image/header.h"

#include <ctype.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

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

int image_header_has(const char *words, const char *word) {
    const size_t n = strlen(word);
    for (const char *at = words; !strchr(word, '|') && (at = strchr(at, '|')) && *++at;)
        if (strncasecmp(at, word, n) == 0 && at[n] == '|') return 1;
    return 0;
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
        const char *words; /* each between bars; the micro signs are U+00B5 and U+03BC */
        double metres;
    } known[] = {{"|m|meter|metre|", 1},
                 {"|cm|", 1e-2},
                 {"|mm|millimeter|millimetre|", 1e-3},
                 {"|um|µm|μm|\\u00B5m|micron|microns|micrometer|micrometre|", 1e-6},
                 {"|nm|", 1e-9}};
    for (size_t k = 0; k < sizeof known / sizeof *known; k++)
        if (image_header_has(known[k].words, unit)) return known[k].metres;
    return 0;
}

/* The path of h->data beside the header's file. */
static int path_of(struct image_source *s, const char *file, const char *data, char *path, size_t capacity) {
    const char *slash = strrchr(file, '/');
    const int folder = data[0] == '/' || !slash ? 0 : (int)(slash + 1 - file);
    snprintf(s->subject, sizeof s->subject, "its data file %.280s", data);
    if (snprintf(path, capacity, "%.*s%s", folder, file, data) < (int)capacity) return 0;
    return image_source_refuse(s, "%s has too long a name", s->subject);
}

/* The byte order of header and user, which must not differ. */
static int set_order(struct image_source *s, struct image_header *h, enum files_image_order given) {
    if (h->order == FILES_IMAGE_ORDER_AUTO) h->order = given;
    if (given == FILES_IMAGE_ORDER_AUTO || given == h->order) return 0;
    return image_source_refuse(s, "its byte order is %s, and is given as %s",
                               h->order == FILES_IMAGE_BIG ? "big" : "little",
                               given == FILES_IMAGE_BIG ? "big" : "little");
}

int image_header_take(struct image_source *s, char *line, char *sign, int n, const char *const *word,
                      char (*value)[IMAGE_HEADER_LINE], int *k) {
    *k = -1;
    if (!sign) return 0;
    *sign = '\0';
    *k = image_header_find(image_header_trim(line), word, n);
    if (*k < 0) return 0;
    if (value[*k][0]) return image_source_refuse(s, "its header gives %s twice", word[*k]);
    snprintf(value[*k], sizeof *value, "%s", image_header_trim(sign + 1));
    return 0;
}

int image_header_open(struct image_source *s, const struct files_image_input *input, image_header_parse *parse,
                      image_header_data *data) {
    struct image_header h = {0};
    char path[4096];
    long long bytes;
    char *text = image_source_load(s, input->file, IMAGE_HEADER_MAX, &bytes);
    const int fault = !text || parse(s, text, (size_t)bytes, &h);
    free(text);
    if (fault || set_order(s, &h, input->byte_order)) return 1;
    if (!h.data[0]) return data(s, input->file, &h);
    return path_of(s, input->file, h.data, path, sizeof path) || data(s, path, &h);
}
