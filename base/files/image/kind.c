/* Tells the format of an image by its first bytes, or by its name. */
#include "base/files/image/formats.h"

#include <string.h>
#include <strings.h>
#include <unistd.h>

static const char *const format_word[FILES_IMAGE_FORMATS] = {
    [FILES_IMAGE_AUTO] = "auto", [FILES_IMAGE_RAW] = "raw",   [FILES_IMAGE_MHD] = "mhd", [FILES_IMAGE_NRRD] = "nrrd",
    [FILES_IMAGE_TIFF] = "tiff", [FILES_IMAGE_HDF5] = "hdf5", [FILES_IMAGE_NPY] = "npy", [FILES_IMAGE_STL] = "stl"};

const char *image_kind_word(enum files_image_format format) { return format_word[format]; }

static int ends(const char *name, const char *with) {
    const size_t n = strlen(name), m = strlen(with);
    return n >= m && strcasecmp(name + n - m, with) == 0;
}

int image_kind_is_text(const char *bytes, size_t n) {
    static const char known[] = "0123456789+-.eE,; \t\r\n";
    int digits = 0, blanks = 0;
    for (size_t k = 0; k < n; k++) {
        if (!bytes[k] || !strchr(known, bytes[k])) return 0;
        digits |= bytes[k] >= '0' && bytes[k] <= '9';
        blanks |= strchr(" \t\n", bytes[k]) != NULL;
    }
    return digits && blanks;
}

int image_kind_find(struct image_source *s, const struct files_image_input *input) {
    static const struct {
        const char *word;
        size_t bytes;
        enum files_image_format format;
    } first[] = {
        {"NRRD", 4, FILES_IMAGE_NRRD},       {"II*\0", 4, FILES_IMAGE_TIFF}, {"MM\0*", 4, FILES_IMAGE_TIFF},
        {"II+\0", 4, FILES_IMAGE_TIFF},      {"MM\0+", 4, FILES_IMAGE_TIFF}, {"\211HDF\r\n\032\n", 8, FILES_IMAGE_HDF5},
        {"ObjectType", 10, FILES_IMAGE_MHD}, {"NDims", 5, FILES_IMAGE_MHD},  {"\223NUMPY", 6, FILES_IMAGE_NPY}};
    char bytes[96] = "";
    long long all;
    const int fd = image_source_file(s, input->file, &all);
    if (fd < 0) return 1;
    const int fault = image_source_take(s, fd, 0, bytes, all < (long long)sizeof bytes ? (size_t)all : sizeof bytes);
    close(fd);
    if (fault) return 1;
    for (size_t k = 0; k < sizeof first / sizeof *first && !s->format; k++)
        if (memcmp(bytes, first[k].word, first[k].bytes) == 0) s->format = first[k].format;
    if (s->format) return 0;
    if (ends(input->file, ".mhd") || ends(input->file, ".mha")) s->format = FILES_IMAGE_MHD;
    if (ends(input->file, ".h5") || ends(input->file, ".hdf5")) s->format = FILES_IMAGE_HDF5;
    if (!s->format && image_stl_read_is(bytes, all < (long long)sizeof bytes ? (size_t)all : sizeof bytes, all))
        s->format = FILES_IMAGE_STL;
    if (!s->format && (input->size[0] || ends(input->file, ".raw"))) s->format = FILES_IMAGE_RAW;
    if (s->format) return 0;
    if (image_kind_is_text(bytes, all < (long long)sizeof bytes ? (size_t)all : sizeof bytes))
        return image_source_refuse(s, "it holds numbers written as text: in Python "
                                      "numpy.loadtxt(FILE).astype('uint8').tofile('image.raw') makes a raw file, which "
                                      "needs its size and the type of its voxels, uint8");
    return image_source_refuse(
        s, "its format is not known: it is not a MetaImage, NRRD, TIFF, HDF5, numpy or STL file, and a raw file "
           "needs its size and the type of its voxels");
}
