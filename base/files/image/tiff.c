/* Reads stacks of grey pages by libtiff, the rows or tiles that a box needs. */
#include "base/files/image/formats.h"
#include "base/files/image/tiff_pages.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { PIECE_MAX = 1 << 28 }; /* bytes of a row or a tile */

static int keep_error(TIFF *file, void *user, const char *module, const char *format, va_list args) {
    (void)file, (void)module;
    struct tiff *t = user;
    vsnprintf(t->error, sizeof t->error, format, args);
    return 1;
}

/* Of unknown tags nobody needs to hear. While pixels are decoded a warning means that some of them are missing. */
static int keep_warning(TIFF *file, void *user, const char *module, const char *format, va_list args) {
    const struct tiff *t = user;
    return t->open < 0 ? 1 : keep_error(file, user, module, format, args);
}

static int refuse_page(struct image_source *s, const struct tiff *t, long k) {
    return image_source_refuse(s, "page %ld cannot be read: %s", k + 1, t->error[0] ? t->error : "it is damaged");
}

static int open_page(struct image_source *s, struct tiff *t, long k) {
    struct page p = {0};
    if (t->open == k) return 0;
    t->open = -1;
    t->error[0] = '\0';
    if (!TIFFSetSubDirectory(t->file, t->at[k]) || image_tiff_pages_check(s, t, k, &p) ||
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
    if (bytes == 0 || bytes > PIECE_MAX)
        return image_source_refuse(s, "page %ld has rows or tiles of more than %d MB", k + 1, PIECE_MAX >> 20);
    if (bytes > t->capacity) {
        free(t->piece);
        t->piece = image_source_new(1, bytes);
        t->capacity = bytes;
    }
    t->open = k;
    t->bytes = bytes;
    t->error[0] = '\0';
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

/* It is opened again when it is needed. */
static int drop_page(struct image_source *s, struct tiff *t) {
    const long page = t->open;
    t->open = -1;
    return refuse_page(s, t, page);
}

/* Rows of a strip can only be decoded one after the other. */
static int read_row(struct image_source *s, struct tiff *t, uint32_t j) {
    const uint32_t first = j - j % t->rows;
    uint32_t row = t->next_row >= first && t->next_row <= j ? t->next_row : first;
    for (; row <= j; row++) {
        memset(t->piece, 0, t->bytes); /* a damaged page may leave some as it was */
        if (TIFFReadScanline(t->file, t->piece, row, 0) != 1 || t->error[0]) return drop_page(s, t);
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
            memset(t->piece, 0, t->bytes);
            if (TIFFReadTile(t->file, t->piece, (uint32_t)x, (uint32_t)y, 0, 0) < 0 || t->error[0])
                return drop_page(s, t);
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
    if (s->block[1] < s->n[1] && rows <= IMAGE_MAX / s->block[0])
        s->block[1] = larger(s->block[1] - s->block[1] % rows, rows);
    return 0;
}

/* ImageJ's slices are read as a raw file. */
static int open_slices(struct image_source *s, const char *path, long long bytes) {
    const struct tiff *t = s->file;
    const int is_big = TIFFIsBigEndian(t->file);
    uint64_t *at = NULL;
    if (!TIFFGetField(t->file, TIFFTAG_STRIPOFFSETS, &at) || !at || at[0] > (uint64_t)bytes)
        return refuse_page(s, t, 0);
    const long long first = (long long)at[0];
    close_file(s);
    s->close = NULL;
    return image_raw_open(s, path, first, is_big ? FILES_IMAGE_BIG : FILES_IMAGE_LITTLE);
}

static TIFF *open_tiff(struct tiff *t, int fd, const char *path, long long bytes) {
    TIFFOpenOptions *options = TIFFOpenOptionsAlloc();
    if (!options) return NULL;
    TIFFOpenOptionsSetErrorHandlerExtR(options, keep_error, t);
    TIFFOpenOptionsSetWarningHandlerExtR(options, keep_warning, t);
    TIFFOpenOptionsSetMaxSingleMemAlloc(options, (tmsize_t)(4 * bytes + PIECE_MAX)); /* whatever a header says */
    TIFF *file = TIFFFdOpenExt(fd, path, "rm", options); /* no mapping: a file cut off meanwhile would be a signal */
    TIFFOpenOptionsFree(options);
    return file;
}

int image_tiff_open(struct image_source *s, const struct files_image_input *input) {
    long long bytes;
    const int fd = image_source_file(s, input->file, &bytes);
    if (fd < 0) return 1;
    struct tiff *t = image_source_new(1, sizeof *t);
    t->open = -1;
    if (!(t->file = open_tiff(t, fd, input->file, bytes))) {
        image_source_refuse(s, "it is not a TIFF that can be read: %s", t->error[0] ? t->error : "no memory left");
        close(fd);
        free(t);
        return 1;
    }
    s->file = t;
    s->read = read_box;
    s->close = close_file;
    if (image_tiff_pages_find(s, t, bytes)) return 1;
    return t->slices ? open_slices(s, input->file, bytes) : choose_block(s, t);
}
