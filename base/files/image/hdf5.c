/* Reads boxes of a dataset of HDF5, each rank by itself. The last of HDF5's dimensions varies first. */
#include "base/files/image/formats.h"
#include "base/files/h5.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* What to do with more dimensions. */
#define HOW "; in Python, with h5py: f['image'] = f[NAME][..., 0] adds the first of several channels, or the only one"

struct hdf5 {
    hid_t file, set, space;
};

struct found {
    int n;
    char name[4][128];
    char other[192]; /* the first dataset of other dimensions, and these */
    int others;      /* how many these are */
};

/* "data of 9 x 10 x 12 x 1" */
static void describe(char *text, size_t capacity, const char *name, hid_t space) {
    enum { MOST = 8 };
    hsize_t n[H5S_MAX_RANK];
    const int dims = H5Sget_simple_extent_dims(space, n, NULL);
    snprintf(text, capacity, "%.80s of ", name);
    for (int k = 0; k < dims && k < MOST; k++)
        snprintf(text + strlen(text), capacity - strlen(text), "%s%llu", k ? " x " : "", (unsigned long long)n[k]);
    if (dims < 1) snprintf(text + strlen(text), capacity - strlen(text), "one number");
}

static herr_t found_object(hid_t in, const char *name, const H5O_info_t *info, void *to) {
    struct found *found = to;
    if (info->type != H5O_TYPE_DATASET) return 0;
    const hid_t set = H5Dopen2(in, name, H5P_DEFAULT), space = set < 0 ? -1 : H5Dget_space(set);
    if (space >= 0 && H5Sget_simple_extent_ndims(space) == 3) {
        if (found->n < 4) snprintf(found->name[found->n], sizeof found->name[0], "%s", name);
        found->n++;
    } else if (space >= 0 && !found->other[0]) {
        describe(found->other, sizeof found->other, name, space);
        found->others = H5Sget_simple_extent_ndims(space);
    }
    if (space >= 0) H5Sclose(space);
    if (set >= 0) H5Dclose(set);
    return 0;
}

static int visit(hid_t file, struct found *found) {
#if H5_VERSION_GE(1, 12, 0)
    return H5Ovisit(file, H5_INDEX_NAME, H5_ITER_INC, found_object, found, H5O_INFO_BASIC) < 0;
#else
    return H5Ovisit(file, H5_INDEX_NAME, H5_ITER_INC, found_object, found) < 0;
#endif
}

static hid_t open_set(struct image_source *s, hid_t file, const char *name) {
    struct found found = {0};
    if (!name || !name[0]) {
        if (visit(file, &found)) return image_source_refuse(s, "it cannot be searched for datasets"), -1;
        if (found.n == 0)
            return image_source_refuse(s, "it has no dataset of three dimensions%s%s%s", found.other[0] ? ", but " : "",
                                       found.other, found.others > 3 ? HOW : ""),
                   -1;
        if (found.n > 1)
            return image_source_refuse(s, "it has %d datasets of three dimensions (%s, %s%s): one must be named",
                                       found.n, found.name[0], found.name[1], found.n > 2 ? ", ..." : ""),
                   -1;
        name = found.name[0];
    }
    const hid_t set = H5Dopen2(file, name, H5P_DEFAULT);
    if (set < 0) image_source_refuse(s, "it has no dataset %.100s", name);
    return set;
}

static int find_size(struct image_source *s, const struct hdf5 *h) {
    hsize_t n[3];
    const int dims = H5Sget_simple_extent_ndims(h->space);
    if (dims != 3)
        return image_source_refuse(s, "its dataset has %d dimensions, and 3 are needed%s", dims, dims > 3 ? HOW : "");
    H5Sget_simple_extent_dims(h->space, n, NULL);
    for (int f = 0; f < 3; f++) {
        if (n[2 - f] > 1ULL << 62) return image_source_refuse(s, "its dataset is larger than a file can be");
        s->n[f] = (long)n[2 - f];
    }
    return 0;
}

