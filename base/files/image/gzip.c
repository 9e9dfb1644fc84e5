/* Reads boxes of voxels that gzip compressed: from the start to the box, forwards as long as boxes follow each other.
 */
#include "base/files/image/gzip.h"
#include "base/files/image/number.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include <zlib.h>

struct gzip {
    gzFile file;
    int swapped;
    long long skip, end; /* uncompressed bytes before the voxels and up to their end */
    char *row;           /* rows of a block, as in the file */
};

static int refuse(struct image_source *s) {
    const struct gzip *g = s->file;
    int code;
    const char *why = gzerror(g->file, &code);
    if (code == Z_OK || code == Z_BUF_ERROR) return image_source_refuse(s, "%s ends before its voxels do", s->subject);
    const char *colon = strstr(why, ": "); /* "<fd:3>: ..." */
    return image_source_refuse(s, "%s cannot be uncompressed: %s", s->subject,
                               code == Z_ERRNO ? strerror(errno)
                               : colon         ? colon + 2
                                               : why);
}

/* Behind the last voxel the end must follow, whose checksum zlib compares. */
static int take(struct image_source *s, long long at, char *to, long long bytes) {
    const struct gzip *g = s->file;
    char more;
    if (gzseek(g->file, at, SEEK_SET) != at || gzread(g->file, to, (unsigned)bytes) != bytes) return refuse(s);
    if (at + bytes < g->end) return 0;
    const int extra = gzread(g->file, &more, 1);
    if (extra == 0) return 0;
    return extra < 0 ? refuse(s) : image_source_refuse(s, "%s has more bytes than its voxels", s->subject);
}

static int read_box(struct image_source *s, const long low[3], const long high[3], double *value) {
    const struct gzip *g = s->file;
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
    struct gzip *g = s->file;
    gzclose(g->file);
    free(g->row);
    free(g);
}

int image_gzip_open(struct image_source *s, const char *path, long long at, long long skip,
                    enum files_image_order order) {
    long long bytes, whole;
    if (image_source_bytes(s, &bytes)) return 1;
    if (__builtin_add_overflow(bytes, skip, &whole))
        return image_source_refuse(s, "its header has byte skip: %lld, more than a file can hold", skip);
    image_source_block_in_turn(s);
    const int fd = image_source_file(s, path, &whole);
    if (fd < 0) return 1;
    struct gzip *g = calloc(1, sizeof *g);
    char *row = malloc((size_t)(s->block[0] * s->block[1] * image_number_bytes(s->type)));
    gzFile file = g && row && lseek(fd, at, SEEK_SET) == at ? gzdopen(fd, "rb") : NULL;
    if (!file) {
        close(fd);
        free(g);
        free(row);
        return image_source_refuse(s, "no memory left to read it");
    }
    *g = (struct gzip){
        .file = file, .swapped = image_number_is_swapped(order), .skip = skip, .end = bytes + skip, .row = row};
    s->file = g;
    s->read = read_box;
    s->close = close_file;
    if (!gzdirect(file)) return 0;
    return image_source_refuse(s, "%s is not compressed by gzip, as its header says", s->subject);
}
