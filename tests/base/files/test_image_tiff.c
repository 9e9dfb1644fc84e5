/* TIFF: strips and tiles, compressions, byte orders, types; refusals. */
#include "tests/base/files/image.h"

#include <tiffio.h>

static const char *folder;

struct how {
    const char *mode; /* wl, wb, w8: little, big, BigTIFF */
    uint16_t bits, number, scheme, samples, meaning;
    uint32_t rows, tile;     /* of a strip; side of a tile, 0: strips */
    const char *description; /* of ImageJ */
    int odd_page;            /* this page has another size */
    int pages;               /* 0: NZ */
    uint32_t depth;          /* slices of a page, 0: not said */
};

static void put_pixel(char *row, long i, int value, const struct how *how) {
    const float real = (float)value;
    const double wide = value;
    const int v = value;
    if (how->bits == 1)
        row[i / 8] = (char)(row[i / 8] | (value % 2) << (7 - i % 8));
    else if (how->number == SAMPLEFORMAT_IEEEFP)
        memcpy(row + i * how->bits / 8, how->bits == 32 ? (const void *)&real : &wide, how->bits / 8);
    else
        for (int k = 0; k < how->samples; k++) memcpy(row + (i * how->samples + k) * how->bits / 8, &v, how->bits / 8);
}

static void write_rows(TIFF *file, const struct how *how, long z) {
    char row[NX * 3 * 8];
    for (long y = 0; y < (how->odd_page && z == how->odd_page ? NY - 1 : NY); y++) {
        memset(row, 0, sizeof row);
        for (long x = 0; x < NX; x++) put_pixel(row, x, sample(x, y, z), how);
        assert_int_equal(TIFFWriteScanline(file, row, (uint32_t)y, 0), 1);
    }
}

static void write_tile(TIFF *file, const struct how *how, long z) {
    char tile[16 * 16 * 8] = {0};
    assert_int_equal(how->tile, 16); /* as small as they can be, with a margin */
    for (long y = 0; y < NY; y++)
        for (long x = 0; x < NX; x++) put_pixel(tile + y * TIFFTileRowSize(file), x, sample(x, y, z), how);
    assert_true(TIFFWriteTile(file, tile, 0, 0, 0, 0) > 0);
}

