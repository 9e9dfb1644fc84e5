/* Opens images of voxels of any format; reads boxes of them with x fastest. */
#include "base/files/image.h"
#include "base/ensure.h"
#include "base/files/image/formats.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct files_image {
    struct image_source source; /* axes in the file's order */
    char *name;
    long size[3]; /* along x, y, z */
    double voxel[3];
    double *block; /* of the source's order and size of blocks */
};

const char *files_image_format_word(enum files_image_format format) { return image_kind_word(format); }
const char *files_image_type_word(enum files_image_type type) { return image_number_word(type); }
const long *files_image_size(const struct files_image *image) { return image->size; }
const double *files_image_voxel(const struct files_image *image) { return image->voxel; }
const char *files_image_unit(const struct files_image *image) { return image->source.unit; }
enum files_image_format files_image_format_of(const struct files_image *image) { return image->source.format; }
enum files_image_type files_image_type_of(const struct files_image *image) { return image->source.type; }

static int open_raw(struct image_source *s, const struct files_image_input *input) {
    for (int f = 0; f < 3; f++) s->n[f] = input->size[s->axis[f]];
    if (s->n[0] == 0 && s->n[1] == 0 && s->n[2] == 0)
        return image_source_refuse(s, "a raw file has no header: its size is needed");
    if (input->type == FILES_IMAGE_HEADER)
        return image_source_refuse(s, "a raw file has no header: the type of its voxels is needed");
    if (input->header_bytes < 0) return image_source_refuse(s, "a header has no negative number of bytes");
    s->type = input->type;
    return image_raw_open(s, input->file, input->header_bytes, input->byte_order);
}

static int open_format(struct image_source *s, const struct files_image_input *input) {
    s->format = input->format;
    if ((s->format == FILES_IMAGE_AUTO || s->format == FILES_IMAGE_TIFF) && image_slices_are(input->file))
        return image_slices_open(s, input);
    if (s->format == FILES_IMAGE_AUTO && image_kind_find(s, input)) return 1;
    switch (s->format) {
    case FILES_IMAGE_RAW:
        return open_raw(s, input);
    case FILES_IMAGE_MHD:
        return image_mhd_open(s, input);
    case FILES_IMAGE_NRRD:
        return image_nrrd_open(s, input);
    case FILES_IMAGE_TIFF:
        return image_tiff_open(s, input);
    case FILES_IMAGE_HDF5:
        return image_hdf5_open(s, input);
    case FILES_IMAGE_NPY:
        return image_npy_open(s, input);
    case FILES_IMAGE_STL:
        return image_stl_open(s, input);
    case FILES_IMAGE_AUTO:
    case FILES_IMAGE_FORMATS:
        break;
    }
    ENSURE(0, "format %d", (int)s->format);
}

/* "zyx": the file's first axis is z. */
static int read_axes(struct image_source *s, const char axes[4]) {
    const char *order = axes[0] ? axes : "xyz";
    int seen = 0;
    for (int f = 0; f < 3; f++) {
        const int c = order[f] - 'x';
        if (c < 0 || c > 2 || (seen & 1 << c) || order[3])
            return image_source_refuse(s, "axes = %.4s: each of x, y and z is needed once, as in xyz or zyx", order);
        s->axis[f] = c;
        seen |= 1 << c;
    }
    return 0;
}

/* What the user says must agree with the header, and go with the format. */
static int compare(struct image_source *s, const struct files_image_input *input) {
    char size[IMAGE_SIZE_TEXT];
    const long *n = input->size;
    if (input->header_bytes && s->format != FILES_IMAGE_RAW)
        return image_source_refuse(s, "bytes of a header are given, and it is not a raw file (%s)",
                                   image_kind_word(s->format));
    if (input->dataset && input->dataset[0] && s->format != FILES_IMAGE_HDF5)
        return image_source_refuse(s, "a dataset is given, and it is not an HDF5 file (%s)",
                                   image_kind_word(s->format));
    if (input->byte_order && (s->format == FILES_IMAGE_TIFF || s->format == FILES_IMAGE_HDF5 ||
                              s->format == FILES_IMAGE_NPY || s->format == FILES_IMAGE_STL))
        return image_source_refuse(s, "a byte order is given, and %s files say it themselves",
                                   image_kind_word(s->format));
    if (input->edge[0] > 0 && s->format != FILES_IMAGE_STL)
        return image_source_refuse(s, "a unit is given, and it is not an STL (%s)", image_kind_word(s->format));
    for (int f = 0; f < 3; f++)
        if (n[s->axis[f]] != 0 && n[s->axis[f]] != s->n[f])
            return image_source_refuse(s, "it has %s, and its size is given as %ld x %ld x %ld",
                                       image_source_size(s, size), n[0], n[1], n[2]);
    if (input->type != FILES_IMAGE_HEADER && input->type != s->type)
        return image_source_refuse(s, "its voxels are %s, and their type is given as %s", image_number_word(s->type),
                                   image_number_word(input->type));
    return 0;
}

static int begin(struct files_image *image, const struct files_image_input *input) {
    struct image_source *s = &image->source;
    s->unit = "";
    snprintf(s->subject, sizeof s->subject, "it");
    image->name = strdup(input->file);
    if (read_axes(s, input->axes) || open_format(s, input) || compare(s, input)) return 1;
    const size_t block = (size_t)s->block[0] * (size_t)s->block[1] * (size_t)s->block[2];
    image->block = image_source_new(block, sizeof *image->block);
    for (int f = 0; f < 3; f++) {
        const double voxel = s->voxel[f];
        image->size[s->axis[f]] = s->n[f];
        image->voxel[s->axis[f]] = voxel > 0 && isfinite(voxel) ? voxel : 0;
    }
    return 0;
}

