/* HDF5: contiguous, chunked and compressed datasets of every type; the one that is meant; refusals. */
#include "base/files/image/formats.h"
#include "tests/base/files/image.h"

#include <fcntl.h>
#include <hdf5.h>
#include <unistd.h>

static const char *folder;

struct how {
    const char *name; /* NULL: image */
    hid_t type;
    int dims, deflate;
    hsize_t chunk[3]; /* 0: contiguous */
};

static hid_t begun(const char *path) {
    const hid_t file = H5Fcreate(path, H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
    assert_true(file >= 0);
    return file;
}

/* [z][y][x] */
static hid_t put(hid_t file, struct how how) {
    const hsize_t n[4] = {NZ, NY, NX, 1};
    int value[VOXELS];
    for (long i = 0; i < VOXELS; i++) value[i] = sample(i % NX, i / NX % NY, i / NX / NY);
    const hid_t space = H5Screate_simple(how.dims ? how.dims : 3, n, NULL), list = H5Pcreate(H5P_DATASET_CREATE);
    if (how.chunk[0]) H5Pset_chunk(list, 3, how.chunk);
    if (how.deflate) H5Pset_deflate(list, 5);
    const hid_t set = H5Dcreate2(file, how.name ? how.name : "image", how.type, space, H5P_DEFAULT, list, H5P_DEFAULT);
    assert_true(set >= 0);
    if (!how.dims) assert_true(H5Dwrite(set, H5T_NATIVE_INT, H5S_ALL, H5S_ALL, H5P_DEFAULT, value) >= 0);
    H5Pclose(list);
    H5Sclose(space);
    return set;
}

static const char *written(const char *name, struct how how) {
    const char *path = image_path(folder, name);
    const hid_t file = begun(path);
    H5Dclose(put(file, how));
    H5Fclose(file);
    return path;
}

static void types_chunks_and_compression(void **state) {
    (void)state;
    const struct {
        hid_t type;
        enum files_image_type is;
    } kind[] = {{H5T_STD_U8LE, FILES_IMAGE_UINT8},     {H5T_STD_U8BE, FILES_IMAGE_UINT8},
                {H5T_STD_I16LE, FILES_IMAGE_INT16},    {H5T_STD_U16BE, FILES_IMAGE_UINT16},
                {H5T_STD_I32BE, FILES_IMAGE_INT32},    {H5T_STD_U32LE, FILES_IMAGE_UINT32},
                {H5T_STD_I64LE, FILES_IMAGE_INT64},    {H5T_STD_U64BE, FILES_IMAGE_UINT64},
                {H5T_IEEE_F32BE, FILES_IMAGE_FLOAT32}, {H5T_IEEE_F64LE, FILES_IMAGE_FLOAT64}};
    for (size_t k = 0; k < sizeof kind / sizeof *kind; k++)
        for (int how = 0; how < 4; how++) {
            const char *path = written(
                "t.h5",
                (struct how){.type = kind[k].type, .deflate = how == 3, .chunk = {how ? (hsize_t)how : 0, 3, 2}});
            struct files_image *image = image_opened(&(struct files_image_input){.file = path});
            check_equal(files_image_format_of(image), FILES_IMAGE_HDF5);
            check_equal(files_image_type_of(image), kind[k].is);
            check_sample(image, 0);
            files_image_close(image);
        }
}

/* Chunks that fill no block and that are cut by the image's end; one that is larger than a block. */
static void large_datasets(void **state) {
    (void)state;
    enum { X = 300, Y = 200, Z = 90 };
    static unsigned char data[X * Y * Z];
    static int value[X * Y * Z];
    static const hsize_t chunk[][3] = {{7, 33, 64}, {90, 200, 300}, {1, 1, 300}};
    for (long i = 0; i < X * Y * Z; i++) data[i] = (unsigned char)(i % 251);
    for (int k = 0; k < 3; k++) {
        char problem[800] = "";
        const char *path = image_path(folder, "large.h5");
        const hsize_t n[3] = {Z, Y, X};
        const hid_t file = begun(path), space = H5Screate_simple(3, n, NULL), list = H5Pcreate(H5P_DATASET_CREATE);
        H5Pset_chunk(list, 3, chunk[k]);
        H5Pset_deflate(list, 1);
        const hid_t set = H5Dcreate2(file, "d", H5T_STD_U8LE, space, H5P_DEFAULT, list, H5P_DEFAULT);
        assert_true(H5Dwrite(set, H5T_NATIVE_UCHAR, H5S_ALL, H5S_ALL, H5P_DEFAULT, data) >= 0);
        H5Dclose(set);
        H5Pclose(list);
        H5Sclose(space);
        H5Fclose(file);
        struct files_image *image = image_opened(&(struct files_image_input){.file = path});
        if (files_image_read(image, (long[3]){0}, (long[]){X, Y, Z}, value, problem, sizeof problem))
            fail_msg("%s", problem);
        for (long i = 0; i < X * Y * Z; i++)
            if (value[i] != data[i]) fail_msg("voxel %ld is %d, not %d", i, value[i], data[i]);
        files_image_close(image);
    }
}

/* Numpy's [x][y][z] */
static void axes_in_c_order(void **state) {
    (void)state;
    unsigned char data[VOXELS];
    const hsize_t n[3] = {NX, NY, NZ};
    const char *path = image_path(folder, "c.h5");
    sample_bytes("zyx", 1, 0, data);
    const hid_t file = begun(path), space = H5Screate_simple(3, n, NULL);
    const hid_t set = H5Dcreate2(file, "d", H5T_STD_U8LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    assert_true(H5Dwrite(set, H5T_NATIVE_UCHAR, H5S_ALL, H5S_ALL, H5P_DEFAULT, data) >= 0);
    H5Dclose(set);
    H5Sclose(space);
    H5Fclose(file);
    check_file(&(struct files_image_input){.file = path, .axes = "zyx"});
}

/* A truth value of h5py: an enumeration of int8. */
static void truth_values(void **state) {
    (void)state;
    const signed char no = 0, yes = 1;
    signed char data[VOXELS];
    int value[VOXELS];
    char problem[800] = "";
    const hsize_t n[3] = {NZ, NY, NX};
    const char *path = image_path(folder, "bool.h5");
    const hid_t type = H5Tenum_create(H5T_STD_I8LE), file = begun(path), space = H5Screate_simple(3, n, NULL);
    H5Tenum_insert(type, "FALSE", &no);
    H5Tenum_insert(type, "TRUE", &yes);
    for (int i = 0; i < VOXELS; i++) data[i] = i % 3 == 0;
    const hid_t set = H5Dcreate2(file, "mask", type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    assert_true(H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data) >= 0);
    H5Dclose(set);
    H5Sclose(space);
    H5Tclose(type);
    H5Fclose(file);
    struct files_image *image = image_opened(&(struct files_image_input){.file = path});
    check_equal(files_image_type_of(image), FILES_IMAGE_INT8);
    if (files_image_read(image, (long[3]){0}, sample_size, value, problem, sizeof problem)) fail_msg("%s", problem);
    for (int i = 0; i < VOXELS; i++) check_equal(value[i], data[i]);
    files_image_close(image);
}

static void the_dataset_that_is_meant(void **state) {
    (void)state;
    const char *path = image_path(folder, "several.h5");
    hid_t file = begun(path);
    H5Dclose(put(file, (struct how){.name = "flat", .type = H5T_STD_U8LE, .dims = 2}));
    struct files_image_input input = {.file = path};
    H5Fclose(file);
    check_refused(&input, "it has no dataset of three dimensions, but flat of 4 x 5");
    file = begun(path);
    H5Gclose(H5Gcreate2(file, "a", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
    const hid_t set = put(file, (struct how){.name = "a/rock", .type = H5T_STD_U8LE});
    const float um[3] = {3, 2, 1.5F}; /* z, y, x */
    const hid_t space = H5Screate_simple(1, (hsize_t[]){3}, NULL);
    const hid_t a = H5Acreate2(set, "element_size_um", H5T_IEEE_F32LE, space, H5P_DEFAULT, H5P_DEFAULT);
    H5Awrite(a, H5T_NATIVE_FLOAT, um);
    H5Aclose(a);
    H5Sclose(space);
    H5Dclose(set);
    H5Dclose(put(file, (struct how){.name = "flat", .type = H5T_STD_U8LE, .dims = 2}));
    H5Fclose(file);
    check_file(&input);
    struct files_image *image = image_opened(&input);
    for (int c = 0; c < 3; c++) check_close(files_image_voxel(image)[c], ((double[]){1.5e-6, 2e-6, 3e-6})[c], 1e-20);
    assert_string_equal(files_image_unit(image), "m");
    files_image_close(image);
    file = H5Fopen(path, H5F_ACC_RDWR, H5P_DEFAULT);
    H5Dclose(put(file, (struct how){.name = "twin", .type = H5T_STD_U8LE}));
    H5Fclose(file);
    check_refused(&input, "it has 2 datasets of three dimensions (a/rock, twin): one must be named");
    input.dataset = "twin";
    check_file(&input);
    input.dataset = "flat";
    check_refused(&input, "its dataset has 2 dimensions, and 3 are needed");
    input.dataset = "a";
    check_refused(&input, "it has no dataset a");
    input.dataset = "none";
    check_refused(&input, "it has no dataset none");
}

static void odd_files_are_refused(void **state) {
    (void)state;
    struct files_image_input input = {.file = image_path(folder, "odd.h5")};
    const hid_t file = begun(input.file), type = H5Tcreate(H5T_COMPOUND, 4);
    H5Tinsert(type, "r", 0, H5T_STD_U32LE);
    H5Dclose(put(file, (struct how){.type = type, .dims = 3}));
    H5Tclose(type);
    H5Fclose(file);
    check_refused(&input, "its dataset holds no integers of 1, 2, 4 or 8 bytes and no floating point of 4 or 8");
    const hid_t four = begun(input.file);
    const hsize_t n[4] = {4, 5, 7, 1};
    const hid_t space = H5Screate_simple(4, n, NULL),
                set = H5Dcreate2(four, "rock", H5T_STD_U8LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    H5Dclose(set);
    H5Sclose(space);
    H5Fclose(four);
    check_refused(&input, "it has no dataset of three dimensions, but rock of 4 x 5 x 7 x 1; in Python, with h5py: "
                          "f['image'] = f[NAME][..., 0] adds the first of several channels, or the only one");
    input.dataset = "rock";
    check_refused(&input, "its dataset has 4 dimensions, and 3 are needed; in Python, with h5py: f['image'] = "
                          "f[NAME][..., 0] adds the first of several channels, or the only one");
    input.dataset = NULL;
    image_write(input.file, "no image", 8, "", 0);
    check_refused(&input, "it is not an HDF5 file");
    const char *path = written("odd.h5", (struct how){.type = H5T_STD_I32LE});
    static char data[1 << 16];
    FILE *in = fopen(path, "rb");
    const size_t bytes = fread(data, 1, sizeof data, in);
    fclose(in);
    image_write(path, data, bytes - 200, "", 0);
    char why[128];
    snprintf(why, sizeof why, "it is truncated or damaged: its superblock says %zu bytes, and it has %zu", bytes,
             bytes - 200);
    check_refused(&input, why);
}

/* A small file with others' bytes before it; returns its length. */
static size_t small(const char *path, int latest, hsize_t before, unsigned char *data, size_t capacity) {
    const hid_t access = H5Pcreate(H5P_FILE_ACCESS), create = H5Pcreate(H5P_FILE_CREATE);
    if (latest) H5Pset_libver_bounds(access, H5F_LIBVER_LATEST, H5F_LIBVER_LATEST);
    H5Pset_userblock(create, before);
    const hid_t file = H5Fcreate(path, H5F_ACC_TRUNC, create, access);
    H5Dclose(put(file, (struct how){.type = H5T_STD_U8LE}));
    H5Fclose(file);
    H5Pclose(access);
    H5Pclose(create);
    FILE *in = fopen(path, "rb");
    const size_t bytes = fread(data, 1, capacity, in);
    fclose(in);
    return bytes;
}

/* What the check says of the first bytes of the data. */
static int check_of(const char *path, const unsigned char *data, size_t bytes, struct image_source *s) {
    image_write(path, data, bytes, "", 0);
    const int fd = open(path, O_RDONLY), fault = image_hdf5_check(s, fd, (long long)bytes);
    close(fd);
    return fault;
}

/* All kinds of superblocks are read; cut off anywhere, none is; nor with impossible numbers. */
static void superblocks(void **state) {
    (void)state;
    static unsigned char data[1 << 16], more[1 << 16];
    const char *path = image_path(folder, "small.h5"), *other = image_path(folder, "damaged.h5");
    for (int latest = 0; latest < 2; latest++)
        for (hsize_t before = 0; before <= 2048; before = before ? 4 * before : 512) {
            struct image_source s = {.subject = "it"};
            const size_t bytes = small(path, latest, before, data, sizeof data), from = (size_t)before;
            check_file(&(struct files_image_input){.file = path});
            check_equal(data[from + 8], latest ? 3 : 0);
            check_equal(check_of(other, data, bytes, &s), 0);
            for (size_t n = 0; n < bytes; n += n + 97 <= from || n >= from + 200 ? 97 : 1)
                if (!check_of(other, data, n, &s)) fail_msg("%zu of %zu bytes are taken", n, bytes);
            /* with bytes put before it, as HDF5 takes it */
            memset(more, 0, 1024);
            memcpy(more + 1024, data, bytes);
            if (before == 0) {
                check_equal(check_of(other, more, bytes + 1024, &s), 0);
                check_file(&(struct files_image_input){.file = other, .format = FILES_IMAGE_HDF5});
            }
            const struct {
                size_t at;
                unsigned char value;
                const char *sentence;
            } wrong[] = {
                {8, 4, "its superblock has version 4, and 0 to 3 are known"},
                {latest ? 9 : 13, 7, "its superblock is damaged: it has addresses of 7 and lengths of 8 bytes"},
                {latest ? 10 : 14, 0, "its superblock is damaged: it has addresses of 8 and lengths of 0 bytes"},
                {latest ? 28 + 7 : 40 + 7, 1, "it is truncated or damaged: its superblock says 72057594037"},
                {latest ? 36 + 6 : 64 + 6, 9, "its superblock is damaged: its root group is beyond its end"},
                {latest ? 48 : 96, 7, "its root group is damaged"},
                {0, 'x', "it is not an HDF5 file"}};
            for (size_t k = 0; k < sizeof wrong / sizeof *wrong; k++) {
                memcpy(more, data, bytes);
                more[from + wrong[k].at] = wrong[k].value;
                check_equal(check_of(other, more, bytes, &s), 1);
                if (!strstr(s.why, wrong[k].sentence)) fail_msg("says \"%s\", not \"%s\"", s.why, wrong[k].sentence);
            }
            /* any byte of the superblock: taken or refused in a sentence */
            for (size_t at = from; at < from + 96; at++)
                for (int value = 0; value < 256; value += 17) {
                    if (check_skips((int)(at - from) + value / 17, 3)) continue;
                    memcpy(more, data, bytes);
                    more[at] = (unsigned char)value;
                    s.why[0] = '\0';
                    const int fault = check_of(other, more, bytes, &s);
                    check_equal(fault, s.why[0] != '\0');
                }
        }
}

/* Numbers that HDF5 takes as they are, and then reads beyond its memory. */
static void damaged_datasets(void **state) {
    (void)state;
    static const unsigned char chunk[16] = {3, 0, 0, 0, 3, 0, 0, 0, 2, 0, 0, 0, 1, 0, 0, 0}, /* z, y, x, bytes */
        type[12] = {0x10, 0, 0, 0, 1, 0, 0, 0, 0, 0, 8, 0}; /* unsigned, one byte, from bit 0, 8 bits */
    static const struct {
        const unsigned char *in;
        size_t bytes, at;
        unsigned char value;
        int deflate;
        const char *why;
    } table[] = {
        {chunk, sizeof chunk, 5, 9, 1, "its dataset is damaged: it has 5 voxels in a direction, and its chunks 2307"},
        {chunk, sizeof chunk, 5, 9, 0, "its dataset is damaged: it has 5 voxels in a direction, and its chunks 2307"},
        {chunk, sizeof chunk, 0, 4, 1, "its dataset is damaged: its chunks do not make it up"},
        {chunk, sizeof chunk, 4, 4, 0, "its dataset is damaged: its chunks do not make it up"},
        {type, sizeof type, 10, 16, 0, "its dataset is damaged: its numbers have bits beyond their bytes"},
        {type, sizeof type, 8, 1, 0, "its dataset is damaged: its numbers have bits beyond their bytes"}};
    static unsigned char data[1 << 16];
    for (size_t k = 0; k < sizeof table / sizeof *table; k++) {
        const char *path =
            written("damaged.h5", (struct how){.type = H5T_STD_U8LE, .chunk = {3, 3, 2}, .deflate = table[k].deflate});
        struct files_image_input input = {.file = path};
        check_file(&input);
        FILE *in = fopen(path, "rb");
        const size_t bytes = fread(data, 1, sizeof data, in);
        fclose(in);
        unsigned char *found = memmem(data, bytes, table[k].in, table[k].bytes);
        assert_non_null(found);
        found[table[k].at] = table[k].value;
        image_write(path, data, bytes, "", 0);
        check_refused(&input, table[k].why);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    folder = files_folder("image_hdf5");
    const struct CMUnitTest tests[] = {cmocka_unit_test(types_chunks_and_compression),
                                       cmocka_unit_test(large_datasets),
                                       cmocka_unit_test(axes_in_c_order),
                                       cmocka_unit_test(truth_values),
                                       cmocka_unit_test(the_dataset_that_is_meant),
                                       cmocka_unit_test(odd_files_are_refused),
                                       cmocka_unit_test(superblocks),
                                       cmocka_unit_test(damaged_datasets)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
