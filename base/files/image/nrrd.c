/* Reads the header of a NRRD: lines of `field: value` up to a blank line (teem.sourceforge.net/nrrd/format.html). */
#include "base/files/image/formats.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>

/* Others say where the image stands in the world or what it shows: they change no voxel. */
#define ALL(FIELD)                                                                                                     \
    FIELD(TYPE, "type")                                                                                                \
    FIELD(DIMENSION, "dimension")                                                                                      \
    FIELD(SIZES, "sizes")                                                                                              \
    FIELD(ENCODING, "encoding")                                                                                        \
    FIELD(ENDIAN_WORD, "endian")                                                                                       \
    FIELD(DATA, "data file")                                                                                           \
    FIELD(DATA_TOO, "datafile")                                                                                        \
    FIELD(LINE_SKIP, "line skip")                                                                                      \
    FIELD(LINE_SKIP_TOO, "lineskip")                                                                                   \
    FIELD(BYTE_SKIP, "byte skip")                                                                                      \
    FIELD(BYTE_SKIP_TOO, "byteskip")                                                                                   \
    FIELD(SPACINGS, "spacings")                                                                                        \
    FIELD(DIRECTIONS, "space directions")                                                                              \
    FIELD(UNITS, "units")                                                                                              \
    FIELD(SPACE_UNITS, "space units")                                                                                  \
    FIELD(KINDS, "kinds")
#define NAME(name, word) name,
#define WORD(name, word) word,
enum field { ALL(NAME) FIELDS };
static const char *const field_word[FIELDS] = {ALL(WORD)};

struct nrrd {
    char value[FIELDS][IMAGE_HEADER_LINE]; /* "": not given */
    size_t bytes;                          /* of the header with its blank line */
    int is_ended;                          /* by a blank line */
};

static const struct {
    const char *words;
    enum files_image_type type;
} type_of[] = {
    {"|signed char|int8|int8_t|", FILES_IMAGE_INT8},
    {"|uchar|unsigned char|uint8|uint8_t|", FILES_IMAGE_UINT8},
    {"|short|short int|signed short|signed short int|int16|int16_t|", FILES_IMAGE_INT16},
    {"|ushort|unsigned short|unsigned short int|uint16|uint16_t|", FILES_IMAGE_UINT16},
    {"|int|signed int|int32|int32_t|", FILES_IMAGE_INT32},
    {"|uint|unsigned int|uint32|uint32_t|", FILES_IMAGE_UINT32},
    {"|longlong|long long|long long int|signed long long|signed long long int|int64|int64_t|", FILES_IMAGE_INT64},
    {"|ulonglong|unsigned long long|unsigned long long int|uint64|uint64_t|", FILES_IMAGE_UINT64},
    {"|float|", FILES_IMAGE_FLOAT32},
    {"|double|", FILES_IMAGE_FLOAT64}};

/* NRRD0001 to NRRD0005, and NRRD00.01, the first. */
static int check_magic(struct image_source *s, const char *line) {
    if (strcmp(line, "NRRD00.01") == 0) return 0;
    if (strncmp(line, "NRRD000", 7) == 0 && line[7] >= '1' && line[7] <= '5' && !line[8]) return 0;
    if (strncmp(line, "NRRD", 4) != 0) return image_source_refuse(s, "it is not an NRRD: these begin with NRRD");
    return image_source_refuse(s, "it is of version %.20s, and NRRD0001 to NRRD0005 are read", line);
}

static int read_fields(struct image_source *s, const char *text, size_t bytes, struct nrrd *r) {
    struct image_header_text at = {text, text + bytes};
    char line[IMAGE_HEADER_LINE];
    if (!image_header_line(&at, line)) line[0] = '\0';
    if (check_magic(s, image_header_trim(line))) return 1;
    while (!r->is_ended && image_header_line(&at, line)) {
        char *sign = strchr(line, ':');
        int k;
        r->is_ended = line[0] == '\0';
        if (line[0] == '#' || (sign && sign[1] == '=')) continue; /* a comment, or a pair of the user's own */
        if (image_header_take(s, line, sign, FIELDS, field_word, r->value, &k)) return 1;
        /* the names of the files are the rest of the header */
        if ((k == DATA || k == DATA_TOO) && strncmp(r->value[k], "LIST", 4) == 0) break;
    }
    r->bytes = (size_t)(at.at - text);
    return 0;
}

