/* The formats of images: which one a file has, how each is opened, and the types of their numbers. An open function
 * sets the source's size, type, voxel and `read`; nonzero with a sentence. Private to base/files/. */
#pragma once
#include "base/files/image/header.h"

/* The formats' words, and which one a file has: by the first bytes, then by the name: s->format. */
const char *image_kind_word(enum files_image_format format);
int image_kind_find(struct image_source *s, const struct files_image_input *input);
/* Whether the first n bytes of a file are those of numbers written as text: digits, and blanks or ends of lines. */
int image_kind_is_text(const char *bytes, size_t n);

/* The types of voxels: words, bytes, conversion. */
const char *image_number_word(enum files_image_type type);
int image_number_bytes(enum files_image_type type);        /* of one */
int image_number_is_swapped(enum files_image_order order); /* against this machine; automatic: little */
/* n numbers as they stand in a file, at any alignment. */
void image_number_convert(enum files_image_type type, int swapped, const void *bytes, long n, double *value);

/* Voxels one after the other in a file: a raw file, or the data of a MetaImage or NRRD. They follow `skip` bytes, or
 * are the file's last bytes (IMAGE_RAW_AT_END); s->n and s->type say how many they are. The file must end with them. */
enum { IMAGE_RAW_AT_END = -1 };
int image_raw_open(struct image_source *s, const char *path, long long skip, enum files_image_order order);
/* The same in a file that gzip or zlib compressed. The compressed bytes begin at `at`; `skip` of the uncompressed ones
 * come before the voxels. */
int image_inflate_open(struct image_source *s, const char *path, long long at, long long skip,
                       enum files_image_order order);

/* Arrays of numpy (.npy): one of three dimensions, in its order of memory. */
int image_npy_open(struct image_source *s, const struct files_image_input *input);
/* MetaImage: a text header (.mhd) beside a raw file, or before the voxels (.mha). */
int image_mhd_open(struct image_source *s, const struct files_image_input *input);
/* NRRD: a text header before the voxels (.nrrd) or beside their file (.nhdr); raw or compressed by gzip. */
int image_nrrd_open(struct image_source *s, const struct files_image_input *input);
image_header_parse image_mhd_parse, image_nrrd_parse;

/* TIFF: a page a slice, grey or labels, in strips or tiles. */
int image_tiff_open(struct image_source *s, const struct files_image_input *input);
/* A folder of slices: TIFFs of one page each, whose names differ by a number alone. The numbers must follow one
 * another; other files of the folder are left alone. */
int image_slices_are(const char *path); /* whether a path is a folder */
int image_slices_open(struct image_source *s, const struct files_image_input *input);

/* HDF5: a dataset of three dimensions, [z][y][x] unless the axes are given otherwise; chunked or compressed too. */
int image_hdf5_open(struct image_source *s, const struct files_image_input *input);
/* Checks the superblock of a file of so many bytes by plain reading, before HDF5 opens it: its version, the sizes of
 * addresses, the end of the file and the place of the root group must be possible. */
int image_hdf5_check(struct image_source *s, int fd, long long bytes);

/* Voxels inside a closed surface of triangles (STL, binary or text): 1 inside, 0 outside. The surface's bounding box is
 * cut into voxels from its low corner on; input->edge is needed.
 *
 * Corners and centres of voxels are rounded to whole numbers of 2^-29 of the longest edge of the bounding box: corners
 * closer than this are one. With whole numbers all is exact. A centre on the surface counts as a little lower along x,
 * y and z, so a box from a to b has the centres a < x <= b. */
int image_stl_open(struct image_source *s, const struct files_image_input *input);
/* The triangles: malloc'ed [triangles][corner][x, y, z] in the file's unit; NULL with a sentence. */
double (*image_stl_read(struct image_source *s, const char *path, int *triangles))[3][3];
/* Whether a file of so many bytes that begins with these is an STL. */
int image_stl_read_is(const char *first, size_t n, long long bytes);
