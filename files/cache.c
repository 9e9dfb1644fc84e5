/* Finds the user's cache folder. */
#include "files/cache.h"
#include "files/folder.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int cache_path(char path[CACHE_PATH], const char *name, int make) {
    enum { ROOM = 128 }; /* for names of files */
    const char *cache = getenv("XDG_CACHE_HOME"), *home = getenv("HOME");
    int n = -1;
    if (cache && *cache == '/')
        n = snprintf(path, CACHE_PATH, "%s/frana", cache);
    else if (home && *home == '/')
        n = snprintf(path, CACHE_PATH, "%s/.cache/frana", home);
    if (n < 0 || n >= CACHE_PATH - ROOM || strlen(name) >= ROOM - 1) return 0;
    if (make && folder_make_path(path)) return 0;
    strcat(strcat(path, "/"), name);
    return 1;
}
