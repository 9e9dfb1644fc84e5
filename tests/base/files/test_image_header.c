/* MetaImage and NRRD: attached and detached, the sample in each; voxel sizes; refusals. */
#include "tests/base/files/image.h"

#include <math.h>
#include <unistd.h>
#include <zlib.h>

static const char *folder;

/* The header, then the bytes of the sample; returns the path. */
static const char *attached(const char *name, const char *header, int bytes, int big) {
    unsigned char data[VOXELS * 8];
    const char *path = image_path(folder, name);
    image_write(path, header, strlen(header), data, sample_bytes("xyz", bytes, big, data));
    return path;
}

static const char *alone(const char *name, const char *header) {
    const char *path = image_path(folder, name);
    image_write(path, header, strlen(header), "", 0);
    return path;
}

static void check_at(const char *path, enum files_image_format format, enum files_image_type type) {
    struct files_image *image = image_opened(&(struct files_image_input){.file = path});
    check_equal(files_image_format_of(image), format);
    check_equal(files_image_type_of(image), type);
    check_sample(image, 0);
    files_image_close(image);
    check_file(&(struct files_image_input){.file = path, .format = format, .size = {NX, NY, NZ}, .type = type});
}

static void check_voxel(const char *path, double x, double y, double z, const char *unit) {
    struct files_image *image = image_opened(&(struct files_image_input){.file = path});
    const double expected[3] = {x, y, z};
    for (int c = 0; c < 3; c++) check_close(files_image_voxel(image)[c], expected[c], 1e-15 * expected[c]);
    assert_string_equal(files_image_unit(image), unit);
    files_image_close(image);
}

#define MHD "NDims = 3\nDimSize = 7 5 4\n"
#define NRRD "NRRD0004\n# a comment\ntype: uint8\ndimension: 3\nsizes: 7 5 4\n"

static void metaimages(void **state) {
    (void)state;
    check_at(attached("local.mha",
                      "ObjectType = Image\r\n" MHD "ElementType = MET_UCHAR\r\nElementDataFile = LOCAL\r\n", 1, 0),
             FILES_IMAGE_MHD, FILES_IMAGE_UINT8);
    check_at(attached("big.mha",
                      "ObjectType = Image\n" MHD "BinaryData = True\nBinaryDataByteOrderMSB = True\nCompressedData = "
                      "False\nTransformMatrix = 1 0 0 0 1 0 0 0 1\nElementType = MET_SHORT\nElementDataFile = LOCAL\n",
                      2, 1),
             FILES_IMAGE_MHD, FILES_IMAGE_INT16);
    attached("beside.raw", "12345", 4, 0);
    check_at(alone("beside.mhd", MHD "ElementByteOrderMSB = False\nElementType = MET_ULONG\nHeaderSize = 5\n"
                                     "ElementDataFile = beside.raw\n"),
             FILES_IMAGE_MHD, FILES_IMAGE_UINT32);
    check_at(alone("end.mhd", MHD "ElementType = MET_INT\nHeaderSize = -1\nElementDataFile = beside.raw\n"),
             FILES_IMAGE_MHD, FILES_IMAGE_INT32);
    char text[FOLDER_PATH + 200];
    snprintf(text, sizeof text, MHD "ElementType = MET_INT\nHeaderSize = 5\nElementDataFile = %s/beside.raw\n", folder);
    check_at(alone("absolute.mhd", text), FILES_IMAGE_MHD, FILES_IMAGE_INT32);
}

static void metaimages_say_their_voxel(void **state) {
    (void)state;
#define REST "ElementType = MET_UCHAR\nElementDataFile = LOCAL\n"
    check_voxel(attached("v.mha", MHD REST, 1, 0), 0, 0, 0, "");
    check_voxel(attached("v.mha", MHD "ElementSpacing = 1.5 2 2.5\nElementSize = 9 9 9\n" REST, 1, 0), 1.5, 2, 2.5, "");
    check_voxel(attached("v.mha", MHD "ElementSize = 1.5 2 2.5\n" REST, 1, 0), 1.5, 2, 2.5, "");
    check_voxel(attached("v.mha", MHD "DistanceUnits = um\nElementSpacing = 1.5 2 2.5\n" REST, 1, 0), 1.5e-6, 2e-6,
                2.5e-6, "m");
    check_voxel(attached("v.mha", MHD "ElementSpacing = -1 nan 0\n" REST, 1, 0), 0, 0, 0, "");
    /* the voxel turns with the axes */
    struct files_image *image = image_opened(&(struct files_image_input){
        .file = attached("v.mha", MHD "ElementSpacing = 1 2 3\n" REST, 1, 0), .axes = "zxy"});
    for (int c = 0; c < 3; c++) {
        check_equal(files_image_voxel(image)[c], ((double[]){2, 3, 1})[c]);
        check_equal(files_image_size(image)[c], ((long[]){5, 4, 7})[c]);
    }
    files_image_close(image);
}

