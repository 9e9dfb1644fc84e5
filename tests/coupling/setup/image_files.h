/* Images of all formats and the scenes of their bodies, for the tests. */
#pragma once
#include "base/par.h"
#include "tests/check.h"

#include <hdf5.h>
#include <stdio.h>
#include <sys/stat.h>
#include <tiffio.h>

/* mm a voxel; a domain with room around */
enum { NX = 13, NY = 9, NZ = 7, VOXELS = NX * NY * NZ };
/* FOLDER: of the test, which others must not write to */
#define SCENE FOLDER "/scene.yaml"

/* 0 in pores, 1 and 2 in two minerals. */
static inline int sample(int x, int y, int z) {
    const unsigned q = (unsigned)((z * NY + y) * NX + x) * 2654435761u >> 24;
    return q < 90 ? 0 : q < 180 ? 1 : 2;
}

static inline void write_file(const char *name, const void *head, size_t head_bytes, const void *data, size_t bytes) {
    char path[512];
    snprintf(path, sizeof path, FOLDER "/%s", name);
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(head, 1, head_bytes, file), head_bytes);
    assert_int_equal(fwrite(data, 1, bytes, file), bytes);
    assert_int_equal(fclose(file), 0);
}

static inline void write_text(const char *name, const char *text, const void *data, size_t bytes) {
    write_file(name, text, strlen(text), data, bytes);
}

static inline void write_tiff(const unsigned char *voxel) {
    TIFF *file = TIFFOpen(FOLDER "/sample.tif", "w");
    assert_non_null(file);
    for (int z = 0; z < NZ; z++) {
        TIFFSetField(file, TIFFTAG_IMAGEWIDTH, NX);
        TIFFSetField(file, TIFFTAG_IMAGELENGTH, NY);
        TIFFSetField(file, TIFFTAG_BITSPERSAMPLE, 8);
        TIFFSetField(file, TIFFTAG_SAMPLESPERPIXEL, 1);
        TIFFSetField(file, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
        TIFFSetField(file, TIFFTAG_ROWSPERSTRIP, NY);
        for (int y = 0; y < NY; y++)
            assert_int_equal(TIFFWriteScanline(file, (void *)(uintptr_t)(voxel + (z * NY + y) * NX), (uint32_t)y, 0),
                             1);
        assert_int_equal(TIFFWriteDirectory(file), 1);
    }
    TIFFClose(file);
}

static inline void write_hdf5(const unsigned char *voxel) {
    const hsize_t size[3] = {NZ, NY, NX};
    const hid_t file = H5Fcreate(FOLDER "/sample.h5", H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT),
                space = H5Screate_simple(3, size, NULL),
                set = H5Dcreate2(file, "labels", H5T_STD_U8LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    assert_true(H5Dwrite(set, H5T_NATIVE_UCHAR, H5S_ALL, H5S_ALL, H5P_DEFAULT, voxel) >= 0);
    H5Dclose(set);
    H5Sclose(space);
    H5Fclose(file);
}

/* A ball about the middle of 16 x 16 x 16 voxels, and two pieces apart from a block. */
static inline void write_others(void) {
    unsigned char ball[16 * 16 * 16], pieces[8 * 8 * 8] = {0};
    for (int q = 0; q < 4096; q++) {
        const double x = q % 16 - 7.5, y = q / 16 % 16 - 7.5, z = q / 256 - 7.5;
        ball[q] = x * x + y * y + z * z < 6.3 * 6.3;
    }
    write_file("ball.raw", "", 0, ball, sizeof ball);
    for (int q = 0; q < 512; q++) pieces[q] = q / 64 < 4; /* four layers */
    pieces[6 * 64 + 3 * 8 + 3] = 1;
    pieces[6 * 64 + 3 * 8 + 4] = 1;
    pieces[7 * 64 + 7 * 8 + 7] = 1;
    write_file("pieces.raw", "", 0, pieces, sizeof pieces);
    memset(pieces, 0, sizeof pieces);
    write_file("pore.raw", "", 0, pieces, sizeof pieces);
    write_file("short.raw", "", 0, pieces, 511);
}

static inline int write_all(void **state) {
    (void)state;
    if (par_rank() == 0) {
        unsigned char voxel[VOXELS], turned[VOXELS], *to = turned;
        for (int q = 0; q < VOXELS; q++) voxel[q] = (unsigned char)sample(q % NX, q / NX % NY, q / NX / NY);
        for (int x = 0; x < NX; x++)
            for (int y = 0; y < NY; y++)
                for (int z = 0; z < NZ; z++) *to++ = (unsigned char)sample(x, y, z);
        mkdir(FOLDER, 0777);
        write_file("sample.raw", "", 0, voxel, VOXELS);
        write_file("turned.raw", "", 0, turned, VOXELS);
        write_text(
            "sample.mha",
            "ObjectType = Image\nNDims = 3\nDimSize = 13 9 7\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n",
            voxel, VOXELS);
        write_text("sample.nrrd", "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 13 9 7\nencoding: raw\n\n", voxel,
                   VOXELS);
        write_tiff(voxel);
        write_hdf5(voxel);
        write_others();
    }
    par_barrier();
    return 0;
}

#define QUARTZ "{name: quartz, youngs_modulus: 7.0e+10, density: 2650}"
static const char *materials = QUARTZ, *more = ""; /* of the scenes to come */

/* The scene with the keys of its body; spacing in mm. */
static inline void write_scene(const char *keys, double spacing) {
    char text[2048];
    snprintf(text, sizeof text,
             "domain: {size: [0.04, 0.04, 0.04]}\n"
             "solid:\n"
             "  spacing: %g\n"
             "  materials: [%s]\n"
             "  bodies: [{%s}]\n"
             "%s"
             "stages: [{name: rest, steps: 1}]\n",
             spacing * 1e-3, materials, keys, more);
    if (par_rank() == 0) write_text("scene.yaml", text, "", 0);
    par_barrier();
}

#define RAW "shape: image, size: [13, 9, 7], type: uint8, voxel: 1.0e-3, low: [0.003, 0.002, 0.001], "

#define MINERALS                                                                                                       \
    QUARTZ ", {name: clay, youngs_modulus: 2.0e+10, density: 2500, fracture_energy: 3}, "                              \
           "{name: ore, youngs_modulus: 9.0e+10, density: 5000, micromodulus: conical}, "                              \
           "{name: wide, youngs_modulus: 9.0e+10, density: 5000, horizon_ratio: 4}, "                                  \
           "{name: paste, youngs_modulus: 2.0e+10, density: 2500, fracture_energy: 3, "                                \
           "breakage: {law: bilinear, tensile_strength: 1.0e6}}, "                                                     \
           "{name: grain, youngs_modulus: 2.0e+10, density: 2500, breakage: {law: brittle, s00: 1.0e-3, alpha: 0.2}}"
