/* A folder of slices is the image of its slices in the order of their numbers; what is not an image is refused. */
#include "tests/base/files/image.h"

#include <sys/stat.h>
#include <tiffio.h>

static const char *folder;

static void write_slice(const char *path, int width, int z) {
    TIFF *tiff = TIFFOpen(path, "w");
    unsigned char row[NX + 1] = {0};
    assert_non_null(tiff);
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, width);
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, NY);
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 8);
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
    for (int y = 0; y < NY; y++) {
        for (int x = 0; x < NX; x++) row[x] = (unsigned char)sample(x, y, z);
        TIFFWriteScanline(tiff, row, (uint32_t)y, 0);
    }
    TIFFClose(tiff);
}

/* The sample's slices as name_8.tif, _9, _10, _11: 10 comes after 9, as no list of names has it. */
static const char *slices_of(const char *name) {
    const char *path = image_path(folder, name);
    char file[FOLDER_PATH];
    mkdir(path, 0777);
    for (int z = 0; z < NZ; z++) {
        snprintf(file, sizeof file, "%.200s/s2_%d.tif", path, 8 + z);
        write_slice(file, NX, z);
    }
    snprintf(file, sizeof file, "%.200s/notes.txt", path);
    image_write(file, "x", 1, "y", 1);
    return path;
}

static void slices(void **state) {
    (void)state;
    const struct files_image_input input = {.file = slices_of("good")};
    struct files_image *image = image_opened(&input);
    const long *n = files_image_size(image);
    assert_true(n[0] == NX && n[1] == NY && n[2] == NZ);
    check_box_of(image, (long[]){0, 0, 0}, (long[]){NX, NY, NZ}, 0);
    check_box_of(image, (long[]){1, 2, 1}, (long[]){5, 4, 3}, 0);
    files_image_close(image);
}

static void refused(const char *path, enum files_image_format format, const char *why) {
    char problem[800] = "";
    const struct files_image_input input = {.file = path,
                                            .format = format,
                                            .size = {format == FILES_IMAGE_RAW},
                                            .type = format == FILES_IMAGE_RAW ? FILES_IMAGE_UINT8 : FILES_IMAGE_HEADER};
    struct files_image *image = files_image_open(&input, problem, sizeof problem);
    if (image) fail_msg("%s is read", path);
    if (!strstr(problem, why)) fail_msg("%s", problem);
}

static void no_images(void **state) {
    (void)state;
    char file[FOLDER_PATH];
    const char *path = image_path(folder, "empty");
    mkdir(path, 0777);
    refused(path, FILES_IMAGE_AUTO, "the folder has no TIFF");
    path = slices_of("raw");
    refused(path, FILES_IMAGE_RAW, "it is not a regular file");
    path = slices_of("gap");
    snprintf(file, sizeof file, "%.200s/s2_10.tif", path);
    remove(file);
    refused(path, FILES_IMAGE_AUTO, "s2_9.tif is followed by s2_11.tif");
    path = slices_of("twice");
    snprintf(file, sizeof file, "%.200s/s2_010.tif", path);
    write_slice(file, NX, 0);
    refused(path, FILES_IMAGE_AUTO, "numbers of slices must follow one another");
    path = slices_of("two");
    snprintf(file, sizeof file, "%.200s/s3_12.tif", path);
    write_slice(file, NX, 0);
    refused(path, FILES_IMAGE_AUTO, "differ by more than a number");
    path = slices_of("wide");
    snprintf(file, sizeof file, "%.200s/s2_12.tif", path);
    write_slice(file, NX + 1, 0);
    refused(path, FILES_IMAGE_AUTO, "s2_12.tif differs from s2_8.tif");
    path = slices_of("broken");
    snprintf(file, sizeof file, "%.200s/s2_12.tif", path);
    image_write(file, "II*", 3, "x", 1);
    refused(path, FILES_IMAGE_TIFF, "slice s2_12.tif");
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    folder = files_folder("image_slices");
    const struct CMUnitTest tests[] = {cmocka_unit_test(slices), cmocka_unit_test(no_images)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