static void nrrds(void **state) {
    (void)state;
    check_at(attached("a.nrrd", NRRD "encoding: raw\nkey:=value: of the user\nkinds: domain domain domain\n\n", 1, 0),
             FILES_IMAGE_NRRD, FILES_IMAGE_UINT8);
    check_at(attached("b.nrrd",
                      "NRRD00.01\r\ntype: unsigned short\r\ndimension: 3\r\nsizes: 7 5 4\r\nendian: "
                      "big\r\nencoding: RAW\r\n\r\n",
                      2, 1),
             FILES_IMAGE_NRRD, FILES_IMAGE_UINT16);
    attached("lines.dat", "one\ntwo\n123", 8, 0);
    check_at(alone("c.nhdr", "NRRD0005\ntype: long long\ndimension: 3\nsizes: 7 5 4\nendian: little\nencoding: raw\n"
                             "data file: lines.dat\nline skip: 2\nbyte skip: 3\n"),
             FILES_IMAGE_NRRD, FILES_IMAGE_INT64);
    check_at(alone("d.nhdr", "NRRD0005\ntype: uint64_t\ndimension: 3\nsizes: 7 5 4\nendian: little\nencoding: raw\n"
                             "datafile: ./lines.dat\nbyteskip: -1\n"),
             FILES_IMAGE_NRRD, FILES_IMAGE_UINT64);
}

static const char *compressed(const char *name, const char *header, const char *before, int bytes, int big) {
    unsigned char data[VOXELS * 8];
    const char *path = image_path(folder, name);
    image_write(path, header, strlen(header), "", 0);
    gzFile file = gzopen(path, "ab");
    const size_t n = sample_bytes("xyz", bytes, big, data);
    if (before[0]) assert_int_equal(gzwrite(file, before, (unsigned)strlen(before)), strlen(before));
    assert_int_equal(gzwrite(file, data, (unsigned)n), n);
    assert_int_equal(gzclose(file), Z_OK);
    return path;
}

static void nrrds_by_gzip(void **state) {
    (void)state;
    check_at(compressed("a.nrrd", NRRD "encoding: gzip\n\n", "", 1, 0), FILES_IMAGE_NRRD, FILES_IMAGE_UINT8);
    compressed("skip.gz", "line\n", "1234", 4, 1);
    check_at(alone("b.nhdr", "NRRD0005\ntype: uint\ndimension: 3\nsizes: 7 5 4\nendian: big\nencoding: gz\n"
                             "data file: skip.gz\nline skip: 1\nbyte skip: 4\n"),
             FILES_IMAGE_NRRD, FILES_IMAGE_UINT32);
}

/* The header, then the bytes of the sample as zlib compresses them, less `cut` at the end; returns the path. */
static const char *deflated(const char *name, const char *header, int bytes, int big, uLong cut) {
    unsigned char data[VOXELS * 8], packed[VOXELS * 9 + 64];
    const char *path = image_path(folder, name);
    uLongf n = sizeof packed;
    assert_int_equal(compress(packed, &n, data, sample_bytes("xyz", bytes, big, data)), Z_OK);
    image_write(path, header, strlen(header), packed, n - cut);
    return path;
}

static void metaimages_by_zlib(void **state) {
    (void)state;
#define PACKED MHD "CompressedData = True\n"
    check_at(deflated("z.mha", PACKED "CompressedDataSize = 99\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n", 1,
                      0, 0),
             FILES_IMAGE_MHD, FILES_IMAGE_UINT8);
    deflated("z.zraw", "12345", 4, 1, 0);
    check_at(alone("z.mhd", PACKED "ElementByteOrderMSB = True\nElementType = MET_INT\nHeaderSize = 5\n"
                                   "ElementDataFile = z.zraw\n"),
             FILES_IMAGE_MHD, FILES_IMAGE_INT32);
    check_at(compressed("g.mha", PACKED "ElementType = MET_UCHAR\nElementDataFile = LOCAL\n", "", 1, 0),
             FILES_IMAGE_MHD, FILES_IMAGE_UINT8); /* gzip, as some programs write it */
    const char *cut = PACKED "ElementType = MET_UCHAR\nElementDataFile = LOCAL\n";
    const struct files_image_input input = {.file = deflated("cut.mha", cut, 1, 0, 60)};
    check_refused(&input, "it ends before its voxels do");
    deflated("cut.mha", cut, 1, 0, 2);
    check_refused(&input, "it ends before its checksum");
    deflated("cut.mha", cut, 2, 0, 0);
    check_refused(&input, "it has more bytes than its voxels");
}

