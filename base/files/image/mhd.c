/* Reads the header of a MetaImage: lines of `Key = value`, of which ElementDataFile is the last. */
#include "base/files/image/formats.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* Others say where the image stands in the world or what it shows: they change no voxel. */
#define ALL(KEY)                                                                                                       \
    KEY(OBJECT, "ObjectType")                                                                                          \
    KEY(DIMENSIONS, "NDims")                                                                                           \
    KEY(SIZE, "DimSize")                                                                                               \
    KEY(BINARY, "BinaryData")                                                                                          \
    KEY(COMPRESSED, "CompressedData")                                                                                  \
    KEY(MSB, "ElementByteOrderMSB")                                                                                    \
    KEY(MSB_TOO, "BinaryDataByteOrderMSB")                                                                             \
    KEY(HEADER, "HeaderSize")                                                                                          \
    KEY(CHANNELS, "ElementNumberOfChannels")                                                                           \
    KEY(SPACING, "ElementSpacing")                                                                                     \
    KEY(ELEMENT_SIZE, "ElementSize")                                                                                   \
    KEY(UNITS, "DistanceUnits")                                                                                        \
    KEY(TYPE, "ElementType")                                                                                           \
    KEY(DATA, "ElementDataFile")
#define NAME(name, word) name,
#define WORD(name, word) word,
enum key { ALL(NAME) KEYS };
static const char *const key_word[KEYS] = {ALL(WORD)};

struct mhd {
    char value[KEYS][IMAGE_HEADER_LINE]; /* "": not given */
    size_t bytes;
};

/* long has four bytes here on every machine (MetaIO, metaTypes.h) */
static const char *const type_word[] = {"MET_CHAR",      "MET_UCHAR",      "MET_SHORT", "MET_USHORT",
                                        "MET_INT",       "MET_UINT",       "MET_LONG",  "MET_ULONG",
                                        "MET_LONG_LONG", "MET_ULONG_LONG", "MET_FLOAT", "MET_DOUBLE"};
static const enum files_image_type type_of[] = {FILES_IMAGE_INT8,   FILES_IMAGE_UINT8,   FILES_IMAGE_INT16,
                                                FILES_IMAGE_UINT16, FILES_IMAGE_INT32,   FILES_IMAGE_UINT32,
                                                FILES_IMAGE_INT32,  FILES_IMAGE_UINT32,  FILES_IMAGE_INT64,
                                                FILES_IMAGE_UINT64, FILES_IMAGE_FLOAT32, FILES_IMAGE_FLOAT64};
enum { TYPE_WORDS = sizeof type_of / sizeof *type_of };

static int read_keys(struct image_source *s, const char *text, size_t bytes, struct mhd *m) {
    struct image_header_text at = {text, text + bytes};
    char line[IMAGE_HEADER_LINE];
    int k;
    while (!m->value[DATA][0] && image_header_line(&at, line))
        if (image_header_take(s, line, strpbrk(line, "=:"), KEYS, key_word, m->value, &k)) return 1;
    m->bytes = (size_t)(at.at - text);
    return 0;
}

static int is_true(const char *value) { return value[0] == 'T' || value[0] == 't' || value[0] == '1'; }

static int check_kind(struct image_source *s, const struct mhd *m) {
    static const enum key needed[] = {DIMENSIONS, SIZE, TYPE, DATA};
    long n;
    if (m->value[OBJECT][0] && strcasecmp(m->value[OBJECT], "Image") != 0)
        return image_source_refuse(s, "its header has ObjectType = %.60s: an Image is needed", m->value[OBJECT]);
    for (int k = 0; k < 4; k++)
        if (!m->value[needed[k]][0])
            return image_source_refuse(s, "its header has no %s, which a MetaImage needs", key_word[needed[k]]);
    if (!image_header_integers(m->value[DIMENSIONS], 1, &n) || n != 3)
        return image_source_refuse(s, "its header has NDims = %.60s: 3 are needed", m->value[DIMENSIONS]);
    if (m->value[BINARY][0] && !is_true(m->value[BINARY]))
        return image_source_refuse(s, "its voxels are written as text: binary ones are read (BinaryData = True)");
    if (m->value[CHANNELS][0] && (!image_header_integers(m->value[CHANNELS], 1, &n) || n != 1))
        return image_source_refuse(s, "its header has ElementNumberOfChannels = %.60s: 1 is needed",
                                   m->value[CHANNELS]);
    return 0;
}