/* A field that has two spellings. */
static const char *value_of(const struct nrrd *r, enum field field) {
    return r->value[field][0] ? r->value[field] : r->value[field + 1];
}

static int read_type(struct image_source *s, const struct nrrd *r) {
    static const enum field needed[] = {TYPE, DIMENSION, SIZES, ENCODING};
    long n;
    for (int k = 0; k < 4; k++)
        if (!r->value[needed[k]][0])
            return image_source_refuse(s, "its header has no %s, which a NRRD needs", field_word[needed[k]]);
    if (!image_header_integers(r->value[DIMENSION], 1, &n) || n != 3)
        return image_source_refuse(s, "its header has dimension: %.60s, and 3 are needed", r->value[DIMENSION]);
    if (!image_header_integers(r->value[SIZES], 3, s->n))
        return image_source_refuse(s, "its header has sizes: %.60s, and three numbers are needed", r->value[SIZES]);
    for (size_t k = 0; k < sizeof type_of / sizeof *type_of && s->type == FILES_IMAGE_HEADER; k++)
        if (image_header_has(type_of[k].words, r->value[TYPE])) s->type = type_of[k].type;
    if (s->type != FILES_IMAGE_HEADER) return 0;
    return image_source_refuse(s, "its header has type: %.60s, which is not read", r->value[TYPE]);
}

/* An axis of colours or of a vector's components is none of space. */
static int check_kinds(struct image_source *s, struct nrrd *r) {
    static const char *const of_space[] = {"domain", "space", "???", "none"};
    char *rest = r->value[KINDS];
    for (char *word; (word = strtok_r(rest, " \t", &rest));)
        if (image_header_find(word, of_space, 4) < 0)
            return image_source_refuse(s, "an axis of it is of kind %.60s: three axes of space are needed", word);
    return 0;
}

/* (1,0,0) (0,1,0) (0,0,1), in any number of dimensions: the lengths of the vectors. */
static int read_directions(const char *text, double length[3]) {
    for (int f = 0; f < 3; f++) {
        double sum = 0;
        char *end;
        text += strspn(text, " \t");
        if (strncasecmp(text, "none", 4) == 0) {
            text += 4;
            continue;
        }
        if (*text++ != '(') return 0;
        for (;; text++) {
            const double v = strtod(text, &end);
            if (end == text) return 0;
            sum += v * v;
            text = end + strspn(end, " \t");
            if (*text != ',') break;
        }
        if (*text++ != ')') return 0;
        length[f] = sqrt(sum);
    }
    return 1;
}

/* "mm" "mm" "mm": metres in the unit, if all are the same. */
static double read_unit(const char *text) {
    char word[3][32];
    if (sscanf(text, " \" %31[^\"]\" \" %31[^\"]\" \" %31[^\"]\"", word[0], word[1], word[2]) != 3) return 0;
    for (int f = 0; f < 3; f++) memmove(word[f], image_header_trim(word[f]), strlen(image_header_trim(word[f])) + 1);
    if (strcmp(word[0], word[1]) != 0 || strcmp(word[0], word[2]) != 0) return 0;
    return image_header_metres(word[0]);
}

static int read_spacing(struct image_source *s, const struct nrrd *r) {
    const int by_directions = r->value[DIRECTIONS][0] != '\0';
    if (by_directions && !read_directions(r->value[DIRECTIONS], s->voxel))
        return image_source_refuse(s, "its header has space directions: %.60s, and three vectors are needed",
                                   r->value[DIRECTIONS]);
    if (!by_directions && r->value[SPACINGS][0] && !image_header_numbers(r->value[SPACINGS], 3, s->voxel))
        return image_source_refuse(s, "its header has spacings: %.60s, and three numbers are needed",
                                   r->value[SPACINGS]);
    const double metres = read_unit(r->value[by_directions ? SPACE_UNITS : UNITS]);
    if (metres == 0) return 0;
    for (int f = 0; f < 3; f++) s->voxel[f] *= metres;
    s->unit = "m";
    return 0;
}