/* Two parts one after the other, each with a head of its own, as gzip joins files. */
static void parts_of_gzip(void **state) {
    (void)state;
    unsigned char data[VOXELS];
    const char *path = alone("parts.nrrd", NRRD "encoding: gzip\n\n");
    sample_bytes("xyz", 1, 0, data);
    for (int part = 0; part < 2; part++) {
        gzFile file = gzopen(path, "ab");
        assert_int_equal(gzwrite(file, data + part * 50, part ? VOXELS - 50 : 50), part ? VOXELS - 50 : 50);
        gzclose(file);
    }
    check_at(path, FILES_IMAGE_NRRD, FILES_IMAGE_UINT8);
}

/* Planes longer than a block: they are still read in the file's order. */
static void a_large_one_by_gzip(void **state) {
    (void)state;
    enum { X = 1300, Y = 900, Z = 3 };
    static unsigned char data[X * Y * Z];
    static int value[X * Y * Z];
    char problem[800] = "";
    for (long i = 0; i < X * Y * Z; i++) data[i] = (unsigned char)(i * 7 + i / 1000);
    const char *path = alone("large.nrrd", "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 1300 900 3\nencoding: gz\n\n");
    gzFile file = gzopen(path, "ab1");
    assert_int_equal(gzwrite(file, data, sizeof data), sizeof data);
    gzclose(file);
    struct files_image *image = image_opened(&(struct files_image_input){.file = path});
    if (files_image_read(image, (long[3]){0}, (long[]){X, Y, Z}, value, problem, sizeof problem))
        fail_msg("%s", problem);
    for (long i = 0; i < X * Y * Z; i++)
        if (value[i] != data[i]) fail_msg("voxel %ld is %d, not %d", i, value[i], data[i]);
    files_image_close(image);
}

static void nrrds_say_their_voxel(void **state) {
    (void)state;
#define END "encoding: raw\n\n"
    check_voxel(attached("v.nrrd", NRRD END, 1, 0), 0, 0, 0, "");
    check_voxel(attached("v.nrrd", NRRD "spacings: 1 2 NaN\n" END, 1, 0), 1, 2, 0, "");
    check_voxel(attached("v.nrrd", NRRD "spacings: 1 2 3\nunits: \"mm\" \"mm\" \"mm\"\n" END, 1, 0), 1e-3, 2e-3, 3e-3,
                "m");
    check_voxel(attached("v.nrrd", NRRD "spacings: 1 2 3\nunits: \"mm\" \"mm\" \"s\"\n" END, 1, 0), 1, 2, 3, "");
    check_voxel(
        attached("v.nrrd",
                 NRRD "space directions: (0,-3,4) (2, 0, 0) (0,0,1e0)\nspace units: \" um\" \"um\" \"um\"\n" END, 1, 0),
        5e-6, 2e-6, 1e-6, "m");
    check_voxel(attached("v.nrrd", NRRD "space directions: none (2,0) (0,3)\n" END, 1, 0), 0, 2, 3, "");
}

