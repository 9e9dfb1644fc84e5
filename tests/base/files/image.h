/* A sample of voxels for the tests of images, and files written by the tests themselves. */
#pragma once
#include "base/files/image.h"
#include "tests/check.h"
#include "tests/base/files/files.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { NX = 7, NY = 5, NZ = 4, VOXELS = NX * NY * NZ };

static const long sample_size[3] = {NX, NY, NZ};

/* Different in every voxel, 1 to 140: fits any type. */
static inline int sample(long x, long y, long z) { return 1 + (int)((z * NY + y) * NX + x) * 37 % VOXELS; }

static inline const char *image_path(const char *folder, const char *name) {
    static char path[4][FOLDER_PATH];
    static int next;
    next = (next + 1) % 4;
    snprintf(path[next], sizeof path[next], "%s/%s", folder, name);
    return path[next];
}

static inline void image_write(const char *path, const void *head, size_t head_bytes, const void *data, size_t bytes) {
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(head, 1, head_bytes, file), head_bytes);
    assert_int_equal(fwrite(data, 1, bytes, file), bytes);
    assert_int_equal(fclose(file), 0);
}

/* The sample in the order of `axes`, each number of so many bytes. Returns the bytes written. */
static inline size_t sample_bytes(const char *axes, int bytes, int big, unsigned char *to) {
    const int a[3] = {axes[0] - 'x', axes[1] - 'x', axes[2] - 'x'};
    const unsigned char *const from = to;
    long at[3];
    for (at[a[2]] = 0; at[a[2]] < sample_size[a[2]]; at[a[2]]++)
        for (at[a[1]] = 0; at[a[1]] < sample_size[a[1]]; at[a[1]]++)
            for (at[a[0]] = 0; at[a[0]] < sample_size[a[0]]; at[a[0]]++, to += bytes) {
                memset(to, 0, (size_t)bytes);
                to[big ? bytes - 1 : 0] = (unsigned char)sample(at[0], at[1], at[2]);
            }
    return (size_t)(to - from);
}

static inline struct files_image *image_opened(const struct files_image_input *input) {
    char problem[800] = "";
    struct files_image *image = files_image_open(input, problem, sizeof problem);
    if (!image) fail_msg("%s", problem);
    return image;
}

static inline void check_box_of(struct files_image *image, const long low[3], const long high[3], int offset) {
    char problem[800] = "";
    int value[VOXELS + 1];
    double real[VOXELS + 1];
    long at = 0;
    memset(value, 0x7f, sizeof value);
    real[(high[0] - low[0]) * (high[1] - low[1]) * (high[2] - low[2])] = -9;
    if (files_image_read(image, low, high, value, problem, sizeof problem)) fail_msg("%s", problem);
    if (files_image_read_real(image, low, high, real, problem, sizeof problem)) fail_msg("%s", problem);
    for (long z = low[2]; z < high[2]; z++)
        for (long y = low[1]; y < high[1]; y++)
            for (long x = low[0]; x < high[0]; x++, at++) {
                if (value[at] != sample(x, y, z) + offset)
                    fail_msg("voxel [%ld, %ld, %ld] is %d, not %d", x, y, z, value[at], sample(x, y, z) + offset);
                check_equal(real[at], value[at]);
            }
    check_equal(value[at], 0x7f7f7f7f); /* nothing behind the box */
    check_equal(real[at], -9);
}

/* The whole, and boxes that begin and end anywhere, empty ones among them. */
static inline void check_sample(struct files_image *image, int offset) {
    static const long box[][2][3] = {{{0, 0, 0}, {NX, NY, NZ}}, {{2, 1, 1}, {5, 4, 3}}, {{6, 4, 3}, {7, 5, 4}},
                                     {{0, 2, 0}, {NX, 3, NZ}},  {{3, 0, 0}, {4, 5, 4}}, {{0, 0, 2}, {NX, NY, 3}},
                                     {{1, 1, 1}, {1, 4, 3}}};
    for (int c = 0; c < 3; c++) assert_int_equal(files_image_size(image)[c], sample_size[c]);
    for (size_t k = 0; k < sizeof box / sizeof *box; k++) check_box_of(image, box[k][0], box[k][1], offset);
}

static inline void check_file(const struct files_image_input *input) {
    struct files_image *image = image_opened(input);
    check_sample(image, 0);
    files_image_close(image);
}

/* That opening, or else reading, is refused with the sentence: the file's name, then `why`. */
static inline void check_refused(const struct files_image_input *input, const char *why) {
    char problem[800] = "", expected[1200];
    int value[VOXELS];
    struct files_image *image = files_image_open(input, problem, sizeof problem);
    if (image && !files_image_read(image, (long[]){0, 0, 0}, files_image_size(image), value, problem, sizeof problem))
        fail_msg("%s: accepted, but must be refused: %s", input->file, why);
    files_image_close(image);
    snprintf(expected, sizeof expected, "%s: %s", input->file, why);
    assert_string_equal(problem, expected);
}
