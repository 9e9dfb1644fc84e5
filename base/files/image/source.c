/* What the readers of images share: refusals, sizes without overflow, plain reading. */
#include "base/files/image/source.h"
#include "base/die.h"
#include "base/files/image/formats.h"

#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

void *image_source_new(size_t count, size_t size) {
    void *p = calloc(count, size);
    if (!p && count > 0) die(EXIT_CODE_FILE, "no memory left for %zu x %zu bytes of an image", count, size);
    return p;
}

int image_source_refuse(struct image_source *s, const char *format, ...) {
    va_list args;
    va_start(args, format);
    vsnprintf(s->why, sizeof s->why, format, args);
    va_end(args);
    return 1;
}

const char *image_source_size(const struct image_source *s, char text[IMAGE_SIZE_TEXT]) {
    long n[3] = {0};
    for (int f = 0; f < 3; f++) n[s->axis[f]] = s->n[f];
    snprintf(text, IMAGE_SIZE_TEXT, "%ld x %ld x %ld voxels", n[0], n[1], n[2]);
    return text;
}

int image_source_bytes(struct image_source *s, long long *bytes) {
    char size[IMAGE_SIZE_TEXT];
    *bytes = image_number_bytes(s->type);
    for (int f = 0; f < 3; f++) {
        if (s->n[f] < 1)
            return image_source_refuse(s, "it has %s: at least 1 is needed along each axis",
                                       image_source_size(s, size));
        if (__builtin_mul_overflow(*bytes, s->n[f], bytes))
            return image_source_refuse(s, "it has %s: more than a file can hold", image_source_size(s, size));
    }
    return 0;
}

static long least(long a, long b) { return a < b ? a : b; }

void image_source_block(struct image_source *s) {
    const long plane = 1 << 16;
    s->block[0] = least(s->n[0], plane);
    s->block[1] = least(s->n[1], plane / s->block[0]);
    s->block[2] = least(s->n[2], 16 * plane / (s->block[0] * s->block[1]));
}

void image_source_block_in_turn(struct image_source *s) {
    const long most = 1 << 20;
    s->block[0] = least(s->n[0], most);
    s->block[1] = least(s->n[1], most / s->block[0]);
    s->block[2] = s->block[1] < s->n[1] ? 1 : least(s->n[2], most / (s->block[0] * s->block[1]));
}

int image_source_file(struct image_source *s, const char *path, long long *bytes) {
    struct stat is;
    /* a FIFO without a writer would be waited for */
    const int fd = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (fd < 0) {
        image_source_refuse(s, "%s cannot be read: %s", s->subject, strerror(errno));
        return -1;
    }
    if (fstat(fd, &is) == 0 && S_ISREG(is.st_mode)) {
        *bytes = is.st_size;
        return fd;
    }
    image_source_refuse(s, "%s is not a regular file", s->subject);
    close(fd);
    return -1;
}

int image_source_take(struct image_source *s, int fd, long long at, void *to, size_t bytes) {
    char *next = to;
    while (bytes > 0) {
        const ssize_t got = pread(fd, next, bytes, at);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0)
            return image_source_refuse(s, "%s cannot be read at byte %lld: %s", s->subject, at, strerror(errno));
        if (got == 0) return image_source_refuse(s, "%s ends at byte %lld, before its voxels do", s->subject, at);
        next += got;
        at += got;
        bytes -= (size_t)got;
    }
    return 0;
}

char *image_source_load(struct image_source *s, const char *path, long long most, long long *bytes) {
    const int fd = image_source_file(s, path, bytes);
    if (fd < 0) return NULL;
    if (*bytes > most) *bytes = most;
    char *text = image_source_new((size_t)*bytes + 1, 1);
    const int fault = image_source_take(s, fd, 0, text, (size_t)*bytes);
    close(fd);
    if (!fault) return text;
    free(text);
    return NULL;
}
