/* Writes and checks the seal of a checkpoint: checksums and positions of all its arrays. */
#include "base/files/seal.h"
#include "base/files/read_file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { CHUNK = 1 << 16 }; /* bytes read at a time, and the longest row */

static const char magic[16] = "frana checkpoint"; /* without its terminating zero */

static uint64_t own_sum(const struct seal *seal) { return seal_sum(seal, 1, offsetof(struct seal, own), 0); }

/* 0, or 1 if the file ends too early. */
static int read_all(int fd, void *to, size_t bytes, uint64_t at) {
    char *next = to;
    while (bytes > 0) {
        const ssize_t got = pread(fd, next, bytes, (off_t)at);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return 1;
        next += got;
        at += (uint64_t)got;
        bytes -= (size_t)got;
    }
    return 0;
}

/* Checksum of rows in the file. Returns 0, or 1 if they cannot be read. */
static int sum_in_file(int fd, uint64_t at, uint64_t bytes, uint64_t row, uint64_t first, uint64_t *sum) {
    char *chunk = malloc(CHUNK);
    int bad = !chunk;
    const uint64_t most = CHUNK / row;
    for (uint64_t rows = bytes / row; rows > 0 && !bad;) {
        const uint64_t now = rows < most ? rows : most;
        bad = read_all(fd, chunk, now * row, at);
        if (!bad) *sum += seal_sum(chunk, now, row, first);
        at += now * row;
        first += now;
        rows -= now;
    }
    free(chunk);
    return bad;
}

static int by_place(const void *a, const void *b) {
    const struct seal_array *p = a, *q = b;
    return p->at < q->at ? -1 : p->at > q->at;
}

/* Checksum of the bytes outside the arrays; each byte counts as a row, numbered by its position. Returns 1 if they
 * cannot be read or if arrays overlap. */
static int sum_rest(int fd, const struct seal *seal, uint64_t *sum) {
    struct seal_array a[SEAL_ARRAYS];
    uint64_t at = 0;
    int bad = 0;
    memcpy(a, seal->array, sizeof a);
    qsort(a, seal->arrays, sizeof *a, by_place);
    *sum = 0;
    for (uint64_t k = 0; k <= seal->arrays && !bad; k++) {
        const uint64_t end = k < seal->arrays ? a[k].at : seal->bytes;
        bad = end < at || end > seal->bytes || sum_in_file(fd, at, end - at, 1, at, sum);
        if (bad || k == seal->arrays) break;
        bad = a[k].row < 1 || a[k].row > CHUNK || a[k].bytes % a[k].row != 0 || a[k].bytes > seal->bytes;
        at = end + a[k].bytes;
    }
    return bad;
}

int seal_file_write(struct seal *seal, const char *path, uint64_t bytes) {
    const int fd = open(path, O_RDWR | O_CLOEXEC);
    if (fd < 0) return errno;
    seal->bytes = bytes;
    int code = sum_rest(fd, seal, &seal->rest) ? EIO : 0;
    seal->own = own_sum(seal);
    seal->format = SEAL_FORMAT;
    memcpy(seal->magic, magic, sizeof magic);
    errno = 0;
    if (!code && pwrite(fd, seal, sizeof *seal, (off_t)bytes) != (ssize_t)sizeof *seal) code = errno ? errno : ENOSPC;
    if (!code && ftruncate(fd, (off_t)(bytes + sizeof *seal)) != 0) code = errno;
    close(fd);
    return code;
}

__attribute__((format(printf, 3, 4))) static int refuse(char *why, size_t size, const char *format, ...) {
    va_list args;
    va_start(args, format);
    vsnprintf(why, size, format, args);
    va_end(args);
    return 1;
}

/* Says why a file has no seal: it is not a file of frana, it is of an earlier version, or its end is missing. The first
 * bytes of HDF5's superblock of version 0 are its signature and version; the file's end is given at byte 40. */