static void odd_metaimages_are_refused(void **state) {
    (void)state;
    static const char *const odd[][2] = {
        {"ObjectType = Tube\n" MHD REST, "its header has ObjectType = Tube: an Image is needed"},
        {"NDims = 2\nDimSize = 7 5\n" REST, "its header has NDims = 2: 3 are needed"},
        {"NDims = 3\n" REST, "its header has no DimSize, which a MetaImage needs"},
        {MHD "ElementDataFile = LOCAL\n", "its header has no ElementType, which a MetaImage needs"},
        {MHD "ElementType = MET_UCHAR\n", "its header has no ElementDataFile, which a MetaImage needs"},
        {"NDims = 3\nDimSize = 7 5\n" REST, "its header has DimSize = 7 5: three numbers are needed"},
        {"NDims = 3\nDimSize = 7 5 4 1\n" REST, "its header has DimSize = 7 5 4 1: three numbers are needed"},
        {"NDims = 3\nDimSize = 7 5 -4\n" REST, "it has 7 x 5 x -4 voxels: at least 1 is needed along each axis"},
        {"NDims = 3\nDimSize = 7 5 99999999999999999999\n" REST,
         "its header has DimSize = 7 5 99999999999999999999: three numbers are needed"},
        {"NDims = 3\nDimSize = 4294967296 4294967296 4294967296\n" REST,
         "it has 4294967296 x 4294967296 x 4294967296 voxels: more than a file can hold"},
        {MHD "DimSize = 7 5 4\n" REST, "its header gives DimSize twice"},
        {MHD "CompressedData = True\n" REST, "it is not compressed by gzip or zlib, as its header says"},
        {MHD "CompressedData = True\nHeaderSize = -1\n" REST,
         "its header has HeaderSize = -1, which does not go with CompressedData = True"},
        {MHD "BinaryData = False\n" REST, "its voxels are written as text: binary ones are read (BinaryData = True)"},
        {MHD "ElementNumberOfChannels = 3\n" REST, "its header has ElementNumberOfChannels = 3: 1 is needed"},
        {MHD "ElementSpacing = 1 1\n" REST, "its header has ElementSpacing = 1 1: three numbers are needed"},
        {MHD "HeaderSize = -2\n" REST, "its header has HeaderSize = -2: -1 or a number of bytes is needed"},
        {MHD "ElementType = MET_RGB\nElementDataFile = LOCAL\n",
         "its header has ElementType = MET_RGB, which is not read"},
        {MHD "ElementType = MET_UCHAR\nElementDataFile = LIST\n", "its voxels are in several files: one file is read"},
        {MHD "ElementType = MET_UCHAR\nElementDataFile = s%03d.raw 1 4 1\n",
         "its voxels are in several files: one file is read"},
        {MHD "ElementType = MET_USHORT\nElementDataFile = LOCAL\n",
         "it has 215 bytes, but 7 x 5 x 4 voxels of uint16 take 280 after 75 of a header; there is 1 byte a voxel"},
        {MHD "ElementType = MET_UCHAR\nElementDataFile = none.raw\n",
         "its data file none.raw cannot be read: No such file or directory"}};
    for (size_t k = 0; k < sizeof odd / sizeof *odd; k++) {
        const struct files_image_input input = {.file = attached("odd.mhd", odd[k][0], 1, 0)};
        check_refused(&input, odd[k][1]);
    }
    const struct files_image_input input = {.file = attached("odd.mhd", MHD REST, 1, 0), .size = {7, 5, 5}};
    check_refused(&input, "it has 7 x 5 x 4 voxels, and its size is given as 7 x 5 x 5");
    const struct files_image_input typed = {.file = input.file, .type = FILES_IMAGE_INT8};
    check_refused(&typed, "its voxels are uint8, and their type is given as int8");
    const struct files_image_input ordered = {
        .file = attached("odd.mhd", MHD "ElementByteOrderMSB = True\n" REST, 1, 0), .byte_order = FILES_IMAGE_LITTLE};
    check_refused(&ordered, "its byte order is big, and is given as little");
}

