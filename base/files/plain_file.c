/* Opens regular files alone, neither through symbolic links nor pipes and devices. */
#include "base/files/plain_file.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* Without O_NONBLOCK a pipe would be waited for. Returns -1 with ENODEV for what is not a regular file. */
static int open_regular(const char *path, int flags) {
    struct stat is;
    const int fd = open(path, flags | O_NONBLOCK | O_CLOEXEC, 0666);
    if (fd < 0 && errno == ENXIO) errno = ENODEV; /* a pipe that nobody reads */
    if (fd < 0 || (fstat(fd, &is) == 0 && S_ISREG(is.st_mode))) return fd;
    close(fd);
    errno = S_ISDIR(is.st_mode) ? EISDIR : ENODEV;
    return -1;
}

static FILE *stream(int fd, const char *mode) {
    FILE *file = fd < 0 ? NULL : fdopen(fd, mode);
    if (fd >= 0 && !file) close(fd);
    return file;
}

FILE *plain_file_read(const char *path) { return stream(open_regular(path, O_RDONLY), "r"); }

FILE *plain_file_write(const char *path, int append) {
    FILE *file =
        stream(open_regular(path, O_WRONLY | O_CREAT | O_NOFOLLOW | (append ? O_APPEND : 0)), append ? "a" : "w");
    if (file && !append && ftruncate(fileno(file), 0) != 0) { /* only once it is known to be a file */
        const int fault = errno;
        fclose(file);
        errno = fault;
        return NULL;
    }
    return file;
}

int plain_file_create(const char *path) {
    if (unlink(path) != 0 && errno != ENOENT) return -1;
    return open(path, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
}

const char *plain_file_why(int fault) {
    return fault == ELOOP    ? "it is a symbolic link, through which nothing is written"
           : fault == ENODEV ? "it is not a regular file"
                             : strerror(fault);
}
