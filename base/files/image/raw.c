/* Reads boxes of voxels that stand in a file one after the other. */
#include "base/files/image/formats.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

struct raw {
    int fd, swapped;
    long long at; /* byte of the first voxel */
    char *row;    /* rows of a block, as in the file */
};

enum { SHORT = 4096 }; /* bytes: parts of such rows are read with what is between them, by fewer calls */

/* n voxels of each of some rows, of which the first begins at the voxel `first`. */
static int take(struct image_source *s, long long first, long rows, long n, double *value) {
    const struct raw *raw = s->file;
    const long bytes = image_number_bytes(s->type), span = (rows - 1) * s->n[0] + n;
    if (image_source_take(s, raw->fd, raw->at + first * bytes, raw->row, (size_t)(span * bytes))) return 1;
    if (n == s->n[0])
        image_number_convert(s->type, raw->swapped, raw->row, span, value);
    else
        for (long j = 0; j < rows; j++)
            image_number_convert(s->type, raw->swapped, raw->row + j * s->n[0] * bytes, n, value + j * n);
    return 0;
}

static int read_box(struct image_source *s, const long low[3], const long high[3], double *value) {
    const long n = high[0] - low[0], is_short = s->n[0] * image_number_bytes(s->type) <= SHORT;
    const long rows = is_short || n == s->n[0] ? high[1] - low[1] : 1; /* at once */
    for (long k = low[2]; k < high[2]; k++)
        for (long j = low[1]; j < high[1]; j += rows, value += rows * n)
            if (take(s, ((long long)k * s->n[1] + j) * s->n[0] + low[0], rows, n, value)) return 1;
    return 0;
}

static void close_file(struct image_source *s) {
    struct raw *raw = s->file;
    close(raw->fd);
    free(raw->row);
    free(raw);
}

static int is_text(struct image_source *s, int fd, long long has) {
    char text[512];
    const size_t n = has < (long long)sizeof text ? (size_t)has : sizeof text;
    return n >= 2 && !image_source_take(s, fd, 0, text, n) && image_kind_is_text(text, n);
}

static int check_bytes(struct image_source *s, int fd, long long has, long long *skip) {
    char size[IMAGE_SIZE_TEXT], before[64] = "", hint[64] = "";
    long long wants, whole;
    if (image_source_bytes(s, &wants)) return 1;
    if (*skip == IMAGE_RAW_AT_END) *skip = has > wants ? has - wants : 0;
    if (is_text(s, fd, has))
        return image_source_refuse(s,
                                   "%s holds numbers written as text: in Python "
                                   "numpy.loadtxt(FILE).astype('%s').tofile('image.raw') makes a raw file",
                                   s->subject, image_number_word(s->type));
    if (!__builtin_add_overflow(wants, *skip, &whole) && has == whole) return 0;
    const long long voxels = wants / image_number_bytes(s->type), rest = has - *skip;
    if (*skip) snprintf(before, sizeof before, " after %lld of a header", *skip);
    if (rest == voxels)
        snprintf(hint, sizeof hint, "; there is 1 byte a voxel");
    else if (rest > 0 && rest % voxels == 0 && rest / voxels <= 8)
        snprintf(hint, sizeof hint, "; there are %lld bytes a voxel", rest / voxels);
    return image_source_refuse(s, "%s has %lld bytes, but %s of %s take %lld%s%s", s->subject, has,
                               image_source_size(s, size), image_number_word(s->type), wants, before, hint);
}

int image_raw_open(struct image_source *s, const char *path, long long skip, enum files_image_order order) {
    long long has;
    const int fd = image_source_file(s, path, &has);
    if (fd < 0) return 1;
    if (check_bytes(s, fd, has, &skip)) {
        close(fd);
        return 1;
    }
    struct raw *raw = image_source_new(1, sizeof *raw);
    *raw = (struct raw){fd, image_number_is_swapped(order), skip, image_source_new(1 << 16, 8)};
    image_source_block(s);
    s->file = raw;
    s->read = read_box;
    s->close = close_file;
    return 0;
}
