/* Lists the pages of a TIFF and checks that they are slices of one grey image. */
#include "base/files/image/tiff_pages.h"
#include "base/die.h"
#include "base/files/image/header.h"

#include <stdlib.h>
#include <string.h>

/* Schemes that keep every value, and those of two colours. */
static int is_read(uint16_t scheme, uint16_t bits) {
    switch (scheme) {
    case COMPRESSION_NONE:
    case COMPRESSION_LZW:
    case COMPRESSION_ADOBE_DEFLATE:
    case COMPRESSION_DEFLATE:
    case COMPRESSION_PACKBITS:
    case COMPRESSION_ZSTD:
    case COMPRESSION_LZMA:
        return TIFFIsCODECConfigured(scheme);
    case COMPRESSION_CCITTRLE:
    case COMPRESSION_CCITTFAX3:
    case COMPRESSION_CCITTFAX4:
        return bits == 1 && TIFFIsCODECConfigured(scheme);
    default:
        return 0;
    }
}

static int find_type(struct image_source *s, const struct page *p) {
    const int bits = p->bits, is_signed = p->number == SAMPLEFORMAT_INT;
    if (p->number == SAMPLEFORMAT_IEEEFP)
        s->type = bits == 32 ? FILES_IMAGE_FLOAT32 : bits == 64 ? FILES_IMAGE_FLOAT64 : FILES_IMAGE_HEADER;
    else if (bits == 1 || bits == 8)
        s->type = is_signed && bits == 8 ? FILES_IMAGE_INT8 : FILES_IMAGE_UINT8;
    else if (bits == 16)
        s->type = is_signed ? FILES_IMAGE_INT16 : FILES_IMAGE_UINT16;
    else if (bits == 32)
        s->type = is_signed ? FILES_IMAGE_INT32 : FILES_IMAGE_UINT32;
    if (p->number <= SAMPLEFORMAT_IEEEFP && s->type != FILES_IMAGE_HEADER) return 0;
    return image_source_refuse(s,
                               "its voxels have %d bits of sample format %d: integers of 1, 8, 16 or 32 bits and "
                               "floating point of 32 or 64 are read",
                               bits, p->number);
}

int image_tiff_pages_check(struct image_source *s, struct tiff *t, long k, struct page *p) {
    uint16_t samples, scheme, meaning = PHOTOMETRIC_MINISBLACK;
    const TIFFCodec *codec;
    TIFFGetFieldDefaulted(t->file, TIFFTAG_SAMPLESPERPIXEL, &samples);
    TIFFGetFieldDefaulted(t->file, TIFFTAG_COMPRESSION, &scheme);
    TIFFGetFieldDefaulted(t->file, TIFFTAG_BITSPERSAMPLE, &p->bits);
    TIFFGetFieldDefaulted(t->file, TIFFTAG_SAMPLEFORMAT, &p->number);
    TIFFGetField(t->file, TIFFTAG_PHOTOMETRIC, &meaning);
    if (!TIFFGetField(t->file, TIFFTAG_IMAGEWIDTH, &p->width) ||
        !TIFFGetField(t->file, TIFFTAG_IMAGELENGTH, &p->height))
        return image_source_refuse(s, "page %ld has no size", k + 1);
    uint32_t depth = 1;
    TIFFGetField(t->file, TIFFTAG_IMAGEDEPTH, &depth);
    if (depth > 1)
        return image_source_refuse(
            s,
            "page %ld holds %u slices (ImageDepth), and one is read: save it with a page a slice, in Python with "
            "import tifffile as t; t.imwrite('pages.tif', t.imread(FILE))",
            k + 1, depth);
    if (samples != 1)
        return image_source_refuse(s, "it has %d samples a pixel, as colours have: one is needed, grey or a label",
                                   samples);
    if (meaning > PHOTOMETRIC_MASK || meaning == PHOTOMETRIC_RGB)
        return image_source_refuse(s, "its pixels mean colours (photometric %d): grey values or labels are needed",
                                   meaning);
    if (is_read(scheme, p->bits)) return 0;
    codec = TIFFFindCODEC(scheme);
    return image_source_refuse(s, "it is compressed by %s (scheme %d): LZW, Deflate, PackBits, ZSTD and LZMA are read",
                               codec ? codec->name : "an unknown scheme", scheme);
}

