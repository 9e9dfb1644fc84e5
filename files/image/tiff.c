/* Reads stacks of grey pages by libtiff, the rows or tiles that a box needs. */
#include "files/image/tiff.h"
#include "files/image/header.h"
#include "files/image/number.h"

#include <stdlib.h>
#include <string.h>
#include <tiffio.h>
#include <unistd.h>

enum { PIECE_MOST = 1 << 28 }; /* bytes of a row or a tile */

/* What all pages must share. */
struct page {
    uint32_t width, height;
    uint16_t bits, number; /* SAMPLEFORMAT_... */
};

struct tiff {
    TIFF *file;
    struct page first;
    uint64_t *at; /* [pages] bytes of the pages' directories */
    long pages;
    /* of the page that is open, -1: none */
    long open;
    uint32_t next_row; /* that libtiff decodes without beginning again */
    uint32_t rows, tile[2];
    char *piece; /* a row or a tile */
    size_t room;
    char said[200]; /* by libtiff */
};

static int keep_error(TIFF *file, void *user, const char *module, const char *format, va_list args) {
    (void)file, (void)module;
    struct tiff *t = user;
    vsnprintf(t->said, sizeof t->said, format, args);
    return 1;
}

static int keep_quiet(TIFF *file, void *user, const char *module, const char *format, va_list args) {
    (void)file, (void)user, (void)module, (void)format, (void)args;
    return 1;
}

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