static void odd_nrrds_are_refused(void **state) {
    (void)state;
#define SIZES "dimension: 3\nsizes: 7 5 4\n"
    static const char *const odd[][2] = {
        {"NRRD0006\n" SIZES END, "it is of version NRRD0006, and NRRD0001 to NRRD0005 are read"},
        {"NRRD0004\n" SIZES END, "its header has no type, which a NRRD needs"},
        {"NRRD0004\ntype: uchar\nsizes: 7 5 4\n" END, "its header has no dimension, which a NRRD needs"},
        {NRRD "\n", "its header has no encoding, which a NRRD needs"},
        {NRRD "encoding: raw\nlast line", "no blank line ends its header, and it names no data file"},
        {"NRRD0004\ntype: uchar\ndimension: 4\nsizes: 3 7 5 4\n" END, "its header has dimension: 4, and 3 are needed"},
        {"NRRD0004\ntype: uchar\ndimension: 3\nsizes: 7 5\n" END,
         "its header has sizes: 7 5, and three numbers are needed"},
        {"NRRD0004\ntype: char\n" SIZES END, "its header has type: char, which is not read"},
        {"NRRD0004\ntype: ushort\n" SIZES END, "its header has no endian, which a NRRD of uint16 needs"},
        {NRRD "endian: middle\n" END, "its header has endian: middle, and little or big is needed"},
        {NRRD "encoding: bzip2\n\n", "its header has encoding: bzip2, and raw and gzip are read"},
        {NRRD "encoding: gzip\nbyte skip: -1\n\n", "its header has byte skip: -1, and a number of bytes is needed"},
        {NRRD "byte skip: -2\n" END, "its header has byte skip: -2, and a number of bytes is needed"},
        {NRRD "line skip: -1\n" END, "its header has line skip: -1, and a number of lines is needed"},
        {NRRD "line skip: 9000\n" END, "it has fewer lines than line skip: 9000"},
        {NRRD "byte skip: 9223372036854775807\n" END,
         "its header has byte skip: 9223372036854775807, more than a file can hold"},
        {NRRD "kinds: RGB-color domain domain\n" END,
         "an axis of it is of kind RGB-color: three axes of space are needed"},
        {NRRD "sizes: 7 5 4\n" END, "its header gives sizes twice"},
        {NRRD "spacings: a b c\n" END, "its header has spacings: a b c, and three numbers are needed"},
        {NRRD "space directions: (1,0,0) (0,1,0)\n" END,
         "its header has space directions: (1,0,0) (0,1,0), and three vectors are needed"},
        {NRRD "encoding: raw\ndata file: LIST\na.raw\n", "its voxels are in several files: one file is read"},
        {NRRD "encoding: gzip\n\n", "it is not compressed by gzip or zlib, as its header says"}};
    for (size_t k = 0; k < sizeof odd / sizeof *odd; k++) {
        const struct files_image_input input = {.file = attached("odd.nrrd", odd[k][0], 1, 0)};
        check_refused(&input, odd[k][1]);
    }
    /* compressed, and cut off or damaged */
    const struct files_image_input input = {.file = compressed("cut.nrrd", NRRD "encoding: gzip\n\n", "", 1, 0)};
    FILE *file = fopen(input.file, "r+b");
    assert_int_equal(fseek(file, 0, SEEK_END), 0);
    const long bytes = ftell(file);
    fclose(file);
    assert_int_equal(truncate(input.file, bytes - 40), 0);
    check_refused(&input, "it ends before its voxels do");
    compressed("cut.nrrd", NRRD "encoding: gzip\n\n", "", 1, 0);
    file = fopen(input.file, "r+b");
    fseek(file, bytes - 8, SEEK_SET);
    fputs("\1\2\3\4", file); /* in place of the checksum */
    fclose(file);
    check_refused(&input, "it cannot be uncompressed: incorrect data check");
    compressed("cut.nrrd", NRRD "encoding: gzip\n\n", "byte", 1, 0);
    check_refused(&input, "it has more bytes than its voxels");
    /* a claim of more than any compression holds, before anything is read */
    compressed("cut.nrrd", "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 4000 4000 4000\nencoding: gzip\n\n", "", 1, 0);
    char claims[200];
    file = fopen(input.file, "rb");
    assert_int_equal(fseek(file, 0, SEEK_END), 0);
    snprintf(claims, sizeof claims,
             "its header says 4000 x 4000 x 4000 voxels, and the %ld bytes of it cannot hold them", ftell(file));
    fclose(file);
    check_refused(&input, claims);
    const struct files_image_input wrong = {.file = alone("no.nrrd", "no image"), .format = FILES_IMAGE_NRRD};
    check_refused(&wrong, "it is not an NRRD: these begin with NRRD");
}

static void an_unknown_format_is_refused(void **state) {
    (void)state;
    const struct files_image_input input = {.file = alone("what.dat", "nothing known")};
    check_refused(&input,
                  "its format is not known: it is not a MetaImage, NRRD, TIFF, HDF5, numpy or STL file, and a raw file "
                  "needs its size and the type of its voxels");
    const struct files_image_input text = {.file = alone("text.dat", "0 1 1\n0.5 -1e3\n")};
    check_refused(&text,
                  "it holds numbers written as text: in Python numpy.loadtxt(FILE).astype('uint8')"
                  ".tofile('image.raw') makes a raw file, which needs its size and the type of its voxels, uint8");
    const struct files_image_input empty = {.file = alone("empty.mhd", "")};
    check_refused(&empty, "its header has no NDims, which a MetaImage needs");
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    folder = files_folder("image_header");
    const struct CMUnitTest tests[] = {cmocka_unit_test(metaimages),
                                       cmocka_unit_test(metaimages_say_their_voxel),
                                       cmocka_unit_test(nrrds),
                                       cmocka_unit_test(metaimages_by_zlib),
                                       cmocka_unit_test(nrrds_by_gzip),
                                       cmocka_unit_test(parts_of_gzip),
                                       cmocka_unit_test(a_large_one_by_gzip),
                                       cmocka_unit_test(nrrds_say_their_voxel),
                                       cmocka_unit_test(odd_metaimages_are_refused),
                                       cmocka_unit_test(odd_nrrds_are_refused),
                                       cmocka_unit_test(an_unknown_format_is_refused)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
