/* Arrays of numpy: types, orders of bytes and of memory, versions; refusals. */
#include "tests/base/files/image.h"

static const char *folder;

/* The header as numpy writes it: padded to a multiple of 64 bytes, a new line at its end. Returns its bytes. */
static size_t header(unsigned char *to, int version, const char *descr, const char *fortran, const char *shape) {
    char text[256];
    const size_t start = version > 1 ? 12 : 10;
    int n = snprintf(text, sizeof text, "{'descr': %s, 'fortran_order': %s, 'shape': %s, }", descr, fortran, shape);
    while ((start + (size_t)n + 1) % 64) text[n++] = ' ';
    text[n++] = '\n';
    memcpy(to, "\223NUMPY\0\0\0\0\0\0", 12);
    to[6] = (unsigned char)version;
    to[8] = (unsigned char)(n & 255);
    to[9] = (unsigned char)(n >> 8);
    memcpy(to + start, text, (size_t)n);
    return start + (size_t)n;
}

static const char *written(int version, const char *descr, const char *fortran, const char *shape, const char *axes,
                           int bytes, int big) {
    unsigned char head[512], data[VOXELS * 8];
    const char *path = image_path(folder, "a.npy");
    const size_t n = header(head, version, descr, fortran, shape);
    image_write(path, head, n, data, sample_bytes(axes, bytes, big, data));
    return path;
}

static void types_and_orders(void **state) {
    (void)state;
    static const struct {
        const char *descr;
        int bytes, big;
        enum files_image_type type;
    } is[] = {
        {"'|u1'", 1, 0, FILES_IMAGE_UINT8},  {"'|b1'", 1, 0, FILES_IMAGE_UINT8}, {"'|i1'", 1, 0, FILES_IMAGE_INT8},
        {"'<u2'", 2, 0, FILES_IMAGE_UINT16}, {"'>i2'", 2, 1, FILES_IMAGE_INT16}, {"'<i4'", 4, 0, FILES_IMAGE_INT32},
        {"'>u4'", 4, 1, FILES_IMAGE_UINT32}, {"'<i8'", 8, 0, FILES_IMAGE_INT64}, {"'>u8'", 8, 1, FILES_IMAGE_UINT64}};
    for (size_t k = 0; k < sizeof is / sizeof *is; k++)
        for (int version = 1; version < 4; version++) {
            if (is[k].type == FILES_IMAGE_INT8) continue; /* 140 does not fit */
            struct files_image *image = image_opened(&(struct files_image_input){
                .file = written(version, is[k].descr, "False", "(4, 5, 7)", "xyz", is[k].bytes, is[k].big)});
            assert_int_equal(files_image_format_of(image), FILES_IMAGE_NPY);
            assert_int_equal(files_image_type_of(image), is[k].type);
            check_sample(image, 0);
            files_image_close(image);
        }
    /* a[x, y, z], in the order of C and in that of Fortran */
    check_file(
        &(struct files_image_input){.file = written(1, "'|u1'", "False", "(7, 5, 4)", "zyx", 1, 0), .axes = "zyx"});
    check_file(&(struct files_image_input){.file = written(1, "'|u1'", "True", "(7, 5, 4)", "xyz", 1, 0)});
}

static void floating_point(void **state) {
    (void)state;
    unsigned char head[512];
    float data[VOXELS];
    for (long k = 0; k < VOXELS; k++) data[k] = (float)sample(k % NX, k / NX % NY, k / NX / NY);
    const char *path = image_path(folder, "f.npy");
    image_write(path, head, header(head, 1, "'<f4'", "False", "(4, 5, 7)"), data, sizeof data);
    check_file(&(struct files_image_input){.file = path});
}

static void odd_arrays_are_refused(void **state) {
    (void)state;
    static const struct {
        const char *descr, *fortran, *shape, *why;
    } odd[] = {
        {"'|u1'", "False", "(4, 5, 7, 1)",
         "its array has 4 dimensions, its shape is (4, 5, 7, 1), and 3 are needed; numpy.squeeze takes out those of "
         "length 1, and a[..., 0] is the first of several channels"},
        {"'|u1'", "False", "(140,)",
         "its array has 1 dimensions, its shape is (140,), and 3 are needed; numpy.squeeze takes out those of length "
         "1, "
         "and a[..., 0] is the first of several channels"},
        {"'<f2'", "False", "(4, 5, 7)",
         "its numbers are of numpy's type '<f2': bool, integers and floating point of 4 or 8 bytes are read"},
        {"[('r', '|u1')]", "False", "(4, 5, 7)",
         "its numbers are of numpy's type [('r': bool, integers and floating point of 4 or 8 bytes are read"},
        {"'|u1'", "False", "4", "its header of numpy is damaged"},
        {"'|u1'", "False", "(4, 5, 8)",
         "it has 268 bytes, but 8 x 5 x 4 voxels of uint8 take 160 after 128 of a header"},
        {"'|u1'", "False", "(4, -5, 7)", "it has 7 x -5 x 4 voxels: at least 1 is needed along each axis"}};
    for (size_t k = 0; k < sizeof odd / sizeof *odd; k++) {
        const struct files_image_input input = {
            .file = written(1, odd[k].descr, odd[k].fortran, odd[k].shape, "xyz", 1, 0)};
        check_refused(&input, odd[k].why);
    }
    unsigned char head[512], data[VOXELS];
    const size_t n = header(head, 1, "'|u1'", "False", "(4, 5, 7)");
    sample_bytes("xyz", 1, 0, data);
    const struct files_image_input input = {.file = image_path(folder, "cut.npy"), .format = FILES_IMAGE_NPY};
    char problem[800] = "";
    for (size_t k = 0; k < n; k++) { /* cut off anywhere in the header */
        image_write(input.file, head, k, "", 0);
        assert_null(files_image_open(&input, problem, sizeof problem));
    }
    head[8] = head[9] = 255; /* a length beyond the file */
    image_write(input.file, head, n, data, sizeof data);
    check_refused(&input, "its header of numpy is damaged");
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    folder = files_folder("image_npy");
    const struct CMUnitTest tests[] = {cmocka_unit_test(types_and_orders), cmocka_unit_test(floating_point),
                                       cmocka_unit_test(odd_arrays_are_refused)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