static int report(const struct files_image *image, char *problem, size_t capacity) {
    snprintf(problem, capacity, "%s: %s", image->name, image->source.why);
    return 1;
}

struct files_image *files_image_open(const struct files_image_input *input, char *problem, size_t capacity) {
    struct files_image *image = image_source_new(1, sizeof *image);
    if (!begin(image, input)) return image;
    report(image, problem, capacity);
    files_image_close(image);
    return NULL;
}

void files_image_close(struct files_image *image) {
    if (!image) return;
    if (image->source.close) image->source.close(&image->source);
    free(image->block);
    free(image->name);
    free(image);
}

/* A box that is asked for, and where its voxels go: one of integer and real is NULL. */
struct box {
    long low[3], high[3]; /* along x, y, z */
    int *integer;
    double *real;
};

/* A block of voxels along x: strided as it was read, contiguous as it is wanted. Returns the first that is not a whole
 * number within int, or n. */
static long put_integers(const double *from, long stride, long n, int *to) {
    int bad = 0;
    for (long i = 0; i < n; i++) {
        const double v = from[i * stride];
        const int fits = v >= INT_MIN && v <= INT_MAX; /* NaN does not */
        to[i] = fits ? (int)v : 0;
        bad |= !fits | (to[i] != v);
    }
    if (!bad) return n;
    for (long i = 0; i < n; i++)
        if (!(from[i * stride] == to[i])) return i;
    return n;
}

static int refuse_value(struct files_image *image, const long at[3], double v) {
    return image_source_refuse(&image->source,
                               "voxel [%ld, %ld, %ld] is %.9g, and a label is a whole number between %d and %d: a "
                               "threshold or a segmented image is needed",
                               at[0], at[1], at[2], v, INT_MIN, INT_MAX);
}

/* Puts the block [low, high) of the file's axes where it belongs in the box. */
static int put_block(struct files_image *image, const struct box *box, const long low[3], const long high[3]) {
    const struct image_source *s = &image->source;
    long stride[3], from[3], to[3], step = 1;
    for (int f = 0; f < 3; f++) {
        const int c = s->axis[f];
        stride[c] = step;
        from[c] = low[f];
        to[c] = high[f];
        step *= high[f] - low[f];
    }
    const long mx = box->high[0] - box->low[0], my = box->high[1] - box->low[1], n = to[0] - from[0];
    for (long z = from[2]; z < to[2]; z++) {
        for (long y = from[1]; y < to[1]; y++) {
            const double *row = image->block + (z - from[2]) * stride[2] + (y - from[1]) * stride[1];
            const long at = ((z - box->low[2]) * my + (y - box->low[1])) * mx + (from[0] - box->low[0]);
            if (box->real) {
                for (long i = 0; i < n; i++) box->real[at + i] = row[i * stride[0]];
                continue;
            }
            const long wrong = put_integers(row, stride[0], n, box->integer + at);
            if (wrong < n) return refuse_value(image, (long[]){from[0] + wrong, y, z}, row[wrong * stride[0]]);
        }
    }
    return 0;
}

static int check_box(struct files_image *image, const struct box *box) {
    for (int c = 0; c < 3; c++)
        if (box->low[c] < 0 || box->high[c] > image->size[c] || box->low[c] > box->high[c])
            return image_source_refuse(&image->source, "voxels %ld to %ld along %c are asked for, and it has %ld",
                                       box->low[c], box->high[c], "xyz"[c], image -> size[c]);
    return 0;
}

/* Along each of the file's axes, from one multiple of the block to the next. */
static int read_blocks(struct files_image *image, const struct box *box) {
    struct image_source *s = &image->source;
    long low[3], high[3], from[3], to[3];
    if (check_box(image, box)) return 1;
    for (int f = 0; f < 3; f++) {
        from[f] = box->low[s->axis[f]];
        to[f] = box->high[s->axis[f]];
        if (from[f] == to[f]) return 0;
    }
#define NEXT(f) (high[f] = low[f] - low[f] % s->block[f] + s->block[f], high[f] = high[f] < to[f] ? high[f] : to[f])
    for (low[2] = from[2]; low[2] < to[2]; low[2] = high[2]) {
        NEXT(2);
        for (low[1] = from[1]; low[1] < to[1]; low[1] = high[1]) {
            NEXT(1);
            for (low[0] = from[0]; low[0] < to[0]; low[0] = high[0]) {
                NEXT(0);
                if (s->read(s, low, high, image->block) || put_block(image, box, low, high)) return 1;
            }
        }
    }
#undef NEXT
    return 0;
}

static int read_box(struct files_image *image, struct box box, const long low[3], const long high[3], char *problem,
                    size_t capacity) {
    memcpy(box.low, low, sizeof box.low);
    memcpy(box.high, high, sizeof box.high);
    return read_blocks(image, &box) && report(image, problem, capacity);
}

int files_image_read(struct files_image *image, const long low[3], const long high[3], int *value, char *problem,
                     size_t capacity) {
    return read_box(image, (struct box){.integer = value}, low, high, problem, capacity);
}

int files_image_read_real(struct files_image *image, const long low[3], const long high[3], double *value,
                          char *problem, size_t capacity) {
    return read_box(image, (struct box){.real = value}, low, high, problem, capacity);
}
