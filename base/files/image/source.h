/* An open file of voxels, whatever its format; axes in the file's order, the fastest first. Private to base/files/. */
#pragma once
#include "base/files/image.h"

enum { IMAGE_WHY = 700, IMAGE_MAX = 1 << 22, IMAGE_SIZE_TEXT = 96 };

struct image_source {
    enum files_image_format format;
    enum files_image_type type;
    int axis[3]; /* which of x, y, z each of the file's axes is */
    long n[3];
    double voxel[3];  /* 0: not said */
    const char *unit; /* static */
    /* Boxes that begin at multiples of `block` and are no larger are read at little cost; at most IMAGE_MAX voxels. */
    long block[3];
    /* Reads a box of one block into value, the file's first axis fastest; nonzero with a sentence in `why`. */
    int (*read)(struct image_source *s, const long low[3], const long high[3], double *value);
    void (*close)(struct image_source *s);
    void *file;        /* of the format; owned, freed by close */
    char subject[300]; /* of sentences about the file of the voxels: "it", "its data file rock.raw" */
    char why[IMAGE_WHY];
};

/* Zeros, malloc'ed. Dies (exit 4) without memory. */
void *image_source_new(size_t count, size_t size);
/* Writes the sentence; returns 1. */
int image_source_refuse(struct image_source *s, const char *format, ...) __attribute__((format(printf, 2, 3)));
/* "110 x 110 x 110 voxels", along x, y and z. */
const char *image_source_size(const struct image_source *s, char text[IMAGE_SIZE_TEXT]);
/* Checks n and type, and gives the bytes of all voxels; nonzero with a sentence if there are none or too many. */
int image_source_bytes(struct image_source *s, long long *bytes);
/* Blocks of about 2^16 voxels in some planes, for files in which any box is read as fast. */
void image_source_block(struct image_source *s);
/* Blocks whose order is that of the file, for those that are read from the start. */
void image_source_block_in_turn(struct image_source *s);
/* Opens a regular file for reading: its descriptor, or -1 with a sentence. */
int image_source_file(struct image_source *s, const char *path, long long *bytes);
/* The first bytes of a file, at most so many, with a 0 behind them; malloc'ed. bytes: how many there are. NULL with a
 * sentence. */
char *image_source_load(struct image_source *s, const char *path, long long most, long long *bytes);
/* Reads exactly so many bytes; nonzero with a sentence. */
int image_source_take(struct image_source *s, int fd, long long at, void *to, size_t bytes);
