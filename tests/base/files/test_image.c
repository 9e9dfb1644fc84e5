/* Raw images: every order of axes, type and byte order; boxes; refusals. */
#include "tests/base/files/image.h"

#include <math.h>

static const char *folder;

static const struct files_image_input raw = {
    .format = FILES_IMAGE_RAW, .size = {NX, NY, NZ}, .type = FILES_IMAGE_UINT8};

static void every_order_of_axes_gives_the_same(void **state) {
    (void)state;
    static const char *const axes[] = {"xyz", "xzy", "yxz", "yzx", "zxy", "zyx"};
    for (int k = 0; k < 6; k++) {
        unsigned char data[VOXELS];
        struct files_image_input input = raw;
        input.file = image_path(folder, axes[k]);
        memcpy(input.axes, axes[k], 4);
        image_write(input.file, "head", 4, data, sample_bytes(axes[k], 1, 0, data));
        input.header_bytes = 4;
        check_file(&input);
    }
}

static void every_type_and_byte_order(void **state) {
    (void)state;
    static const int bytes[FILES_IMAGE_TYPES] = {0, 1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
    for (int type = FILES_IMAGE_INT16; type <= FILES_IMAGE_UINT64; type++)
        for (int big = 0; big < 2; big++) {
            unsigned char data[VOXELS * 8];
            struct files_image_input input = raw;
            input.file = image_path(folder, files_image_type_word((enum files_image_type)type));
            input.type = (enum files_image_type)type;
            input.byte_order = big ? FILES_IMAGE_BIG : FILES_IMAGE_LITTLE;
            image_write(input.file, "", 0, data, sample_bytes("xyz", bytes[type], big, data));
            check_file(&input);
            if (!big) input.byte_order = FILES_IMAGE_ORDER_AUTO;
            if (!big) check_file(&input);
        }
}

/* Three voxels of a type, in the machine's order, little. */
static void check_three(enum files_image_type type, const void *data, size_t bytes, const double expected[3]) {
    char problem[400];
    double value[3];
    struct files_image_input input = {.file = image_path(folder, "three"), .size = {3, 1, 1}, .type = type};
    image_write(input.file, "", 0, data, bytes);
    struct files_image *image = image_opened(&input);
    check_equal(files_image_read_real(image, (long[3]){0}, (long[]){3, 1, 1}, value, problem, sizeof problem), 0);
    for (int k = 0; k < 3; k++) check_equal(value[k], expected[k]);
    files_image_close(image);
}

static void extreme_numbers(void **state) {
    (void)state;
    check_three(FILES_IMAGE_INT8, (int8_t[]){-128, -1, 127}, 3, (double[]){-128, -1, 127});
    check_three(FILES_IMAGE_UINT8, (uint8_t[]){0, 128, 255}, 3, (double[]){0, 128, 255});
    check_three(FILES_IMAGE_INT16, (int16_t[]){-32768, -1, 32767}, 6, (double[]){-32768, -1, 32767});
    check_three(FILES_IMAGE_UINT16, (uint16_t[]){0, 256, 65535}, 6, (double[]){0, 256, 65535});
    check_three(FILES_IMAGE_INT32, (int32_t[]){INT32_MIN, -1, INT32_MAX}, 12, (double[]){INT32_MIN, -1, INT32_MAX});
    check_three(FILES_IMAGE_UINT32, (uint32_t[]){0, 1, UINT32_MAX}, 12, (double[]){0, 1, UINT32_MAX});
    check_three(FILES_IMAGE_INT64, (int64_t[]){-1, 0, 1}, 24, (double[]){-1, 0, 1});
    check_three(FILES_IMAGE_FLOAT32, (float[]){-0.5F, 0, 1e30F}, 12, (double[]){-0.5, 0, 1e30F});
    check_three(FILES_IMAGE_FLOAT64, (double[]){-0.1, 0, 1e300}, 24, (double[]){-0.1, 0, 1e300});
}

/* A plane of the box is longer than a block, and so is the box. */
static void large_images_are_read_in_blocks(void **state) {
    (void)state;
    enum { X = 301, Y = 257, Z = 37 };
    static const char *const axes[] = {"xyz", "zyx", "yzx"};
    static const long n[3] = {X, Y, Z}, low[3] = {1, 2, 3}, high[3] = {X, Y - 1, Z - 1};
    static unsigned char data[X * Y * Z];
    static int value[X * Y * Z];
    char problem[400];
    for (int k = 0; k < 3; k++) {
        const int a[3] = {axes[k][0] - 'x', axes[k][1] - 'x', axes[k][2] - 'x'};
        long at[3], to = 0;
        for (at[a[2]] = 0; at[a[2]] < n[a[2]]; at[a[2]]++)
            for (at[a[1]] = 0; at[a[1]] < n[a[1]]; at[a[1]]++)
                for (at[a[0]] = 0; at[a[0]] < n[a[0]]; at[a[0]]++)
                    data[to++] = (unsigned char)(at[0] * 3 + at[1] * 5 + at[2] * 7);
        struct files_image_input input = {
            .file = image_path(folder, "large"), .size = {X, Y, Z}, .type = FILES_IMAGE_UINT8};
        memcpy(input.axes, axes[k], 4);
        image_write(input.file, "", 0, data, sizeof data);
        struct files_image *image = image_opened(&input);
        check_equal(files_image_read(image, low, high, value, problem, sizeof problem), 0);
        long i = 0;
        for (long z = low[2]; z < high[2]; z++)
            for (long y = low[1]; y < high[1]; y++)
                for (long x = low[0]; x < high[0]; x++) check_equal(value[i++], (unsigned char)(x * 3 + y * 5 + z * 7));
        files_image_close(image);
    }
}

/* Rows longer than those that are read with what is between their parts. */
static void long_rows_are_read_in_parts(void **state) {
    (void)state;
    enum { X = 70001, Y = 3, Z = 2 };
    static uint16_t data[X * Y * Z];
    static int value[X * Y * Z];
    static const long box[][2][3] = {
        {{0, 0, 0}, {X, Y, Z}}, {{65530, 1, 0}, {65540, 3, 2}}, {{5, 0, 1}, {70000, 2, 2}}};
    char problem[400];
    for (long i = 0; i < X * Y * Z; i++) data[i] = (uint16_t)(i * 7);
    const struct files_image_input input = {
        .file = image_path(folder, "long"), .size = {X, Y, Z}, .type = FILES_IMAGE_UINT16};
    image_write(input.file, "", 0, data, sizeof data);
    struct files_image *image = image_opened(&input);
    for (size_t k = 0; k < sizeof box / sizeof *box; k++) {
        long i = 0;
        check_equal(files_image_read(image, box[k][0], box[k][1], value, problem, sizeof problem), 0);
        for (long z = box[k][0][2]; z < box[k][1][2]; z++)
            for (long y = box[k][0][1]; y < box[k][1][1]; y++)
                for (long x = box[k][0][0]; x < box[k][1][0]; x++, i++)
                    if (value[i] != data[(z * Y + y) * X + x])
                        fail_msg("voxel [%ld, %ld, %ld] is %d", x, y, z, value[i]);
    }
    files_image_close(image);
}

static void what_is_wrong_is_refused(void **state) {
    (void)state;
    unsigned char data[VOXELS * 2] = {0};
    struct files_image_input input = raw;
    input.file = image_path(folder, "refused");
    image_write(input.file, "", 0, data, VOXELS);
#define REFUSED(member, given, why)                                                                                    \
    do {                                                                                                               \
        struct files_image_input odd = input;                                                                          \
        odd.member = given;                                                                                            \
        check_refused(&odd, why);                                                                                      \
    } while (0)
    REFUSED(size[0], NX + 1, "it has 140 bytes, but 8 x 5 x 4 voxels of uint8 take 160");
    REFUSED(size[0], NX - 1, "it has 140 bytes, but 6 x 5 x 4 voxels of uint8 take 120");
    REFUSED(type, FILES_IMAGE_UINT16,
            "it has 140 bytes, but 7 x 5 x 4 voxels of uint16 take 280; there is 1 byte a voxel");
    REFUSED(header_bytes, 10, "it has 140 bytes, but 7 x 5 x 4 voxels of uint8 take 140 after 10 of a header");
    REFUSED(header_bytes, -1, "a header has no negative number of bytes");
    REFUSED(size[1], 0, "it has 7 x 0 x 4 voxels: at least 1 is needed along each axis");
    REFUSED(size[1], -5, "it has 7 x -5 x 4 voxels: at least 1 is needed along each axis");
    REFUSED(size[2], 1L << 62, "it has 7 x 5 x 4611686018427387904 voxels: more than a file can hold");
    REFUSED(type, FILES_IMAGE_HEADER, "a raw file has no header: the type of its voxels is needed");
    REFUSED(axes[0], 'x', "axes = x: each of x, y and z is needed once, as in xyz or zyx");
    REFUSED(dataset, "rock", "a dataset is given, and it is not an HDF5 file (raw)");
    struct files_image_input odd = input;
    memset(odd.size, 0, sizeof odd.size);
    check_refused(&odd, "a raw file has no header: its size is needed");
    odd = input;
    memcpy(odd.axes, "xyx", 4);
    check_refused(&odd, "axes = xyx: each of x, y and z is needed once, as in xyz or zyx");
    odd = input;
    memcpy(odd.axes, "xyzx", 4);
    check_refused(&odd, "axes = xyzx: each of x, y and z is needed once, as in xyz or zyx");
    static const char text[] = "0\n1\n1\n0.5\n-1e3\n";
    odd = input;
    odd.file = image_path(folder, "text");
    image_write(odd.file, "", 0, text, sizeof text - 1);
    check_refused(&odd, "it holds numbers written as text: in Python numpy.loadtxt(FILE).astype('uint8')"
                        ".tofile('image.raw') makes a raw file");
    char digits[280]; /* as many bytes as 7 x 5 x 4 voxels of two bytes have */
    for (size_t k = 0; k < sizeof digits; k++)
        digits[k] = k % 2 ? (k % 14 == 13 ? '\n' : ' ') : (char)('0' + k / 2 % 2);
    odd.type = FILES_IMAGE_UINT16;
    image_write(odd.file, "", 0, digits, sizeof digits);
    check_refused(&odd, "it holds numbers written as text: in Python numpy.loadtxt(FILE).astype('uint16')"
                        ".tofile('image.raw') makes a raw file");
    odd = input;
    odd.file = folder;
    check_refused(&odd, "it is not a regular file");
    odd.file = "/nowhere/rock.raw";
    check_refused(&odd, "it cannot be read: No such file or directory");
}

static void a_box_outside_is_refused(void **state) {
    (void)state;
    unsigned char data[VOXELS];
    char problem[400];
    int value[1];
    struct files_image_input input = raw;
    input.file = image_path(folder, "box");
    image_write(input.file, "", 0, data, sample_bytes("xyz", 1, 0, data));
    struct files_image *image = image_opened(&input);
    assert_int_not_equal(files_image_read(image, (long[]){6, 0, 0}, (long[]){8, 1, 1}, value, problem, sizeof problem),
                         0);
    assert_non_null(strstr(problem, "box: voxels 6 to 8 along x are asked for, and it has 7"));
    assert_int_not_equal(files_image_read(image, (long[]){0, -1, 0}, (long[]){1, 1, 1}, value, problem, sizeof problem),
                         0);
    files_image_close(image);
}

static void what_is_no_label_is_refused(void **state) {
    (void)state;
    const float grey[3] = {1, 2, 2.5F}, none[3] = {1, NAN, 2};
    const uint32_t large[3] = {1, 2, 4000000000U};
    struct files_image_input input = {
        .file = image_path(folder, "grey"), .size = {3, 1, 1}, .type = FILES_IMAGE_FLOAT32};
#define WHY                                                                                                            \
    ", and a label is a whole number between -2147483648 and 2147483647: a threshold or a segmented image is needed"
    image_write(input.file, "", 0, grey, sizeof grey);
    check_refused(&input, "voxel [2, 0, 0] is 2.5" WHY);
    image_write(input.file, "", 0, none, sizeof none);
    check_refused(&input, "voxel [1, 0, 0] is nan" WHY);
    image_write(input.file, "", 0, large, sizeof large);
    input.type = FILES_IMAGE_UINT32;
    check_refused(&input, "voxel [2, 0, 0] is 4e+09" WHY);
}

/* The file became shorter after it was opened. */
static void a_file_cut_off_is_refused(void **state) {
    (void)state;
    unsigned char data[VOXELS];
    char problem[400];
    int value[VOXELS];
    struct files_image_input input = raw;
    input.file = image_path(folder, "cut");
    image_write(input.file, "", 0, data, sample_bytes("xyz", 1, 0, data));
    struct files_image *image = image_opened(&input);
    image_write(input.file, "", 0, data, 50);
    assert_int_not_equal(files_image_read(image, (long[3]){0}, sample_size, value, problem, sizeof problem), 0);
    assert_non_null(strstr(problem, "cut: it ends at byte 50, before its voxels do"));
    files_image_close(image);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    folder = files_folder("image");
    const struct CMUnitTest tests[] = {cmocka_unit_test(every_order_of_axes_gives_the_same),
                                       cmocka_unit_test(every_type_and_byte_order),
                                       cmocka_unit_test(extreme_numbers),
                                       cmocka_unit_test(large_images_are_read_in_blocks),
                                       cmocka_unit_test(long_rows_are_read_in_parts),
                                       cmocka_unit_test(what_is_wrong_is_refused),
                                       cmocka_unit_test(a_box_outside_is_refused),
                                       cmocka_unit_test(what_is_no_label_is_refused),
                                       cmocka_unit_test(a_file_cut_off_is_refused)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