static int count_pages(struct image_source *s, struct tiff *t) {
    long capacity = 0;
    do {
        struct page p = {0};
        if (t->pages == capacity) {
            capacity = 2 * capacity + 64;
            t->at = realloc(t->at, (size_t)capacity * sizeof *t->at);
            if (!t->at) die(EXIT_CODE_FILE, "no memory left for %ld pages of an image", capacity);
        }
        if (image_tiff_pages_check(s, t, t->pages, &p)) return 1;
        if (t->pages == 0) t->first = p;
        if (p.width != t->first.width || p.height != t->first.height)
            return image_source_refuse(s, "page %ld has %u x %u pixels, and page 1 has %u x %u", t->pages + 1, p.width,
                                       p.height, t->first.width, t->first.height);
        if (p.bits != t->first.bits || p.number != t->first.number)
            return image_source_refuse(s, "page %ld has another type of pixel than page 1", t->pages + 1);
        t->at[t->pages++] = TIFFCurrentDirOffset(t->file);
        t->error[0] = '\0';
    } while (TIFFReadDirectory(t->file));
    if (t->error[0]) return image_source_refuse(s, "page %ld cannot be read: %s", t->pages + 1, t->error);
    return 0;
}

/* libtiff takes a link to the next page that is cut off for none. The link is behind a number of entries and these. */
static int check_last_link(struct image_source *s, struct tiff *t, long long bytes) {
    const int is_big = TIFFIsBigTIFF(t->file);
    const long long at = (long long)t->at[t->pages - 1];
    union {
        uint16_t small;
        uint64_t big;
    } entries;
    if (image_source_take(s, TIFFFileno(t->file), at, &entries, is_big ? 8 : 2)) return 1;
    if (TIFFIsByteSwapped(t->file)) {
        if (is_big)
            entries.big = __builtin_bswap64(entries.big);
        else
            entries.small = __builtin_bswap16(entries.small);
    }
    const uint64_t n = is_big ? entries.big : entries.small;
    if (n < 1 << 16 && at + (is_big ? 16 + 20 * (long long)n : 6 + 12 * (long long)n) <= bytes) return 0;
    return image_source_refuse(s, "it is cut off behind page %ld", t->pages);
}

/* The value of a line `key=value` of ImageJ's description, or NULL. */
static const char *imagej_value(const char *text, const char *key, char value[32]) {
    for (; text; text = strchr(text, '\n')) {
        text += *text == '\n';
        if (strncmp(text, key, strlen(key)) != 0) continue;
        text += strlen(key);
        const size_t n = strcspn(text, "\r\n");
        if (n > 31) return NULL;
        memcpy(value, text, n);
        value[n] = '\0';
        return value;
    }
    return NULL;
}

/* The number in `key="9"` of the element Pixels of OME's description; 1: it is not there. */
static long ome_value(const char *text, const char *key) {
    char name[32];
    const char *pixels = strstr(text, "<Pixels"), *end = pixels ? strchr(pixels, '>') : NULL;
    snprintf(name, sizeof name, " %s=\"", key);
    const char *at = pixels ? strstr(pixels, name) : NULL;
    return at && at < end ? strtol(at + strlen(name), NULL, 10) : 1;
}

