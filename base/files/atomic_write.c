/* Writes a file under a temporary name and renames it once it is complete and on disk. */
#include "base/files/atomic_write.h"
#include "base/die.h"
#include "base/unfinished.h"
#include "base/files/plain_file.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <unistd.h>

static int sync_path(const char *path, int flags) {
    const int fd = open(path, flags | O_CLOEXEC);
    if (fd < 0) return errno;
    const int fault = fsync(fd) == 0 ? 0 : errno;
    close(fd);
    return fault;
}

/* The folder that holds the file at the path. */
static void parent(char *folder, size_t bytes, const char *path) {
    const char *slash = strrchr(path, '/');
    if (!slash)
        snprintf(folder, bytes, ".");
    else
        snprintf(folder, bytes, "%.*s", slash == path ? 1 : (int)(slash - path), path);
}

int atomic_write_publish(const char *part, const char *path, int synced) {
    char folder[1024];
    const int fault = synced ? sync_path(part, O_RDONLY) : 0;
    if (fault) return fault;
    if (rename(part, path) != 0) return errno;
    unfinished_drop(part);
    if (!synced) return 0;
    parent(folder, sizeof folder, path);
    const int named = sync_path(folder, O_RDONLY | O_DIRECTORY);
    return named == EINVAL ? 0 : named; /* some file systems cannot flush a folder */
}

void atomic_write_begin(struct atomic_write *a, const char *path) {
    if (strlen(path) >= sizeof a->path) die(EXIT_CODE_FILE, "%s: the name is too long", path);
    snprintf(a->path, sizeof a->path, "%s", path);
    snprintf(a->part, sizeof a->part, "%s.part", path);
    a->unsynced = 0;
    unfinished_add(a->part);
    const int fd = plain_file_create(a->part);
    a->file = fd < 0 ? NULL : fdopen(fd, "w");
    if (!a->file) die(EXIT_CODE_FILE, "%s: cannot be written: %s", a->part, strerror(errno));
}

void atomic_write_end(struct atomic_write *a) {
    int fault = ferror(a->file) ? EIO : 0;
    errno = 0;
    if (fclose(a->file) != 0) fault = errno;
    if (!fault) fault = atomic_write_publish(a->part, a->path, !a->unsynced);
    if (fault) {
        unlink(a->part);
        unfinished_drop(a->part);
        die(EXIT_CODE_FILE, "%s: cannot be written: %s", a->path, strerror(fault));
    }
}

/* The path while the file is written; NULL (errno): too long. */
static const char *part_of(char part[1032], const char *path) {
    if (strlen(path) < 1024) {
        snprintf(part, 1032, "%s.part", path);
        return part;
    }
    errno = ENAMETOOLONG;
    return NULL;
}

FILE *atomic_write_open(const char *path) {
    char part[1032];
    if (!part_of(part, path)) return NULL;
    unfinished_add(part);
    const int fd = plain_file_create(part);
    return fd < 0 ? NULL : fdopen(fd, "w");
}

int atomic_write_close(FILE *file, const char *path, int bad) {
    char part[1032];
    int fault = bad || ferror(file) ? EIO : 0;
    if (fclose(file) != 0) fault = errno;
    if (!part_of(part, path)) return -1;
    if (!fault) fault = atomic_write_publish(part, path, 0);
    if (!fault) return 0;
    unlink(part);
    unfinished_drop(part);
    errno = fault;
    return -1;
}