static int read_encoding(struct image_source *s, const struct nrrd *r, struct image_header *h) {
    const char *endian = r->value[ENDIAN_WORD];
    h->is_compressed = strcasecmp(r->value[ENCODING], "gzip") == 0 || strcasecmp(r->value[ENCODING], "gz") == 0;
    if (!h->is_compressed && strcasecmp(r->value[ENCODING], "raw") != 0)
        return image_source_refuse(s, "its header has encoding: %.60s, and raw and gzip are read", r->value[ENCODING]);
    if (strcasecmp(endian, "little") == 0) h->order = FILES_IMAGE_LITTLE;
    if (strcasecmp(endian, "big") == 0) h->order = FILES_IMAGE_BIG;
    if (endian[0] && h->order == FILES_IMAGE_ORDER_AUTO)
        return image_source_refuse(s, "its header has endian: %.60s, and little or big is needed", endian);
    return 0;
}

static int read_place(struct image_source *s, const struct nrrd *r, struct image_header *h) {
    const char *data = value_of(r, DATA), *lines = value_of(r, LINE_SKIP), *skip = value_of(r, BYTE_SKIP);
    long bytes = 0;
    if (lines[0] && (!image_header_integers(lines, 1, &h->lines) || h->lines < 0))
        return image_source_refuse(s, "its header has line skip: %.60s, and a number of lines is needed", lines);
    if (skip[0] && (!image_header_integers(skip, 1, &bytes) || bytes < (h->is_compressed ? 0 : -1)))
        return image_source_refuse(s, "its header has byte skip: %.60s, and a number of bytes is needed", skip);
    h->bytes = r->bytes;
    h->skip = bytes == -1 ? IMAGE_RAW_AT_END : bytes;
    if (strncmp(data, "LIST", 4) == 0 || strchr(data, '%'))
        return image_source_refuse(s, "its voxels are in several files: one file is read");
    if (!data[0] && !r->is_ended)
        return image_source_refuse(s, "no blank line ends its header, and it names no data file");
    snprintf(h->data, sizeof h->data, "%s", data);
    return 0;
}

int image_nrrd_parse(struct image_source *s, const char *text, size_t bytes, struct image_header *h) {
    struct nrrd *r = image_source_new(1, sizeof *r);
    memset(h, 0, sizeof *h);
    const int fault = read_fields(s, text, bytes, r) || read_type(s, r) || check_kinds(s, r) || read_spacing(s, r) ||
                      read_encoding(s, r, h) || read_place(s, r, h);
    free(r);
    return fault;
}

/* Where the bytes begin that the header's skip counts from: behind the header and so many lines. */
static int skip_lines(struct image_source *s, const char *path, const struct image_header *h, long long *at) {
    char piece[4096];
    long long all;
    long left = h->lines;
    *at = h->data[0] ? 0 : (long long)h->bytes;
    if (left == 0) return 0;
    const int fd = image_source_file(s, path, &all);
    if (fd < 0) return 1;
    while (left > 0) {
        const size_t n = all - *at < (long long)sizeof piece ? (size_t)(all - *at) : sizeof piece;
        if (n == 0 || image_source_take(s, fd, *at, piece, n)) break;
        size_t k = 0;
        while (k < n && left > 0) left -= piece[k++] == '\n';
        *at += (long long)k;
    }
    close(fd);
    return left > 0 && image_source_refuse(s, "%s has fewer lines than line skip: %ld", s->subject, h->lines);
}

static int open_data(struct image_source *s, const char *path, const struct image_header *h) {
    long long at, skip = h->skip;
    if (h->order == FILES_IMAGE_ORDER_AUTO && image_number_bytes(s->type) > 1)
        return image_source_refuse(s, "its header has no endian, which a NRRD of %s needs", image_number_word(s->type));
    if (skip_lines(s, path, h, &at)) return 1;
    if (h->is_compressed) return image_inflate_open(s, path, at, skip, h->order);
    if (skip != IMAGE_RAW_AT_END && __builtin_add_overflow(skip, at, &skip))
        return image_source_refuse(s, "its header has byte skip: %lld, more than a file can hold", h->skip);
    return image_raw_open(s, path, skip, h->order);
}

int image_nrrd_open(struct image_source *s, const struct files_image_input *input) {
    return image_header_open(s, input, image_nrrd_parse, open_data);
}
