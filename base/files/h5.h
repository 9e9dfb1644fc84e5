/* HDF5 files written and read by all ranks together: contiguous datasets, each rank a block of them, every rank in
 * every transfer (with nothing selected where it has nothing). Used by store and vtkhdf only; images are opened by
 * h5_open_alone.
 *
 * After a fault of the disk all ranks agree on it, and all calls do nothing until h5_end reports it. */
#pragma once
#include "base/files/seal.h"

#include <hdf5.h>
#include <stddef.h>
#include <sys/types.h>

enum { H5_DIMS = 4 };

struct h5 {
    hid_t file;
    int shared;     /* more than one rank has it open */
    int failed;     /* the same on all ranks */
    int stuck;      /* the file cannot be written or closed; HDF5 must not be called for it again */
    int unsynced;   /* set after h5_begin: the file is not flushed to the disk */
    off_t at, end;  /* of the last array in the file */
    off_t reserved; /* bytes reserved on the disk, on rank 0 */
    char path[1024], part[1032];
    char why[256];     /* the first fault */
    struct seal *seal; /* set after h5_begin: appended to the file when it is closed; borrowed */
};

/* A block of an array of dims dimensions: n, size of the whole array; lo, first index of this rank's block; m, its
 * size. */
struct h5_block {
    int dims;
    hsize_t n[H5_DIMS], lo[H5_DIMS], m[H5_DIMS];
};

/* Writes to PATH.part until h5_end. Collective. */
void h5_begin(struct h5 *f, const char *path);
void h5_group(struct h5 *f, const char *name);
/* type is the type in the file and in memory; value is this rank's block, contiguous. Collective. */
void h5_write(struct h5 *f, const char *name, hid_t type, const struct h5_block *block, const void *value);
/* Attributes of the group or dataset `object_path`; count < 0: a scalar. Collective, the same on all ranks. */
void h5_attribute(struct h5 *f, const char *object_path, const char *name, hid_t type, int count, const void *value);
void h5_attribute_text(struct h5 *f, const char *object_path, const char *name, const char *value);
/* Closes the file, flushes it to the disk (unless unsynced), renames it. On a fault: deletes the .part file, leaves the
 * old file as it was, and dies with exit code 4. Collective. */
void h5_end(struct h5 *f);

/* alone: this rank only. 0, or nonzero with f->why. Collective unless alone. */
int h5_read_open(struct h5 *f, const char *path, int alone);
/* 0, or nonzero with f->why when it is missing, of another class, or not of size b->n. Collective unless alone. */
int h5_read(struct h5 *f, const char *name, hid_t type, const struct h5_block *block, void *value);
/* Size of a dataset; returns its dimensions, or -1 when it is missing. */
int h5_read_size(struct h5 *f, const char *name, hsize_t n[H5_DIMS]);
/* A text of any length. */
void h5_write_text(struct h5 *f, const char *name, const char *value);
int h5_read_text(struct h5 *f, const char *name, char *value, size_t bytes);
int h5_read_attribute(struct h5 *f, const char *object_path, const char *name, hid_t type, int count, void *value);
int h5_read_attribute_text(struct h5 *f, const char *object_path, const char *name, char *value, size_t bytes);
void h5_read_close(struct h5 *f);

/* Shared by h5.c and h5_read.c. */
hid_t h5_access_list(const struct h5 *f);
hid_t h5_open_alone(const char *path); /* for reading, by one rank */
hid_t h5_transfer_list(const struct h5 *f);
hsize_t h5_items(const struct h5_block *block, const hsize_t m[H5_DIMS]);
/* Selects this rank's block in the file, and the same number of items in memory; makes *in_memory. */
void h5_select(const struct h5_block *block, hid_t in_file, hid_t *in_memory);
