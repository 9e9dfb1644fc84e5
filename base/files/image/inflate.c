/* Reads boxes of voxels that gzip or zlib compressed: from the start to the box, forwards as long as boxes follow each
 * other. */
#include "base/files/image/formats.h"

#include "base/die.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include <zlib.h>

enum { PIECE = 1 << 16, EITHER = 15 + 32 /* the largest window; the stream's head says which of the two it is */ };

struct inflated {
    int fd, swapped, is_ended;
    z_stream stream;
    long long from;      /* byte of the file at which the stream begins */
    long long next;      /* byte of the file that is read next */
    long long at;        /* uncompressed bytes that are behind */
    long long skip, end; /* uncompressed bytes before the voxels and up to their end */
    char *row;           /* rows of a block, as in the file */
    unsigned char piece[PIECE];
};

static void rewind_to_start(struct inflated *g) {
    inflateReset2(&g->stream, EITHER);
    g->stream.avail_in = 0;
    g->next = g->from;
    g->at = 0;
    g->is_ended = 0;
}

/* Reads more of the file where all that was read is used up. Returns the bytes that are there; -1 with a sentence. */
static int refill(struct image_source *s) {
    struct inflated *g = s->file;
    if (g->stream.avail_in > 0) return (int)g->stream.avail_in;
    ssize_t got;
    do got = pread(g->fd, g->piece, PIECE, g->next);
    while (got < 0 && errno == EINTR);
    if (got < 0) return image_source_refuse(s, "%s cannot be uncompressed: %s", s->subject, strerror(errno)), -1;
    g->stream.next_in = g->piece;
    g->stream.avail_in = (unsigned)got;
    g->next += got;
    return (int)got;
}

/* A file of gzip may have several parts, each with a head of its own. */
static int begins_another(struct image_source *s) {
    struct inflated *g = s->file;
    if (refill(s) <= 0 || g->stream.next_in[0] != 0x1f) return 0;
    inflateReset(&g->stream);
    g->is_ended = 0;
    return 1;
}

/* The next bytes, fewer at the end. Returns how many; -1 with a sentence. */
static long long next_bytes(struct image_source *s, void *to, long long bytes) {
    struct inflated *g = s->file;
    g->stream.next_out = to;
    g->stream.avail_out = (unsigned)bytes;
    while (g->stream.avail_out > 0 && (!g->is_ended || begins_another(s))) {
        const int has = refill(s);
        if (has < 0) return -1;
        if (has == 0) break;
        const int code = inflate(&g->stream, Z_NO_FLUSH);
        g->is_ended = code == Z_STREAM_END;
        if (code != Z_OK && code != Z_STREAM_END && code != Z_BUF_ERROR)
            return image_source_refuse(s, "%s cannot be uncompressed: %s", s->subject,
                                       g->stream.msg ? g->stream.msg : zError(code)),
                   -1;
    }
    g->at += bytes - g->stream.avail_out;
    return bytes - g->stream.avail_out;
}

static int skip_to(struct image_source *s, long long at) {
    struct inflated *g = s->file;
    char lost[PIECE];
    if (at < g->at) rewind_to_start(g);
    while (g->at < at) {
        const long long got = next_bytes(s, lost, at - g->at < PIECE ? at - g->at : PIECE);
        if (got < 0) return 1;
        if (got == 0) break;
    }
    return 0;
}

/* Behind the last voxel the end must follow, whose checksum zlib compares. */
static int take(struct image_source *s, long long at, char *to, long long bytes) {
    const struct inflated *g = s->file;
    char more;
    if (skip_to(s, at)) return 1;
    const long long got = g->at == at ? next_bytes(s, to, bytes) : 0;
    if (got < 0) return 1;
    if (got < bytes) return image_source_refuse(s, "%s ends before its voxels do", s->subject);
    if (at + bytes < g->end) return 0;
    const long long extra = next_bytes(s, &more, 1);
    if (extra < 0) return 1;
    if (extra > 0) return image_source_refuse(s, "%s has more bytes than its voxels", s->subject);
    return g->is_ended ? 0 : image_source_refuse(s, "%s ends before its checksum", s->subject);
}

static int read_box(struct image_source *s, const long low[3], const long high[3], double *value) {
    const struct inflated *g = s->file;
    const int bytes = image_number_bytes(s->type);
    const long n = high[0] - low[0], rows = n == s->n[0] ? high[1] - low[1] : 1; /* at once */
    for (long k = low[2]; k < high[2]; k++)
        for (long j = low[1]; j < high[1]; j += rows, value += rows * n) {
            const long long first = ((long long)k * s->n[1] + j) * s->n[0] + low[0];
            if (take(s, g->skip + first * bytes, g->row, (long long)rows * n * bytes)) return 1;
            image_number_convert(s->type, g->swapped, g->row, rows * n, value);
        }
    return 0;
}

static void close_file(struct image_source *s) {
    struct inflated *g = s->file;
    close(g->fd);
    inflateEnd(&g->stream);
    free(g->row);
    free(g);
}

/* Whether the file has the head of gzip or of zlib (method 8, and a multiple of 31). */
static int is_compressed(struct image_source *s) {
    const struct inflated *g = s->file;
    if (refill(s) < 2) return 0;
    const unsigned char *head = g->stream.next_in;
    return (head[0] == 0x1f && head[1] == 0x8b) || ((head[0] & 15) == 8 && (256 * head[0] + head[1]) % 31 == 0);
}

int image_inflate_open(struct image_source *s, const char *path, long long at, long long skip,
                       enum files_image_order order) {
    /* the least part of its bytes to which deflate compresses anything is a 1032nd (zlib.net/zlib_tech.html) */
    const long long most = 1032;
    long long bytes, whole;
    if (image_source_bytes(s, &bytes)) return 1;
    if (__builtin_add_overflow(bytes, skip, &whole))
        return image_source_refuse(s, "its header has byte skip: %lld, more than a file can hold", skip);
    image_source_block_in_turn(s);
    const int fd = image_source_file(s, path, &whole);
    if (fd < 0) return 1;
    struct inflated *g = image_source_new(1, sizeof *g);
    g->row = image_source_new((size_t)(s->block[0] * s->block[1]), (size_t)image_number_bytes(s->type));
    if (inflateInit2(&g->stream, EITHER) != Z_OK) die(EXIT_CODE_FILE, "no memory left to uncompress an image");
    g->fd = fd;
    g->swapped = image_number_is_swapped(order);
    g->from = g->next = at;
    g->skip = skip;
    g->end = bytes + skip;
    s->file = g;
    s->read = read_box;
    s->close = close_file;
    if (!is_compressed(s))
        return image_source_refuse(s, "%s is not compressed by gzip or zlib, as its header says", s->subject);
    if (g->end / most <= whole) return 0;
    char size[IMAGE_SIZE_TEXT];
    return image_source_refuse(s, "its header says %s, and the %lld bytes of %s cannot hold them",
                               image_source_size(s, size), whole, s->subject);
}
