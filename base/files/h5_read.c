/* Reads arrays, texts and attributes from HDF5 files on all ranks or on one. */
#include "base/par.h"
#include "base/files/h5.h"
#include "base/files/plain_file.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

/* Whether one rank can open the file by the plain driver; tells apart a missing file, a foreign one and a truncated
 * one. */
static int probe(struct h5 *f) {
    FILE *plain = plain_file_read(f->path); /* HDF5 would wait for a pipe */
    if (!plain) {
        snprintf(f->why, sizeof f->why, "%s", plain_file_why(errno));
        return 1;
    }
    fclose(plain);
    if (H5Fis_hdf5(f->path) <= 0) {
        snprintf(f->why, sizeof f->why, "it is not an HDF5 file");
        return 1;
    }
    const hid_t file = h5_open_alone(f->path);
    if (file < 0) {
        snprintf(f->why, sizeof f->why, "it is truncated or damaged");
        return 1;
    }
    H5Fclose(file);
    return 0;
}

int h5_read_open(struct h5 *f, const char *path, int alone) {
    H5Eset_auto2(H5E_DEFAULT, NULL, NULL);
    memset(f, 0, sizeof *f);
    f->file = -1;
    f->shared = !alone && par_size() > 1;
    snprintf(f->path, sizeof f->path, "%s", path);
    if (!f->shared || par_rank() == 0) f->failed = probe(f);
    if (f->shared) {
        par_bcast(&f->failed, sizeof f->failed, 0);
        par_bcast(f->why, sizeof f->why, 0);
    }
    if (f->failed) return 1;
    const hid_t list = h5_access_list(f);
    f->file = H5Fopen(path, H5F_ACC_RDONLY, list);
    H5Pclose(list);
    f->failed = f->file < 0;
    if (f->shared) f->failed = par_max(f->failed) > 0;
    if (f->failed) snprintf(f->why, sizeof f->why, "HDF5 cannot open it");
    return f->failed;
}

void h5_read_close(struct h5 *f) {
    if (f->file >= 0) H5Fclose(f->file);
    f->file = -1;
}

static int exists(struct h5 *f, const char *name) {
    char path[256];
    snprintf(path, sizeof path, "%s", name);
    for (char *slash = strchr(path + 1, '/'); slash; slash = strchr(slash + 1, '/')) {
        *slash = '\0'; /* HDF5 wants each group of the path to be queried separately */
        if (H5Lexists(f->file, path, H5P_DEFAULT) <= 0) return 0;
        *slash = '/';
    }
    return H5Lexists(f->file, path, H5P_DEFAULT) > 0;
}

int h5_read_size(struct h5 *f, const char *name, hsize_t n[H5_DIMS]) {
    int dims = -1;
    const hid_t set = exists(f, name) ? H5Dopen2(f->file, name, H5P_DEFAULT) : -1;
    if (set < 0) return -1;
    const hid_t space = H5Dget_space(set);
    if (H5Sget_simple_extent_ndims(space) <= H5_DIMS) dims = H5Sget_simple_extent_dims(space, n, NULL);
    H5Sclose(space);
    H5Dclose(set);
    return dims;
}

/* Whether the types agree: integers of the same width; or both floating point, double or float. */
static int is_alike(hid_t set, hid_t type) {
    const hid_t stored = H5Dget_type(set);
    const H5T_class_t class = H5Tget_class(type);
    int alike = H5Tget_class(stored) == class;
    if (class == H5T_INTEGER) alike = alike && H5Tget_size(stored) <= H5Tget_size(type);
    H5Tclose(stored);
    return alike;
}

static int check(struct h5 *f, const char *name, hid_t set, hid_t type, const struct h5_block *block) {
    hsize_t n[H5_DIMS];
    if (set < 0) {
        snprintf(f->why, sizeof f->why, "it has no array %s", name);
        return 1;
    }
    const int dims = h5_read_size(f, name, n);
    int same = dims == block->dims;
    for (int k = 0; same && k < dims; k++) same = n[k] == block->n[k];
    if (!same) {
        int at = snprintf(f->why, sizeof f->why, "its array %s is of size", name);
        for (int k = 0; k < dims; k++)
            at +=
                snprintf(f->why + at, sizeof f->why - (size_t)at, "%s%llu", k ? " x " : " ", (unsigned long long)n[k]);
        at += snprintf(f->why + at, sizeof f->why - (size_t)at, ", not");
        for (int k = 0; k < block->dims; k++)
            at += snprintf(f->why + at, sizeof f->why - (size_t)at, "%s%llu", k ? " x " : " ",
                           (unsigned long long)block->n[k]);
        return 1;
    }
    if (!is_alike(set, type)) {
        snprintf(f->why, sizeof f->why, "its array %s holds another type of number", name);
        return 1;
    }
    return 0;
}

