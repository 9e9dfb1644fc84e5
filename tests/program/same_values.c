/* Whether two HDF5 files hold the same numbers to the bit, in datasets and attributes; times of writing may differ.
 * Prints the names that differ. usage: same_values FILE OTHER */
#include "base/par.h"

#include <hdf5.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int compared, differing;

/* The numbers of a dataset or attribute, and their bytes; NULL: it is missing or a text. */
static void *dataset_read(hid_t file, const char *path, size_t *bytes) {
    const hid_t set = H5Dopen2(file, path, H5P_DEFAULT);
    if (set < 0) return NULL;
    const hid_t type = H5Dget_type(set), space = H5Dget_space(set);
    *bytes = H5Tget_size(type) * (size_t)H5Sget_simple_extent_npoints(space);
    void *value = H5Tget_class(type) == H5T_STRING ? NULL : calloc(*bytes + 1, 1);
    if (value && *bytes > 0 && H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, value) < 0) *bytes = 0;
    H5Sclose(space);
    H5Tclose(type);
    H5Dclose(set);
    return value;
}

static void *attribute_read(hid_t file, const char *path, const char *name, size_t *bytes) {
    const hid_t attribute = H5Aopen_by_name(file, path, name, H5P_DEFAULT, H5P_DEFAULT);
    if (attribute < 0) return NULL;
    const hid_t type = H5Aget_type(attribute), space = H5Aget_space(attribute);
    *bytes = H5Tget_size(type) * (size_t)H5Sget_simple_extent_npoints(space);
    void *value = H5Tget_class(type) == H5T_STRING ? NULL : calloc(*bytes + 1, 1);
    if (value && H5Aread(attribute, type, value) < 0) *bytes = 0;
    H5Sclose(space);
    H5Tclose(type);
    H5Aclose(attribute);
    return value;
}

static void compare(const char *path, const char *name, void *a, size_t a_bytes, void *b, size_t b_bytes) {
    if (a) compared++;
    if (a && (!b || a_bytes != b_bytes || memcmp(a, b, a_bytes) != 0)) {
        printf("%s %s\n", path, name);
        differing++;
    }
    free(a);
    free(b);
}

struct pair {
    hid_t file, other;
    const char *path;
};

static herr_t attribute_look(hid_t attribute, const char *name, const H5A_info_t *info, void *data) {
    const struct pair *p = data;
    size_t a_bytes = 0, b_bytes = 0;
    (void)attribute, (void)info;
    void *a = attribute_read(p->file, p->path, name, &a_bytes), *b = attribute_read(p->other, p->path, name, &b_bytes);
    compare(p->path, name, a, a_bytes, b, b_bytes);
    return 0;
}

static herr_t look(hid_t root, const char *path, const H5O_info_t *info, void *data) {
    struct pair p = *(const struct pair *)data;
    size_t a_bytes = 0, b_bytes = 0;
    (void)root;
    p.path = path;
    H5Aiterate_by_name(p.file, path, H5_INDEX_NAME, H5_ITER_INC, NULL, attribute_look, &p, H5P_DEFAULT);
    if (info->type != H5O_TYPE_DATASET) return 0;
    void *a = dataset_read(p.file, path, &a_bytes), *b = dataset_read(p.other, path, &b_bytes);
    compare(path, "", a, a_bytes, b, b_bytes);
    return 0;
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    if (argc != 3) return 2;
    struct pair p = {H5Fopen(argv[1], H5F_ACC_RDONLY, H5P_DEFAULT), H5Fopen(argv[2], H5F_ACC_RDONLY, H5P_DEFAULT), ""};
    if (p.file < 0 || p.other < 0) return 2;
    H5Ovisit2(p.file, H5_INDEX_NAME, H5_ITER_NATIVE, look, &p, H5O_INFO_BASIC);
    H5Fclose(p.file);
    H5Fclose(p.other);
    printf("%d arrays and numbers, %d differ\n", compared, differing);
    par_end();
    return differing > 0 || compared < 4;
}