static int read_type(struct image_source *s, const struct mhd *m) {
    const int k = image_header_find(m->value[TYPE], type_word, TYPE_WORDS);
    if (k < 0) return image_source_refuse(s, "its header has ElementType = %.60s, which is not read", m->value[TYPE]);
    s->type = type_of[k];
    return 0;
}

/* ElementSize where there is no ElementSpacing, as MetaIO does. */
static int read_spacing(struct image_source *s, const struct mhd *m) {
    const enum key k = m->value[SPACING][0] ? SPACING : ELEMENT_SIZE;
    if (!m->value[k][0]) return 0;
    if (!image_header_numbers(m->value[k], 3, s->voxel))
        return image_source_refuse(s, "its header has %s = %.60s: three numbers are needed", key_word[k], m->value[k]);
    const double metres = image_header_metres(m->value[UNITS]);
    if (metres == 0) return 0;
    for (int f = 0; f < 3; f++) s->voxel[f] *= metres;
    s->unit = "m";
    return 0;
}

static int read_place(struct image_source *s, const struct mhd *m, struct image_header *h) {
    const char *msb = m->value[MSB][0] ? m->value[MSB] : m->value[MSB_TOO], *data = m->value[DATA];
    long skip = 0;
    if (msb[0]) h->order = is_true(msb) ? FILES_IMAGE_BIG : FILES_IMAGE_LITTLE;
    if (m->value[HEADER][0] && (!image_header_integers(m->value[HEADER], 1, &skip) || skip < -1))
        return image_source_refuse(s, "its header has HeaderSize = %.60s: -1 or a number of bytes is needed",
                                   m->value[HEADER]);
    h->bytes = m->bytes;
    h->skip = skip == -1 ? IMAGE_RAW_AT_END : skip;
    h->is_compressed = is_true(m->value[COMPRESSED]);
    if (h->is_compressed && skip == -1)
        return image_source_refuse(s, "its header has HeaderSize = -1, which does not go with CompressedData = True");
    if (strcasecmp(data, "LOCAL") == 0) {
        if (skip == 0) h->skip = (long long)m->bytes;
        return 0;
    }
    if (strcasecmp(data, "LIST") == 0 || strncasecmp(data, "LIST ", 5) == 0 || strchr(data, '%'))
        return image_source_refuse(s, "its voxels are in several files: one file is read");
    snprintf(h->data, sizeof h->data, "%s", data);
    return 0;
}

int image_mhd_parse(struct image_source *s, const char *text, size_t bytes, struct image_header *h) {
    struct mhd *m = image_source_new(1, sizeof *m);
    memset(h, 0, sizeof *h);
    int fault = read_keys(s, text, bytes, m) || check_kind(s, m) || read_type(s, m) || read_spacing(s, m) ||
                read_place(s, m, h);
    if (!fault && !image_header_integers(m->value[SIZE], 3, s->n))
        fault = image_source_refuse(s, "its header has DimSize = %.60s: three numbers are needed", m->value[SIZE]);
    free(m);
    return fault;
}

/* The compressed bytes begin where others would. */
static int open_data(struct image_source *s, const char *path, const struct image_header *h) {
    if (h->is_compressed) return image_inflate_open(s, path, h->skip, 0, h->order);
    return image_raw_open(s, path, h->skip, h->order);
}

int image_mhd_open(struct image_source *s, const struct files_image_input *input) {
    return image_header_open(s, input, image_mhd_parse, open_data);
}
