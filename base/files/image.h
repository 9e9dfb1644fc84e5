/* Images of voxels: raw bytes, MetaImage, NRRD, TIFF, HDF5, numpy, and surfaces (STL). A file is opened by its header
 * alone; then boxes of it are read, by each rank its own. The result is always x fastest, whatever the file's order.
 *
 *     struct files_image *image = files_image_open(&input, problem, sizeof problem);
 *     const long *n = files_image_size(image);
 *     files_image_read(image, (long[]){0, 0, 0}, n, value, problem, sizeof problem);
 *     files_image_close(image); */
#pragma once
#include <stddef.h>

enum files_image_format {
    FILES_IMAGE_AUTO, /* by the file's first bytes, then by its name; raw if a size is given */
    FILES_IMAGE_RAW,
    FILES_IMAGE_MHD,
    FILES_IMAGE_NRRD,
    FILES_IMAGE_TIFF,
    FILES_IMAGE_HDF5,
    FILES_IMAGE_NPY,
    FILES_IMAGE_STL,
    FILES_IMAGE_FORMATS
};

enum files_image_type {
    FILES_IMAGE_HEADER, /* what the header says; a raw file has none */
    FILES_IMAGE_INT8,
    FILES_IMAGE_UINT8,
    FILES_IMAGE_INT16,
    FILES_IMAGE_UINT16,
    FILES_IMAGE_INT32,
    FILES_IMAGE_UINT32,
    FILES_IMAGE_INT64,
    FILES_IMAGE_UINT64,
    FILES_IMAGE_FLOAT32,
    FILES_IMAGE_FLOAT64,
    FILES_IMAGE_TYPES
};

enum files_image_order {
    FILES_IMAGE_ORDER_AUTO, /* what the header says; little in a raw file */
    FILES_IMAGE_LITTLE,
    FILES_IMAGE_BIG
};

/* What the user says of the file. What a header says too must agree with it. All but file may be left 0. */
struct files_image_input {
    const char *file;
    enum files_image_format format;
    const char *dataset;        /* HDF5: its path; NULL or "": the only one of three dimensions */
    long size[3];               /* voxels along x, y, z; raw: needed */
    enum files_image_type type; /* raw: needed */
    enum files_image_order byte_order;
    char axes[4];      /* which axis varies first, second, third in the file; "": xyz */
    long header_bytes; /* raw: bytes before the first voxel */
    double edge[3];    /* STL: the edges of a voxel along x, y, z in the file's unit */
};

struct files_image; /* opaque, owned by the caller */

/* Reads the header. NULL if the file cannot be read: problem is then one sentence that begins with the file's name. Not
 * collective, as all functions here. */
struct files_image *files_image_open(const struct files_image_input *input, char *problem, size_t capacity);
void files_image_close(struct files_image *image); /* may be NULL */

const long *files_image_size(const struct files_image *image); /* [3] voxels along x, y, z */
/* [3] size of a voxel along x, y, z in files_image_unit; 0: the file does not say */
const double *files_image_voxel(const struct files_image *image);
/* "m", or "" where the file gives numbers without a unit */
const char *files_image_unit(const struct files_image *image);
enum files_image_format files_image_format_of(const struct files_image *image);
enum files_image_type files_image_type_of(const struct files_image *image);
/* The words of a scene: raw, mhd, ...; uint8, ... */
const char *files_image_format_word(enum files_image_format format);
const char *files_image_type_word(enum files_image_type type);

/* The voxels low <= [x, y, z] < high, x fastest. Reads only what holds them; takes at most some tens of MB beside
 * value. Nonzero with a sentence if the file cannot be read, or if a value is not a whole number within int, as in an
 * image of grey values as floating point. */
int files_image_read(struct files_image *image, const long low[3], const long high[3], int *value, char *problem,
                     size_t capacity);
/* The same with values of any kind, for a threshold. */
int files_image_read_real(struct files_image *image, const long low[3], const long high[3], double *value,
                          char *problem, size_t capacity);
