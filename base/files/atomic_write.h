/* Atomic writing: files that are never visible half-written. They are written as PATH.part, flushed to the disk and
 * renamed to PATH, so that even a power failure leaves the old file or the new one. A file that can be made again need
 * not be flushed. */
#pragma once
#include <stddef.h>
#include <stdio.h>

struct atomic_write {
    FILE *file; /* write here */
    char path[1024], part[1032];
    int unsynced; /* set after atomic_write_begin if the file can be made again: it is then not flushed */
};

/* Each of these dies with exit code 4 and one sentence if the disk refuses; the old file is then unchanged. Not
 * collective: for files that one rank writes. */
void atomic_write_begin(struct atomic_write *a, const char *path);
void atomic_write_end(struct atomic_write *a);

/* The same without an end of the program, for files that can be made again. open: PATH.part for writing, NULL: errno.
 * close: renames it to path, or removes it if bad is not 0 or the disk refuses. Returns 0, or -1 (errno). Not
 * collective. */
FILE *atomic_write_open(const char *path);
int atomic_write_close(FILE *file, const char *path, int bad);

/* Renames a finished file, and, if synced, flushes its bytes and its name to the disk. Returns 0 or errno. Not
 * collective. */
int atomic_write_publish(const char *part, const char *path, int synced);
