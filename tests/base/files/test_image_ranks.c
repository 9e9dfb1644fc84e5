/* Each rank reads its own part of one file, at its own time. */
#include "tests/base/files/image.h"

#include <hdf5.h>
#include <tiffio.h>

static const char *folder;

static void write_files(void) {
    unsigned char data[VOXELS];
    const hsize_t n[3] = {NZ, NY, NX};
    sample_bytes("xyz", 1, 0, data);
    image_write(image_path(folder, "r.raw"), "", 0, data, VOXELS);
    const hid_t file = H5Fcreate(image_path(folder, "r.h5"), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
    const hid_t space = H5Screate_simple(3, n, NULL);
    const hid_t set = H5Dcreate2(file, "d", H5T_STD_U8LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    assert_true(H5Dwrite(set, H5T_NATIVE_UCHAR, H5S_ALL, H5S_ALL, H5P_DEFAULT, data) >= 0);
    H5Dclose(set);
    H5Sclose(space);
    H5Fclose(file);
    TIFF *tiff = TIFFOpen(image_path(folder, "r.tif"), "w");
    for (int z = 0; z < NZ; z++) {
        TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, NX);
        TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, NY);
        TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 8);
        TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
        for (int y = 0; y < NY; y++) TIFFWriteScanline(tiff, data + (z * NY + y) * NX, (uint32_t)y, 0);
        assert_int_equal(TIFFWriteDirectory(tiff), 1);
    }
    TIFFClose(tiff);
}

static void parts(void **state) {
    (void)state;
    static const char *const name[] = {"r.raw", "r.h5", "r.tif"};
    if (par_rank() == 0) write_files();
    int written = 1;
    par_bcast(&written, sizeof written, 0);
    for (int k = 0; k < 3; k++) {
        struct files_image_input input = {.file = image_path(folder, name[(k + par_rank()) % 3])};
        const long first = NY * par_rank() / par_size(), end = NY * (par_rank() + 1) / par_size();
        if (strstr(input.file, ".raw")) {
            memcpy(input.size, sample_size, sizeof input.size);
            input.type = FILES_IMAGE_UINT8;
        }
        struct files_image *image = image_opened(&input);
        for (int again = 0; again <= par_rank(); again++) /* not as often on each rank */
            check_box_of(image, (long[]){0, first, 1}, (long[]){NX, end, NZ}, 0);
        files_image_close(image);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    folder = files_folder("image_ranks");
    const struct CMUnitTest tests[] = {cmocka_unit_test(parts)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
