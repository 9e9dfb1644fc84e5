/* Reads the header of a .npy file: a dictionary of Python with the type, the order and the shape of the array. */
#include "base/files/image/formats.h"

#include <stdlib.h>
#include <string.h>

/* Eight bytes of magic and version, then the length of the dictionary in two bytes (version 1) or four.  (NumPy, NEP 1)
 */
enum { MAGIC = 6, START = 8, DIMS_MAX = 8, TEXT_MAX = 1 << 16 };

static int damaged(struct image_source *s) { return image_source_refuse(s, "its header of numpy is damaged"); }

/* The text behind 'key': in the dictionary; NULL: there is none. */
static const char *value_of(const char *text, const char *key) {
    for (const char *at = strchr(text, '\''); at; at = strchr(at + 1, '\'')) {
        const size_t n = strlen(key);
        if (strncmp(at + 1, key, n) != 0 || at[1 + n] != '\'') continue;
        at += n + 2;
        at += strspn(at, " ");
        if (*at == ':') return at + 1 + strspn(at + 1, " ");
    }
    return NULL;
}

/* '|u1', '<f4', '>i2', '|b1', ... */
static int read_type(struct image_source *s, const char *text, struct image_header *h) {
    static const struct {
        const char *word;
        enum files_image_type type;
    } known[] = {{"b1", FILES_IMAGE_UINT8},   {"i1", FILES_IMAGE_INT8},   {"u1", FILES_IMAGE_UINT8},
                 {"i2", FILES_IMAGE_INT16},   {"u2", FILES_IMAGE_UINT16}, {"i4", FILES_IMAGE_INT32},
                 {"u4", FILES_IMAGE_UINT32},  {"i8", FILES_IMAGE_INT64},  {"u8", FILES_IMAGE_UINT64},
                 {"f4", FILES_IMAGE_FLOAT32}, {"f8", FILES_IMAGE_FLOAT64}};
    const char *type = value_of(text, "descr");
    if (!type) return damaged(s);
    for (size_t k = 0; *type == '\'' && type[1] && k < sizeof known / sizeof *known; k++) {
        if (strncmp(type + 2, known[k].word, 2) != 0 || type[4] != '\'') continue;
        s->type = known[k].type;
        h->order = type[1] == '>' ? FILES_IMAGE_BIG : FILES_IMAGE_LITTLE;
        return 0;
    }
    return image_source_refuse(s,
                               "its numbers are of numpy's type %.*s: bool, integers and floating point of 4 or 8 "
                               "bytes are read",
                               (int)strcspn(type, ","), type);
}

/* The last index varies first, in Fortran's order the first. */
static int read_shape(struct image_source *s, const char *text) {
    const char *fortran = value_of(text, "fortran_order"), *at = value_of(text, "shape");
    const int is_fortran = fortran && !strncmp(fortran, "True", 4);
    long n[DIMS_MAX];
    int dims = 0;
    if (!fortran || !at || *at != '(') return damaged(s);
    for (at++; dims < DIMS_MAX; at += strspn(at, ", ")) {
        char *end;
        n[dims] = strtol(at, &end, 10);
        if (end == at) break;
        dims++;
        at = end;
    }
    if (dims != 3)
        return image_source_refuse(s,
                                   "its array has %d dimensions, its shape is %.*s), and 3 are needed; numpy.squeeze "
                                   "takes out those of length 1, and a[..., 0] is the first of several channels",
                                   dims, (int)strcspn(value_of(text, "shape"), ")"), value_of(text, "shape"));
    for (int f = 0; f < 3; f++) s->n[f] = n[is_fortran ? f : 2 - f];
    return 0;
}

static int parse(struct image_source *s, const char *bytes, size_t n, struct image_header *h) {
    const unsigned char *size = (const unsigned char *)bytes + START;
    memset(h, 0, sizeof *h);
    if (n < START + 4 || memcmp(bytes, "\223NUMPY", MAGIC) != 0)
        return image_source_refuse(s, "it is not a file of numpy");
    const int wide = bytes[MAGIC] > 1;
    size_t length = size[0] | (size_t)size[1] << 8;
    if (wide) length |= (size_t)size[2] << 16 | (size_t)size[3] << 24;
    const size_t start = START + (wide ? 4 : 2);
    if (length > TEXT_MAX || start + length > n) return damaged(s);
    char *text = image_source_new(length + 1, 1);
    memcpy(text, bytes + start, length);
    h->skip = (long long)(start + length);
    const int fault = read_type(s, text, h) || read_shape(s, text);
    free(text);
    return fault;
}

int image_npy_open(struct image_source *s, const struct files_image_input *input) {
    struct image_header h;
    long long n;
    char *bytes = image_source_load(s, input->file, IMAGE_HEADER_MAX, &n);
    const int fault = !bytes || parse(s, bytes, (size_t)n, &h);
    free(bytes);
    return fault || image_raw_open(s, input->file, h.skip, h.order);
}