static const char *written(const char *name, struct how how) {
    const char *path = image_path(folder, name);
    if (!how.mode) how.mode = "wl";
    if (!how.bits) how.bits = 8;
    if (!how.number) how.number = SAMPLEFORMAT_UINT;
    if (!how.scheme) how.scheme = COMPRESSION_NONE;
    if (!how.samples) how.samples = 1;
    if (!how.meaning) how.meaning = PHOTOMETRIC_MINISBLACK;
    if (!how.rows) how.rows = NY;
    if (!how.pages) how.pages = NZ;
    TIFF *file = TIFFOpen(path, how.mode);
    assert_non_null(file);
    for (int z = 0; z < how.pages; z++) {
        TIFFSetField(file, TIFFTAG_IMAGEWIDTH, NX);
        TIFFSetField(file, TIFFTAG_IMAGELENGTH, how.odd_page && z == how.odd_page ? NY - 1 : NY);
        TIFFSetField(file, TIFFTAG_BITSPERSAMPLE, how.bits);
        TIFFSetField(file, TIFFTAG_SAMPLEFORMAT, how.number);
        TIFFSetField(file, TIFFTAG_SAMPLESPERPIXEL, how.samples);
        TIFFSetField(file, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
        TIFFSetField(file, TIFFTAG_PHOTOMETRIC, how.meaning);
        TIFFSetField(file, TIFFTAG_COMPRESSION, how.scheme);
        if (how.meaning == PHOTOMETRIC_PALETTE) {
            uint16_t colour[256] = {0};
            TIFFSetField(file, TIFFTAG_COLORMAP, colour, colour, colour);
        }
        if (how.depth) TIFFSetField(file, TIFFTAG_IMAGEDEPTH, how.depth);
        if (how.tile) {
            TIFFSetField(file, TIFFTAG_TILEWIDTH, how.tile);
            TIFFSetField(file, TIFFTAG_TILELENGTH, how.tile);
        } else {
            TIFFSetField(file, TIFFTAG_ROWSPERSTRIP, how.rows);
        }
        if (how.description) {
            TIFFSetField(file, TIFFTAG_IMAGEDESCRIPTION, how.description);
            TIFFSetField(file, TIFFTAG_XRESOLUTION, 0.5F);
            TIFFSetField(file, TIFFTAG_YRESOLUTION, 0.25F);
        }
        if (how.tile)
            write_tile(file, &how, z);
        else
            write_rows(file, &how, z);
        assert_int_equal(TIFFWriteDirectory(file), 1);
    }
    TIFFClose(file);
    return path;
}

static void check_at(const char *path, enum files_image_type type) {
    struct files_image *image = image_opened(&(struct files_image_input){.file = path});
    check_equal(files_image_format_of(image), FILES_IMAGE_TIFF);
    check_equal(files_image_type_of(image), type);
    check_sample(image, 0);
    files_image_close(image);
}

static void types_and_byte_orders(void **state) {
    (void)state;
    static const struct {
        uint16_t bits, number;
        enum files_image_type type;
    } kind[] = {{8, SAMPLEFORMAT_UINT, FILES_IMAGE_UINT8},     {16, SAMPLEFORMAT_UINT, FILES_IMAGE_UINT16},
                {16, SAMPLEFORMAT_INT, FILES_IMAGE_INT16},     {32, SAMPLEFORMAT_UINT, FILES_IMAGE_UINT32},
                {32, SAMPLEFORMAT_INT, FILES_IMAGE_INT32},     {32, SAMPLEFORMAT_IEEEFP, FILES_IMAGE_FLOAT32},
                {64, SAMPLEFORMAT_IEEEFP, FILES_IMAGE_FLOAT64}};
    static const char *const mode[] = {"wl", "wb", "wl8", "wb8"};
    for (size_t k = 0; k < sizeof kind / sizeof *kind; k++)
        for (int m = 0; m < 4; m++)
            check_at(written("t.tif", (struct how){.mode = mode[m], .bits = kind[k].bits, .number = kind[k].number}),
                     kind[k].type);
}

static void strips_tiles_and_compressions(void **state) {
    (void)state;
    static const uint16_t scheme[] = {COMPRESSION_NONE,    COMPRESSION_LZW,      COMPRESSION_ADOBE_DEFLATE,
                                      COMPRESSION_DEFLATE, COMPRESSION_PACKBITS, COMPRESSION_ZSTD,
                                      COMPRESSION_LZMA};
    for (size_t k = 0; k < sizeof scheme / sizeof *scheme; k++)
        for (uint16_t bits = 8; bits <= 16; bits = (uint16_t)(2 * bits)) {
            const enum files_image_type type = bits == 8 ? FILES_IMAGE_UINT8 : FILES_IMAGE_UINT16;
            for (uint32_t rows = 1; rows <= NY; rows += 2) {
                if (check_skips((int)k + 1, 1)) continue; /* in a debug build not LZMA, which clears 94 MB a page */
                check_at(written("s.tif", (struct how){.scheme = scheme[k], .bits = bits, .rows = rows}), type);
            }
            check_at(written("s.tif", (struct how){.mode = "wb", .scheme = scheme[k], .bits = bits, .tile = 16}), type);
        }
}

/* Rows out of order within a strip that holds several; tiles of which a box holds parts. */
static void large_pages(void **state) {
    (void)state;
    enum { X = 1500, Y = 1100, Z = 2 };
    static unsigned char row[X], tile[128 * 128];
    static int value[X * Y * Z];
    char problem[800] = "";
    for (int is_tiled = 0; is_tiled < 2; is_tiled++) {
        const char *path = image_path(folder, "large.tif");
        TIFF *file = TIFFOpen(path, "w");
        for (int z = 0; z < Z; z++) {
            TIFFSetField(file, TIFFTAG_IMAGEWIDTH, X);
            TIFFSetField(file, TIFFTAG_IMAGELENGTH, Y);
            TIFFSetField(file, TIFFTAG_BITSPERSAMPLE, 8);
            TIFFSetField(file, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
            TIFFSetField(file, TIFFTAG_COMPRESSION, COMPRESSION_LZW);
            TIFFSetField(file, is_tiled ? TIFFTAG_TILEWIDTH : TIFFTAG_ROWSPERSTRIP, is_tiled ? 128 : 100);
            if (is_tiled) TIFFSetField(file, TIFFTAG_TILELENGTH, 128);
            for (int y = 0; y < Y && !is_tiled; y++) {
                for (int x = 0; x < X; x++) row[x] = (unsigned char)(x + 3 * y + 7 * z);
                assert_int_equal(TIFFWriteScanline(file, row, (uint32_t)y, 0), 1);
            }
            for (int y = 0; y < Y && is_tiled; y += 128)
                for (int x = 0; x < X; x += 128) {
                    for (int k = 0; k < 128 * 128; k++)
                        tile[k] = (unsigned char)(x + k % 128 + 3 * (y + k / 128) + 7 * z);
                    assert_true(TIFFWriteTile(file, tile, (uint32_t)x, (uint32_t)y, 0, 0) > 0);
                }
            assert_int_equal(TIFFWriteDirectory(file), 1);
        }
        TIFFClose(file);
        struct files_image *image = image_opened(&(struct files_image_input){.file = path});
        static const long box[][2][3] = {{{0, 0, 0}, {X, Y, Z}},
                                         {{700, 950, 1}, {701, 1000, 2}},
                                         {{100, 40, 0}, {300, 1090, 2}},
                                         {{127, 127, 0}, {129, 129, 1}},
                                         {{0, 10, 1}, {X, 11, 2}}};
        for (size_t k = 0; k < sizeof box / sizeof *box; k++) {
            long i = 0;
            if (files_image_read(image, box[k][0], box[k][1], value, problem, sizeof problem)) fail_msg("%s", problem);
            for (long z = box[k][0][2]; z < box[k][1][2]; z++)
                for (long y = box[k][0][1]; y < box[k][1][1]; y++)
                    for (long x = box[k][0][0]; x < box[k][1][0]; x++, i++)
                        if (value[i] != (unsigned char)(x + 3 * y + 7 * z))
                            fail_msg("voxel [%ld, %ld, %ld] is %d", x, y, z, value[i]);
        }
        files_image_close(image);
    }
}

static void labels_of_a_palette_and_of_one_bit(void **state) {
    (void)state;
    check_at(written("palette.tif", (struct how){.meaning = PHOTOMETRIC_PALETTE}), FILES_IMAGE_UINT8);
    static const uint16_t scheme[] = {COMPRESSION_NONE, COMPRESSION_CCITTFAX4, COMPRESSION_LZW};
    for (int k = 0; k < 4; k++) {
        int value[VOXELS];
        char problem[800] = "";
        const struct how how = {.bits = 1, .scheme = scheme[k % 3], .tile = k == 3 ? 16 : 0};
        struct files_image *image = image_opened(&(struct files_image_input){.file = written("bit.tif", how)});
        if (files_image_read(image, (long[3]){0}, sample_size, value, problem, sizeof problem)) fail_msg("%s", problem);
        for (long i = 0; i < VOXELS; i++) check_equal(value[i], sample(i % NX, i / NX % NY, i / NX / NY) % 2);
        files_image_close(image);
    }
}

static void imagej_says_its_voxel(void **state) {
    (void)state;
    static const struct {
        const char *text;
        double voxel[3];
        const char *unit;
    } kind[] = {{"ImageJ=1.53t\nimages=4\nslices=4\nunit=micron\nspacing=3.5\nloop=false\n", {2e-6, 4e-6, 3.5e-6}, "m"},
                {"ImageJ=1.53t\nimages=4\nunit=\\u00B5m\nspacing=3.5\n", {2e-6, 4e-6, 3.5e-6}, "m"},
                {"ImageJ=1.53t\nimages=4\nunit=mm\n", {2e-3, 4e-3, 0}, "m"},
                {"ImageJ=1.53t\nimages=4\nunit=pixel\n", {0, 0, 0}, ""},
                {"another program\nunit=micron\n", {0, 0, 0}, ""}};
    for (size_t k = 0; k < sizeof kind / sizeof *kind; k++) {
        struct files_image *image = image_opened(
            &(struct files_image_input){.file = written("j.tif", (struct how){.description = kind[k].text})});
        for (int c = 0; c < 3; c++)
            check_close(files_image_voxel(image)[c], kind[k].voxel[c], 1e-7 * kind[k].voxel[c]); /* float in the file */
        assert_string_equal(files_image_unit(image), kind[k].unit);
        check_sample(image, 0);
        files_image_close(image);
    }
}

static void put_number(unsigned char *to, int bytes, unsigned value) {
    for (int k = 0; k < bytes; k++) to[k] = (unsigned char)(value >> 8 * (bytes - 1 - k));
}

/* As ImageJ writes more than 4 GB: the directory of one page, and all slices behind it, big-endian. */
static void slices_behind_the_only_page(void **state) {
    (void)state;
    static const char text[] = "ImageJ=1.53t\nimages=4\nslices=4\nunit=um\nspacing=2\n";
    enum { ENTRIES = 9, TEXT = 8 + 2 + 12 * ENTRIES + 4, DATA = TEXT + sizeof text };
    /* tag, type (2: text, 3: 2 bytes, 4: 4 bytes), number, value */
    static const unsigned entry[ENTRIES][4] = {{256, 3, 1, NX},   {257, 3, 1, NY}, {258, 3, 1, 16},
                                               {259, 3, 1, 1},    {262, 3, 1, 1},  {270, 2, sizeof text, TEXT},
                                               {273, 4, 1, DATA}, {278, 3, 1, NY}, {279, 4, 1, NX * NY * 2}};
    unsigned char head[DATA] = {'M', 'M', 0, 42, 0, 0, 0, 8, 0, ENTRIES}, data[VOXELS * 2];
    for (int k = 0; k < ENTRIES; k++) {
        unsigned char *to = head + 10 + 12 * k;
        put_number(to, 2, entry[k][0]);
        put_number(to + 2, 2, entry[k][1]);
        put_number(to + 4, 4, entry[k][2]);
        put_number(to + 8, entry[k][1] == 3 ? 2 : 4, entry[k][3]);
    }
    memcpy(head + TEXT, text, sizeof text);
    const char *path = image_path(folder, "slices.tif");
    image_write(path, head, sizeof head, data, sample_bytes("xyz", 2, 1, data));
    check_at(path, FILES_IMAGE_UINT16);
    image_write(path, head, sizeof head, data, VOXELS * 2 - 1);
    const struct files_image_input input = {.file = path};
    check_refused(&input, "it has 451 bytes, but 7 x 5 x 4 voxels of uint16 take 280 after 172 of a header");
}

static void odd_tiffs_are_refused(void **state) {
    (void)state;
    static const struct {
        struct how how;
        const char *why;
    } odd[] = {
        {{.samples = 3, .meaning = PHOTOMETRIC_RGB},
         "it has 3 samples a pixel, as colours have: one is needed, grey or a label"},
        {{.samples = 2}, "it has 2 samples a pixel, as colours have: one is needed, grey or a label"},
        {{.bits = 16, .number = SAMPLEFORMAT_IEEEFP},
         "its voxels have 16 bits of sample format 3: integers of 1, 8, 16 or 32 bits and floating point of 32 or 64 "
         "are read"},
        {{.scheme = COMPRESSION_JPEG},
         "it is compressed by JPEG (scheme 7): LZW, Deflate, PackBits, ZSTD and LZMA are read"},
        {{.odd_page = 2}, "page 3 has 7 x 4 pixels, and page 1 has 7 x 5"},
        {{.description = "ImageJ=1.53t\nimages=900\n", .pages = 1, .scheme = COMPRESSION_LZW},
         "it holds 900 slices in one page, and not as ImageJ writes them"},
        {{.depth = 4, .pages = 1},
         "page 1 holds 4 slices (ImageDepth), and one is read: save it with a page a slice, "
         "in Python with import tifffile as t; t.imwrite('pages.tif', t.imread(FILE))"},
        {{.description = "ImageJ=1.53t\nimages=4\nchannels=2\nslices=2\n"},
         "it holds 2 channels of the image, and one is needed: save it alone, in ImageJ by Image > Duplicate, in "
         "Python with import tifffile as t; s = t.TiffFile(FILE).series[0]; "
         "t.imwrite('one.tif', s.asarray()[tuple(0 if a in 'CT' else slice(None) for a in s.axes)])"},
        {{.description = "ImageJ=1.53t\nimages=4\nframes=4\n"},
         "it holds 4 frames of the image, and one is needed: save it alone, in ImageJ by Image > Duplicate, in Python"
         " with import tifffile as t; s = t.TiffFile(FILE).series[0]; "
         "t.imwrite('one.tif', s.asarray()[tuple(0 if a in 'CT' else slice(None) for a in s.axes)])"},
        {{.description = "<?xml version=\"1.0\"?><OME><Image><Pixels SizeX=\"7\" SizeC=\"2\" SizeZ=\"2\" "
                         "SizeT=\"1\"/></Image></OME>"},
         "it holds 2 channels of the image, and one is needed: save it alone, in ImageJ by Image > Duplicate, in "
         "Python with import tifffile as t; s = t.TiffFile(FILE).series[0]; "
         "t.imwrite('one.tif', s.asarray()[tuple(0 if a in 'CT' else slice(None) for a in s.axes)])"},
        {{.description = "<OME><Image><Pixels SizeC=\"1\" SizeZ=\"2\" SizeT=\"2\"/></Image></OME>"},
         "it holds 2 frames of the image, and one is needed: save it alone, in ImageJ by Image > Duplicate, in Python"
         " with import tifffile as t; s = t.TiffFile(FILE).series[0]; "
         "t.imwrite('one.tif', s.asarray()[tuple(0 if a in 'CT' else slice(None) for a in s.axes)])"},
        {{.description = "ImageJ=1.53t\nimages=900\n", .pages = 1, .rows = 1},
         "it holds 900 slices in one page, and not as ImageJ writes them"}};
    for (size_t k = 0; k < sizeof odd / sizeof *odd; k++) {
        const struct files_image_input input = {.file = written("odd.tif", odd[k].how)};
        check_refused(&input, odd[k].why);
    }
    check_file(&(struct files_image_input){
        .file = written("ome.tif", (struct how){.description = "<OME><Pixels SizeC=\"1\" SizeT=\"1\" SizeZ=\"4\"/>"})});
    const struct files_image_input ordered = {.file = written("odd.tif", (struct how){0}),
                                              .byte_order = FILES_IMAGE_BIG};
    check_refused(&ordered, "a byte order is given, and tiff files say it themselves");
    const struct files_image_input behind = {.file = ordered.file, .header_bytes = 8};
    check_refused(&behind, "bytes of a header are given, and it is not a raw file (tiff)");
    const struct files_image_input text = {.file = image_path(folder, "text.tif"), .format = FILES_IMAGE_TIFF};
    image_write(text.file, "no image", 8, "", 0);
    check_refused(&text, "it is not a TIFF that can be read: Not a TIFF or MDI file, bad magic number 28526 (0x6f6e)");
}

/* 250 bytes that say 40 GB, plain and by Deflate. */
static void no_more_is_claimed_than_a_file_can_hold(void **state) {
    (void)state;
    enum { ENTRIES = 9 };
    for (unsigned scheme = 1; scheme < 9; scheme += 7) {
        const unsigned entry[ENTRIES][3] = {{256, 4, 200000},       {257, 4, 200000},  {258, 3, 8 << 16},
                                            {259, 3, scheme << 16}, {262, 3, 1 << 16}, {273, 4, 200},
                                            {277, 3, 1 << 16},      {278, 4, 200000},  {279, 4, 50}};
        unsigned char head[250] = {'M', 'M', 0, 42, 0, 0, 0, 8, 0, ENTRIES};
        for (int k = 0; k < ENTRIES; k++) {
            put_number(head + 10 + 12 * k, 2, entry[k][0]);
            put_number(head + 12 + 12 * k, 2, entry[k][1]);
            put_number(head + 14 + 12 * k, 4, 1);
            put_number(head + 18 + 12 * k, 4, entry[k][2]);
        }
        const struct files_image_input input = {.file = image_path(folder, "claim.tif")};
        image_write(input.file, head, sizeof head, "", 0);
        char problem[800] = "", expected[1200];
        assert_null(files_image_open(&input, problem, sizeof problem));
        snprintf(expected, sizeof expected,
                 "%s: its header says 200000 x 200000 x 1 voxels, and its 250 bytes cannot hold them", input.file);
        assert_string_equal(problem, expected);
    }
}

/* Cut off in a page's voxels, and before the directory of a page. */
static void a_tiff_cut_off_is_refused(void **state) {
    (void)state;
    char problem[800] = "";
    int value[VOXELS];
    const char *path = written("cut.tif", (struct how){.scheme = COMPRESSION_LZW, .bits = 16});
    FILE *file = fopen(path, "rb");
    static char data[1 << 16];
    const size_t bytes = fread(data, 1, sizeof data, file);
    fclose(file);
    for (size_t n = 0; n < bytes; n++) {
        if (n + 1 < bytes && check_skips((int)n, 3)) continue;
        image_write(path, data, n, "", 0);
        struct files_image *image = files_image_open(
            &(struct files_image_input){.file = path, .format = FILES_IMAGE_TIFF}, problem, sizeof problem);
        if (image &&
            files_image_read(image, (long[3]){0}, files_image_size(image), value, problem, sizeof problem) == 0)
            fail_msg("%zu bytes of %zu are accepted", n, bytes);
        files_image_close(image);
    }
    assert_non_null(strstr(problem, "cut.tif: it is cut off behind page 4"));
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    TIFFSetWarningHandler(NULL); /* it advises against an old number for Deflate */
    folder = files_folder("image_tiff");
    const struct CMUnitTest tests[] = {cmocka_unit_test(types_and_byte_orders),
                                       cmocka_unit_test(strips_tiles_and_compressions),
                                       cmocka_unit_test(large_pages),
                                       cmocka_unit_test(labels_of_a_palette_and_of_one_bit),
                                       cmocka_unit_test(imagej_says_its_voxel),
                                       cmocka_unit_test(slices_behind_the_only_page),
                                       cmocka_unit_test(odd_tiffs_are_refused),
                                       cmocka_unit_test(no_more_is_claimed_than_a_file_can_hold),
                                       cmocka_unit_test(a_tiff_cut_off_is_refused)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