static int refuse_unsealed(int fd, uint64_t bytes, char *why, size_t size) {
    static const char signature[8] = "\211HDF\r\n\032\n";
    char begin[48] = {0};
    uint64_t end;
    if (read_all(fd, begin, 8, 0) || memcmp(begin, signature, 8) != 0)
        return refuse(why, size, "it is not an HDF5 file");
    const int cut = read_all(fd, begin, sizeof begin, 0);
    memcpy(&end, begin + 40, sizeof end);
    if (!cut && begin[8] == 0 && end == bytes)
        return refuse(why, size,
                      "it has no seal: it is not a checkpoint, or was written by an earlier version of frana "
                      "(format 1, without checksums; this one reads format %d)",
                      SEAL_FORMAT);
    return refuse(why, size, "it is truncated or damaged");
}

static int read_open(struct seal *seal, int fd, char *why, size_t size) {
    struct stat is;
    uint64_t rest;
    if (fstat(fd, &is) != 0) return refuse(why, size, "%s", strerror(errno));
    if (!S_ISREG(is.st_mode)) return refuse(why, size, "it is not a file");
    const uint64_t bytes = (uint64_t)is.st_size;
    if (bytes < sizeof *seal || read_all(fd, seal, sizeof *seal, bytes - sizeof *seal) ||
        memcmp(seal->magic, magic, sizeof magic) != 0)
        return refuse_unsealed(fd, bytes, why, size);
    if (seal->format != SEAL_FORMAT && seal->own == own_sum(seal))
        return refuse(why, size, "it is of format %llu, this frana reads format %d", (unsigned long long)seal->format,
                      SEAL_FORMAT);
    if (seal->format != SEAL_FORMAT || seal->own != own_sum(seal) || seal->arrays > SEAL_ARRAYS ||
        seal->bytes != bytes - sizeof *seal)
        return refuse(why, size, "it is damaged: its last bytes are not what was written");
    for (uint64_t k = 0; k < seal->arrays; k++) seal->array[k].name[SEAL_NAME - 1] = '\0';
    if (sum_rest(fd, seal, &rest) || rest != seal->rest)
        return refuse(why, size, "it is damaged: its headers are not what was written");
    return 0;
}

int seal_file_read(struct seal *seal, const char *path, char *why, size_t size) {
    if (read_file_is_special(path)) return refuse(why, size, "it is not a file");
    const int fd = open(path, O_RDONLY | O_CLOEXEC);
    if (fd < 0) return refuse(why, size, "%s", strerror(errno));
    const int bad = read_open(seal, fd, why, size);
    close(fd);
    return bad;
}

int seal_file_sum_part(const struct seal *seal, const char *path, int part, int parts, uint64_t sum[SEAL_ARRAYS]) {
    const int fd = open(path, O_RDONLY | O_CLOEXEC);
    int bad = fd < 0;
    for (uint64_t k = 0; k < seal->arrays && !bad; k++) {
        const struct seal_array *a = &seal->array[k];
        const uint64_t rows = a->bytes / a->row, first = rows / (uint64_t)parts * (uint64_t)part,
                       end = part + 1 < parts ? first + rows / (uint64_t)parts : rows;
        sum[k] = 0;
        bad = sum_in_file(fd, a->at + first * a->row, (end - first) * a->row, a->row, first, &sum[k]);
    }
    if (fd >= 0) close(fd);
    return bad;
}

int seal_file_check(const char *path, char *why, size_t size) {
    struct seal seal;
    uint64_t sum[SEAL_ARRAYS];
    if (seal_file_read(&seal, path, why, size)) return 1;
    if (seal_file_sum_part(&seal, path, 0, 1, sum)) return refuse(why, size, "it cannot be read");
    for (uint64_t k = 0; k < seal.arrays; k++)
        if (sum[k] != seal.array[k].sum) return refuse(why, size, "its array %s is damaged", seal.array[k].name);
    return 0;
}
