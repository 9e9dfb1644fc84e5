/* Reading of gnuplot's scripts, for tests of the charts. */
#pragma once
#include "base/files/folder.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Whether the script NAME.gp of a folder has the words. */
static inline int script_says(const char *folder, const char *name, const char *words) {
    char path[FOLDER_PATH], file[64], *line = NULL;
    size_t bytes = 0;
    snprintf(file, sizeof file, "%s.gp", name);
    FILE *f = fopen(folder_path(path, folder, file), "r");
    int found = 0;
    while (f && getline(&line, &bytes, f) > 0) found |= strstr(line, words) != NULL;
    if (f) fclose(f);
    free(line);
    return found;
}
