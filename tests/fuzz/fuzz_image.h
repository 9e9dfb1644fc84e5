/* Common to the fuzz targets of images. */
#pragma once
#include "base/files/image.h"
#include "tests/fuzz/fuzz.h"

#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

/* A file in memory: one on a disk would take most of the time. */
static inline const char *fuzz_image_file(const void *data, size_t bytes) {
    static char path[64];
    static int fd = -1;
    if (fd < 0) {
        fd = memfd_create("image", MFD_CLOEXEC);
        snprintf(path, sizeof path, "/proc/self/fd/%d", fd);
    }
    fuzz_expect(ftruncate(fd, 0) == 0 && pwrite(fd, data, bytes, 0) == (ssize_t)bytes, "no room for a file");
    return path;
}

/* Opens the bytes as a file of the format, and reads a box of it; either must be refused by a sentence or succeed. */
static inline void fuzz_image(enum files_image_format format, const uint8_t *data, size_t bytes) {
    static int value[24 * 24 * 24];
    static double real[24 * 24 * 24];
    char problem[800] = "";
    const char *path = fuzz_image_file(data, bytes);
    struct files_image *image = files_image_open(
        &(struct files_image_input){.file = path, .format = format, .axes = "yzx"}, problem, sizeof problem);
    fuzz_expect(image != NULL || strlen(problem) > strlen(path) + 2, "no sentence says why the image is refused");
    if (!image) return;
    long low[3], high[3];
    for (int c = 0; c < 3; c++) { /* the end of each axis, where a file that is cut off lacks something */
        high[c] = files_image_size(image)[c];
        low[c] = high[c] > 24 ? high[c] - 24 : 0;
        fuzz_expect(high[c] > 0, "an image without voxels is accepted");
        fuzz_expect(files_image_voxel(image)[c] >= 0, "a voxel that has no size");
    }
    problem[0] = '\0';
    if (files_image_read_real(image, low, high, real, problem, sizeof problem))
        fuzz_expect(problem[0] != '\0', "no sentence says why voxels cannot be read");
    else if (!files_image_read(image, low, high, value, problem, sizeof problem))
        for (long i = 0; i < (high[0] - low[0]) * (high[1] - low[1]) * (high[2] - low[2]); i++)
            fuzz_expect(real[i] == value[i], "a label that differs from the value it was read as");
    files_image_close(image);
}
