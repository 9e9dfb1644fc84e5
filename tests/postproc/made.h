/* Reading of what `frana post` has made, for its tests. */
#pragma once
#include "base/files/folder.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

/* Bytes of a file of the folder; -1: there is none. */
static inline long made_size(const char *folder, const char *file) {
    char path[FOLDER_PATH];
    struct stat is;
    return stat(folder_path(path, folder, file), &is) == 0 ? (long)is.st_size : -1;
}

/* The value of a quantity in a summary of the folder, such as post/summary.csv; NAN: it has none. */
static inline double made_value(const char *folder, const char *file, const char *quantity) {
    char path[FOLDER_PATH], line[1024], quoted[160];
    double value = NAN;
    FILE *f = fopen(folder_path(path, folder, file), "r");
    snprintf(quoted, sizeof quoted, "\"%s\",", quantity);
    while (f && fgets(line, sizeof line, f)) {
        const size_t plain = strlen(quantity);
        if (strncmp(line, quoted, plain + 3) == 0 || (strncmp(line, quantity, plain) == 0 && line[plain] == ','))
            value = strtod(strrchr(line, ',') + 1, NULL);
    }
    if (f) fclose(f);
    return value;
}