/* Whether all bits of a number are within its bytes: HDF5 converts without looking. */
static int is_within(hid_t type) {
    const size_t bits = 8 * H5Tget_size(type), precision = H5Tget_precision(type);
    size_t sign, exponent, exponents, mantissa, mantissas;
    const int offset = H5Tget_offset(type);
    if (precision == 0 || offset < 0 || precision + (size_t)offset > bits) return 0;
    if (H5Tget_class(type) != H5T_FLOAT) return 1;
    return H5Tget_fields(type, &sign, &exponent, &exponents, &mantissa, &mantissas) >= 0 && sign < bits &&
           exponents <= bits && exponent <= bits - exponents && mantissas <= bits && mantissa <= bits - mantissas;
}

/* Truth values of h5py are an enumeration. */
static int find_type(struct image_source *s, const struct hdf5 *h) {
    static const enum files_image_type integers[9][2] = {[1] = {FILES_IMAGE_UINT8, FILES_IMAGE_INT8},
                                                         [2] = {FILES_IMAGE_UINT16, FILES_IMAGE_INT16},
                                                         [4] = {FILES_IMAGE_UINT32, FILES_IMAGE_INT32},
                                                         [8] = {FILES_IMAGE_UINT64, FILES_IMAGE_INT64}};
    hid_t type = H5Dget_type(h->set);
    if (H5Tget_class(type) == H5T_ENUM) {
        const hid_t base = H5Tget_super(type);
        H5Tclose(type);
        type = base;
    }
    const H5T_class_t class = H5Tget_class(type);
    const size_t bytes = H5Tget_size(type);
    if (class == H5T_INTEGER && bytes <= 8) s->type = integers[bytes][H5Tget_sign(type) == H5T_SGN_2];
    if (class == H5T_FLOAT)
        s->type = bytes == 4 ? FILES_IMAGE_FLOAT32 : bytes == 8 ? FILES_IMAGE_FLOAT64 : FILES_IMAGE_HEADER;
    const int within = is_within(type);
    H5Tclose(type);
    if (s->type != FILES_IMAGE_HEADER && !within)
        return image_source_refuse(s, "its dataset is damaged: its numbers have bits beyond their bytes");
    return s->type == FILES_IMAGE_HEADER &&
           image_source_refuse(s,
                               "its dataset holds no integers of 1, 2, 4 or 8 bytes and no floating point of 4 or 8");
}

static int check_filters(struct image_source *s, hid_t how) {
    for (int k = 0; k < H5Pget_nfilters(how); k++) {
        unsigned flags, config;
        size_t none = 0;
        char name[64] = "";
        const H5Z_filter_t filter = H5Pget_filter2(how, (unsigned)k, &flags, &none, NULL, sizeof name, name, &config);
        if (H5Zfilter_avail(filter) <= 0)
            return image_source_refuse(s, "its dataset is compressed by filter %d (%s), which HDF5 lacks here", filter,
                                       name);
    }
    return 0;
}

/* HDF5 copies as many bytes as a chunk should have, wherever fewer were decoded. So chunks that the dataset cannot have
 * are refused: those that are larger than it may become, too many of them, and, where nothing compresses them, too few
 * bytes. */
static int check_chunks(struct image_source *s, const struct hdf5 *h, hid_t how) {
    hsize_t chunk[3], n[3], most[3], chunks = 1, bytes = (hsize_t)image_number_bytes(s->type);
    if (H5Pget_layout(how) != H5D_CHUNKED) return 0;
    if (H5Pget_chunk(how, 3, chunk) != 3) return image_source_refuse(s, "its dataset has chunks of other dimensions");
    H5Sget_simple_extent_dims(h->space, n, most);
    for (int c = 0; c < 3; c++) {
        if (chunk[c] < 1 || (most[c] != H5S_UNLIMITED && chunk[c] > most[c]))
            return image_source_refuse(s,
                                       "its dataset is damaged: it has %llu voxels in a direction, and its chunks %llu",
                                       (unsigned long long)n[c], (unsigned long long)chunk[c]);
        chunks *= (n[c] + chunk[c] - 1) / chunk[c];
        bytes *= chunk[c];
    }
#if H5_VERSION_GE(1, 10, 5)
    hsize_t found = 0;
    if (H5Dget_num_chunks(h->set, h->space, &found) < 0 || found > chunks ||
        (H5Pget_nfilters(how) == 0 && H5Dget_storage_size(h->set) < found * bytes))
        return image_source_refuse(s, "its dataset is damaged: its chunks do not make it up");
#endif
    return 0;
}