/* Stacks of ImageJ and of OME may have several channels and frames, whose slices alternate. */
static int check_channels(struct image_source *s, struct tiff *t) {
    static const char *const word[2] = {"channels", "frames"}, *const key[2][2] = {{"channels=", "SizeC"},
                                                                                   {"frames=", "SizeT"}};
    char *text = NULL, value[32];
    TIFFSetDirectory(t->file, 0);
    if (!TIFFGetField(t->file, TIFFTAG_IMAGEDESCRIPTION, &text) || !text) return 0;
    const int imagej = strncmp(text, "ImageJ=", 7) == 0;
    for (int k = 0; k < 2; k++) {
        const long n = !imagej                                ? ome_value(text, key[k][1])
                       : imagej_value(text, key[k][0], value) ? strtol(value, NULL, 10)
                                                              : 1;
        if (n > 1)
            return image_source_refuse(s,
                                       "it holds %ld %s of the image, and one is needed: save it alone, in ImageJ by "
                                       "Image > Duplicate, in Python with import tifffile as t; "
                                       "s = t.TiffFile(FILE).series[0]; t.imwrite('one.tif', "
                                       "s.asarray()[tuple(0 if a in 'CT' else slice(None) for a in s.axes)])",
                                       n, word[k]);
    }
    return 0;
}

/* ImageJ writes stacks of more than 4 GB as one page, and the other slices behind it. It gives pixels a unit in the
 * resolution, and the distance of slices in its description. Other programs write resolutions of printers. */
static int read_imagej(struct image_source *s, struct tiff *t) {
    char *text = NULL, value[32];
    uint16_t scheme = 0;
    float resolution[2] = {0, 0};
    TIFFSetDirectory(t->file, 0);
    if (!TIFFGetField(t->file, TIFFTAG_IMAGEDESCRIPTION, &text) || !text || strncmp(text, "ImageJ=", 7) != 0) return 0;
    if (t->pages == 1 && imagej_value(text, "images=", value)) t->slices = strtol(value, NULL, 10);
    TIFFGetFieldDefaulted(t->file, TIFFTAG_COMPRESSION, &scheme);
    const int is_plain =
        scheme == COMPRESSION_NONE && !TIFFIsTiled(t->file) && TIFFNumberOfStrips(t->file) == 1 && t->first.bits >= 8;
    if (t->slices < 2) t->slices = 0;
    if (t->slices && !is_plain)
        return image_source_refuse(s, "it holds %ld slices in one page, and not as ImageJ writes them", t->slices);
    const double metres = imagej_value(text, "unit=", value) ? image_header_metres(value) : 0;
    TIFFGetField(t->file, TIFFTAG_XRESOLUTION, &resolution[0]);
    TIFFGetField(t->file, TIFFTAG_YRESOLUTION, &resolution[1]);
    if (metres == 0) return 0;
    for (int f = 0; f < 2; f++) s->voxel[f] = resolution[f] > 0 ? metres / (double)resolution[f] : 0;
    s->voxel[2] = imagej_value(text, "spacing=", value) ? metres * strtod(value, NULL) : 0;
    s->unit = "m";
    return 0;
}

/* What no file of so many bytes holds: uncompressed pages are not larger than it, and no scheme makes more than a
 * million bytes of one. A damaged header may say anything. */
static int check_claim(struct image_source *s, struct tiff *t, long long has) {
    const long long most = 1 << 20;
    char size[IMAGE_SIZE_TEXT];
    uint16_t scheme = COMPRESSION_NONE;
    long long claims;
    if (image_source_bytes(s, &claims)) return 1;
    TIFFGetFieldDefaulted(t->file, TIFFTAG_COMPRESSION, &scheme);
    if (t->first.bits == 1) claims /= 8;
    if (claims / (scheme == COMPRESSION_NONE ? 1 : most) <= has) return 0;
    return image_source_refuse(s, "its header says %s, and its %lld bytes cannot hold them", image_source_size(s, size),
                               has);
}

int image_tiff_pages_find(struct image_source *s, struct tiff *t, long long bytes) {
    if (count_pages(s, t) || check_last_link(s, t, bytes) || find_type(s, &t->first) || check_channels(s, t) ||
        read_imagej(s, t))
        return 1;
    s->n[0] = t->first.width;
    s->n[1] = t->first.height;
    s->n[2] = t->slices ? t->slices : t->pages;
    return check_claim(s, t, bytes);
}
