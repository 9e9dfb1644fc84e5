/* Reads the header of a MetaImage: lines of `Key = value`, of which ElementDataFile is the last. */
#include "base/files/image/mhd.h"
#include "base/files/image/inflate.h"
#include "base/files/image/number.h"
#include "base/files/image/raw.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

enum key {
    OBJECT,
    DIMENSIONS,
    SIZE,
    BINARY,
    COMPRESSED,
    MSB,
    MSB_TOO,
    HEADER,
    CHANNELS,
    SPACING,
    ELEMENT_SIZE,
    UNITS,
    TYPE,
    DATA,
    KEYS
};

/* Others say where the image stands in the world or what it shows: they change no voxel. */
static const char *const key_word[KEYS] = {[OBJECT] = "ObjectType",
                                           [DIMENSIONS] = "NDims",
                                           [SIZE] = "DimSize",
                                           [BINARY] = "BinaryData",
                                           [COMPRESSED] = "CompressedData",
                                           [MSB] = "ElementByteOrderMSB",
                                           [MSB_TOO] = "BinaryDataByteOrderMSB",
                                           [HEADER] = "HeaderSize",
                                           [CHANNELS] = "ElementNumberOfChannels",
                                           [SPACING] = "ElementSpacing",
                                           [ELEMENT_SIZE] = "ElementSize",
                                           [UNITS] = "DistanceUnits",
                                           [TYPE] = "ElementType",
                                           [DATA] = "ElementDataFile"};

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
    while (!m->value[DATA][0] && image_header_line(&at, line)) {
        char *sign = strpbrk(line, "=:");
        if (!sign) continue;
        *sign = '\0';
        const int k = image_header_find(image_header_trim(line), key_word, KEYS);
        if (k < 0) continue;
        if (m->value[k][0]) return image_source_refuse(s, "its header gives %s twice", key_word[k]);
        snprintf(m->value[k], sizeof m->value[k], "%s", image_header_trim(sign + 1));
    }
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
    struct mhd *m = calloc(1, sizeof *m);
    memset(h, 0, sizeof *h);
    if (!m) return image_source_refuse(s, "no memory left to read it");
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
    struct image_header h;
    char path[4096];
    size_t bytes;
    char *text = image_header_load(s, input->file, &bytes);
    const int fault = !text || image_mhd_parse(s, text, bytes, &h);
    free(text);
    if (fault || image_header_order(s, &h, input->byte_order)) return 1;
    if (!h.data[0]) return open_data(s, input->file, &h);
    return image_header_path(s, input->file, h.data, path, sizeof path) || open_data(s, path, &h);
}
