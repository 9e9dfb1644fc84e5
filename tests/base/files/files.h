/* A folder of its own for each test program and number of ranks. */
#pragma once
#include "base/par.h"
#include "base/files/folder.h"

#include <stdio.h>
#include <sys/stat.h>

static inline const char *files_folder(const char *test) {
    static char folder[FOLDER_PATH];
    snprintf(folder, sizeof folder, "%s/files/%s_%d", FRANA_BINARY_DIR, test, par_size());
    folder_make(folder);
    folder_clear(folder);
    return folder;
}

static inline int files_exists(const char *path) {
    struct stat is;
    return stat(path, &is) == 0;
}

/* Splits n items unevenly over the ranks; with two or more ranks, the given rank (counted from the end) gets none. */
static inline void files_split(long n, int empty, long *first, long *count) {
    const int size = par_size(), rank = par_rank(), bare = size > 1 ? size - 1 - empty % size : -1;
    long weight[64], all = 0, before = 0;
    for (int r = 0; r < size; r++) all += weight[r] = r == bare ? 0 : 1 + (r + empty) % 3;
    for (int r = 0; r < rank; r++) before += weight[r];
    *first = n * before / all;
    *count = n * (before + weight[rank]) / all - *first;
}