/* Checks the page whose directory is loaded. */
static int check_page(struct image_source *s, struct tiff *t, long k, struct page *p) {
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
    long room = 0;
    do {
        struct page p = {0};
        if (t->pages == room) {
            room = 2 * room + 64;
            uint64_t *more = realloc(t->at, (size_t)room * sizeof *more);
            if (!more) return image_source_refuse(s, "no memory left to read it");
            t->at = more;
        }
        if (check_page(s, t, t->pages, &p)) return 1;
        if (t->pages == 0) t->first = p;
        if (p.width != t->first.width || p.height != t->first.height)
            return image_source_refuse(s, "page %ld has %u x %u pixels, and page 1 has %u x %u", t->pages + 1, p.width,
                                       p.height, t->first.width, t->first.height);
        if (p.bits != t->first.bits || p.number != t->first.number)
            return image_source_refuse(s, "page %ld has another type of pixel than page 1", t->pages + 1);
        t->at[t->pages++] = TIFFCurrentDirOffset(t->file);
        t->said[0] = '\0';
    } while (TIFFReadDirectory(t->file));
    if (t->said[0]) return image_source_refuse(s, "page %ld cannot be read: %s", t->pages + 1, t->said);
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

/* ImageJ gives pixels a unit in the resolution, and the distance of slices in its description. Other programs write
 * resolutions of printers. */
static int read_imagej(struct image_source *s, struct tiff *t) {
    char *text = NULL, value[32];
    float resolution[2] = {0, 0};
    TIFFSetDirectory(t->file, 0);
    if (!TIFFGetField(t->file, TIFFTAG_IMAGEDESCRIPTION, &text) || !text || strncmp(text, "ImageJ=", 7) != 0) return 0;
    if (t->pages == 1 && imagej_value(text, "images=", value) && strtol(value, NULL, 10) > 1)
        return image_source_refuse(s,
                                   "it holds %s slices in one page, as ImageJ writes more than 4 GB: save it as raw "
                                   "or NRRD",
                                   value);
    const double metres = imagej_value(text, "unit=", value) ? image_header_metres(value) : 0;
    TIFFGetField(t->file, TIFFTAG_XRESOLUTION, &resolution[0]);
    TIFFGetField(t->file, TIFFTAG_YRESOLUTION, &resolution[1]);
    if (metres == 0) return 0;
    for (int f = 0; f < 2; f++) s->voxel[f] = resolution[f] > 0 ? metres / (double)resolution[f] : 0;
    s->voxel[2] = imagej_value(text, "spacing=", value) ? metres * strtod(value, NULL) : 0;
    s->unit = "m";
    return 0;
}

static int refuse_page(struct image_source *s, const struct tiff *t, long k) {
    return image_source_refuse(s, "page %ld cannot be read: %s", k + 1, t->said[0] ? t->said : "it is damaged");
}

static int open_page(struct image_source *s, struct tiff *t, long k) {
    struct page p = {0};
    if (t->open == k) return 0;
    t->open = -1;
    t->said[0] = '\0';
    if (!TIFFSetSubDirectory(t->file, t->at[k]) || check_page(s, t, k, &p) ||
        memcmp(&p, &t->first, sizeof p) != 0) /* the file has changed since */
        return refuse_page(s, t, k);
    uint64_t bytes;
    t->tile[0] = t->tile[1] = t->rows = 0;
    if (TIFFIsTiled(t->file)) {
        TIFFGetField(t->file, TIFFTAG_TILEWIDTH, &t->tile[0]);
        TIFFGetField(t->file, TIFFTAG_TILELENGTH, &t->tile[1]);
        bytes = TIFFTileSize64(t->file);
        if (!t->tile[0] || !t->tile[1]) return refuse_page(s, t, k);
    } else {
        TIFFGetFieldDefaulted(t->file, TIFFTAG_ROWSPERSTRIP, &t->rows);
        bytes = TIFFScanlineSize64(t->file);
        if (!t->rows) return refuse_page(s, t, k);
    }
    if (bytes == 0 || bytes > PIECE_MOST)
        return image_source_refuse(s, "page %ld has rows or tiles of more than %d MB", k + 1, PIECE_MOST >> 20);
    if (bytes > t->room) {
        free(t->piece);
        t->room = 0;
        if (!(t->piece = calloc(1, bytes))) return image_source_refuse(s, "no memory left to read it");
        t->room = bytes;
    }
    t->open = k;
    t->next_row = p.height; /* nothing is decoded yet */
    return 0;
}

/* n pixels of a row of the piece, from the given one on. */
static void convert(const struct image_source *s, const char *row, long from, long n, double *value) {
    const struct tiff *t = s->file;
    if (t->first.bits != 1) {
        image_number_convert(s->type, 0, row + from * image_number_bytes(s->type), n, value);
        return;
    }
    for (long i = 0; i < n; i++) value[i] = row[(from + i) / 8] >> (7 - (from + i) % 8) & 1;
}

/* Rows of a strip can only be decoded one after the other. */
static int read_row(struct image_source *s, struct tiff *t, uint32_t j) {
    const uint32_t first = j - j % t->rows;
    uint32_t row = t->next_row >= first && t->next_row <= j ? t->next_row : first;
    for (; row <= j; row++)
        if (TIFFReadScanline(t->file, t->piece, row, 0) != 1) {
            const long page = t->open;
            t->open = -1;
            return refuse_page(s, t, page);
        }
    t->next_row = j + 1;
    return 0;
}

static int read_rows(struct image_source *s, struct tiff *t, const long low[3], const long high[3], double *value) {
    const long n = high[0] - low[0];
    for (long j = low[1]; j < high[1]; j++, value += n) {
        if (read_row(s, t, (uint32_t)j)) return 1;
        convert(s, t->piece, low[0], n, value);
    }
    return 0;
}

static long larger(long a, long b) { return a > b ? a : b; }
static long smaller(long a, long b) { return a < b ? a : b; }

static int read_tiles(struct image_source *s, struct tiff *t, const long low[3], const long high[3], double *value) {
    const long tx = t->tile[0], ty = t->tile[1], n = high[0] - low[0];
    const tmsize_t stride = TIFFTileRowSize(t->file);
    for (long y = low[1] - low[1] % ty; y < high[1]; y += ty)
        for (long x = low[0] - low[0] % tx; x < high[0]; x += tx) {
            if (TIFFReadTile(t->file, t->piece, (uint32_t)x, (uint32_t)y, 0, 0) < 0) return refuse_page(s, t, t->open);
            const long i = larger(x, low[0]), to = smaller(x + tx, high[0]);
            for (long j = larger(y, low[1]); j < smaller(y + ty, high[1]); j++)
                convert(s, t->piece + (j - y) * stride, i - x, to - i, value + (j - low[1]) * n + (i - low[0]));
        }
    return 0;
}

static int read_box(struct image_source *s, const long low[3], const long high[3], double *value) {
    struct tiff *t = s->file;
    const long page = (high[0] - low[0]) * (high[1] - low[1]);
    for (long k = low[2]; k < high[2]; k++, value += page) {
        if (open_page(s, t, k)) return 1;
        if (t->tile[0] ? read_tiles(s, t, low, high, value) : read_rows(s, t, low, high, value)) return 1;
    }
    return 0;
}

static void close_file(struct image_source *s) {
    struct tiff *t = s->file;
    if (t->file) TIFFClose(t->file);
    free(t->at);
    free(t->piece);
    free(t);
}

/* Blocks of whole rows, and of whole rows of tiles, so that nothing is decoded twice. */
static int choose_block(struct image_source *s, struct tiff *t) {
    if (open_page(s, t, 0)) return 1;
    image_source_block_in_turn(s);
    const long rows = t->tile[0] ? t->tile[1] : 1;
    if (s->block[1] < s->n[1] && rows <= IMAGE_MOST / s->block[0])
        s->block[1] = larger(s->block[1] - s->block[1] % rows, rows);
    return 0;
}

static TIFF *open_tiff(struct tiff *t, int fd, const char *path, long long bytes) {
    TIFFOpenOptions *options = TIFFOpenOptionsAlloc();
    if (!options) return NULL;
    TIFFOpenOptionsSetErrorHandlerExtR(options, keep_error, t);
    TIFFOpenOptionsSetWarningHandlerExtR(options, keep_quiet, NULL);
    TIFFOpenOptionsSetMaxSingleMemAlloc(options, (tmsize_t)(4 * bytes + PIECE_MOST)); /* whatever a header says */
    TIFF *file = TIFFFdOpenExt(fd, path, "rm", options); /* no mapping: a file cut off meanwhile would be a signal */
    TIFFOpenOptionsFree(options);
    return file;
}

int image_tiff_open(struct image_source *s, const struct files_image_input *input) {
    long long bytes;
    const int fd = image_source_file(s, input->file, &bytes);
    if (fd < 0) return 1;
    struct tiff *t = calloc(1, sizeof *t);
    if (!t || !(t->file = open_tiff(t, fd, input->file, bytes))) {
        image_source_refuse(s, "it is no TIFF that can be read: %s", t && t->said[0] ? t->said : "no memory left");
        close(fd);
        free(t);
        return 1;
    }
    t->open = -1;
    s->file = t;
    s->read = read_box;
    s->close = close_file;
    if (count_pages(s, t) || check_last_link(s, t, bytes) || find_type(s, &t->first) || read_imagej(s, t)) return 1;
    s->n[0] = t->first.width;
    s->n[1] = t->first.height;
    s->n[2] = t->pages;
    return image_source_bytes(s, &bytes) || choose_block(s, t);
}