/* A chunk is decoded as a whole: blocks are some of them. */
static void choose_block(struct image_source *s, hid_t how) {
    hsize_t chunk[3];
    image_source_block(s);
    if (H5Pget_layout(how) != H5D_CHUNKED || H5Pget_chunk(how, 3, chunk) != 3) return;
    long block = 1;
    for (int f = 0; f < 3; f++) {
        const long most = IMAGE_MAX / block, n = s->n[f];
        s->block[f] = chunk[2 - f] < (hsize_t)n ? (long)chunk[2 - f] : n;
        if (s->block[f] > most) s->block[f] = most;
        block *= s->block[f];
    }
    for (int f = 0; f < 3; f++) { /* small ones together */
        const long times = (1 << 18) / block, all = (s->n[f] + s->block[f] - 1) / s->block[f];
        if (times < 2) break;
        s->block[f] *= times < all ? times : all;
        block *= times < all ? times : all;
    }
}

/* Fiji's plug-in for HDF5 writes it, in the order of the dimensions. */
static void find_voxel(struct image_source *s, const struct hdf5 *h) {
    double um[3];
    if (H5Aexists(h->set, "element_size_um") <= 0) return;
    const hid_t a = H5Aopen(h->set, "element_size_um", H5P_DEFAULT), space = H5Aget_space(a);
    if (H5Sget_simple_extent_npoints(space) == 3 && H5Aread(a, H5T_NATIVE_DOUBLE, um) >= 0) {
        for (int f = 0; f < 3; f++) s->voxel[f] = um[2 - f] * 1e-6;
        s->unit = "m";
    }
    H5Sclose(space);
    H5Aclose(a);
}

static int read_box(struct image_source *s, const long low[3], const long high[3], double *value) {
    const struct hdf5 *h = s->file;
    hsize_t from[3], n[3];
    for (int f = 0; f < 3; f++) {
        from[2 - f] = (hsize_t)low[f];
        n[2 - f] = (hsize_t)(high[f] - low[f]);
    }
    const hid_t memory = H5Screate_simple(3, n, NULL);
    H5Sselect_hyperslab(h->space, H5S_SELECT_SET, from, NULL, n, NULL);
    const int fault = H5Dread(h->set, H5T_NATIVE_DOUBLE, memory, h->space, H5P_DEFAULT, value) < 0;
    H5Sclose(memory);
    return fault && image_source_refuse(s, "its dataset cannot be read: it is truncated or damaged");
}

static void close_file(struct image_source *s) {
    struct hdf5 *h = s->file;
    if (h->space >= 0) H5Sclose(h->space);
    if (h->set >= 0) H5Dclose(h->set);
    H5Fclose(h->file);
    free(h);
}

static hid_t open_file(struct image_source *s, const char *path) {
    long long bytes;
    const int fd = image_source_file(s, path, &bytes);
    if (fd < 0) return -1;
    const int fault = image_hdf5_check(s, fd, bytes);
    close(fd);
    if (fault) return -1;
    H5Eset_auto2(H5E_DEFAULT, NULL, NULL);
    if (H5Fis_hdf5(path) <= 0) return image_source_refuse(s, "it is not an HDF5 file"), -1;
    const hid_t file = h5_open_alone(path);
    if (file < 0) image_source_refuse(s, "it is truncated or damaged");
    return file;
}

int image_hdf5_open(struct image_source *s, const struct files_image_input *input) {
    long long bytes;
    const hid_t file = open_file(s, input->file);
    if (file < 0) return 1;
    struct hdf5 *h = image_source_new(1, sizeof *h);
    *h = (struct hdf5){.file = file, .set = -1, .space = -1};
    s->file = h;
    s->read = read_box;
    s->close = close_file;
    if ((h->set = open_set(s, file, input->dataset)) < 0) return 1;
    h->space = H5Dget_space(h->set);
    if (find_size(s, h) || find_type(s, h) || image_source_bytes(s, &bytes)) return 1;
    const hid_t how = H5Dget_create_plist(h->set);
    const int fault = check_filters(s, how) || check_chunks(s, h, how);
    if (!fault) choose_block(s, how);
    H5Pclose(how);
    find_voxel(s, h);
    return fault;
}