int h5_read(struct h5 *f, const char *name, hid_t type, const struct h5_block *block, void *value) {
    static char nothing;
    const hid_t set = exists(f, name) ? H5Dopen2(f->file, name, H5P_DEFAULT) : -1;
    int fault = check(f, name, set, type, block);
    if (!fault && h5_items(block, block->n) > 0) { /* the same on all ranks: they see the same file */
        hid_t memory;
        const hid_t space = H5Dget_space(set), transfer = h5_transfer_list(f);
        h5_select(block, space, &memory);
        fault = H5Dread(set, type, memory, space, transfer, value ? value : &nothing) < 0;
        if (f->shared) fault = par_max(fault) > 0;
        if (fault) snprintf(f->why, sizeof f->why, "its array %s cannot be read", name);
        H5Sclose(memory);
        H5Pclose(transfer);
        H5Sclose(space);
    }
    if (set >= 0) H5Dclose(set);
    return fault;
}

int h5_read_text(struct h5 *f, const char *name, char *value, size_t bytes) {
    const struct h5_block b = {.dims = 1, .n = {1}, .m = {1}};
    const hid_t set = exists(f, name) ? H5Dopen2(f->file, name, H5P_DEFAULT) : -1;
    const hid_t stored = set < 0 ? -1 : H5Dget_type(set);
    int fault = set < 0;
    if (fault) snprintf(f->why, sizeof f->why, "it has no text %s", name);
    if (!fault && (H5Tget_class(stored) != H5T_STRING || H5Tget_size(stored) > bytes)) {
        snprintf(f->why, sizeof f->why, "its %s is not a text of less than %zu bytes", name, bytes);
        fault = 1;
    }
    if (!fault) fault = h5_read(f, name, stored, &b, value);
    if (stored >= 0) H5Tclose(stored);
    if (set >= 0) H5Dclose(set);
    return fault;
}

static hid_t attribute_open(struct h5 *f, const char *object_path, const char *name) {
    if (strcmp(object_path, "/") != 0 && !exists(f, object_path)) return -1;
    if (H5Aexists_by_name(f->file, object_path, name, H5P_DEFAULT) <= 0) return -1;
    return H5Aopen_by_name(f->file, object_path, name, H5P_DEFAULT, H5P_DEFAULT);
}

int h5_read_attribute(struct h5 *f, const char *object_path, const char *name, hid_t type, int count, void *value) {
    const hid_t a = attribute_open(f, object_path, name);
    int fault = a < 0;
    if (fault) snprintf(f->why, sizeof f->why, "it has no value %s", name);
    if (!fault) {
        const hid_t space = H5Aget_space(a), stored = H5Aget_type(a);
        fault = H5Sget_simple_extent_npoints(space) != (count < 0 ? 1 : count) ||
                H5Tget_class(stored) != H5Tget_class(type) || H5Aread(a, type, value) < 0;
        if (fault) snprintf(f->why, sizeof f->why, "its value %s is of another kind", name);
        H5Tclose(stored);
        H5Sclose(space);
    }
    if (a >= 0) H5Aclose(a);
    return fault;
}

int h5_read_attribute_text(struct h5 *f, const char *object_path, const char *name, char *value, size_t bytes) {
    const hid_t a = attribute_open(f, object_path, name);
    int fault = a < 0;
    if (fault) snprintf(f->why, sizeof f->why, "it has no value %s", name);
    if (!fault) {
        const hid_t stored = H5Aget_type(a);
        const size_t length = H5Tget_size(stored);
        fault = H5Tget_class(stored) != H5T_STRING || H5Tis_variable_str(stored) > 0 || length >= bytes;
        if (!fault) {
            memset(value, 0, bytes);
            fault = H5Aread(a, stored, value) < 0;
        }
        if (fault) snprintf(f->why, sizeof f->why, "its value %s is of another kind", name);
        H5Tclose(stored);
    }
    if (a >= 0) H5Aclose(a);
    return fault;
}
