/* Finds the user's cache folder, and writes files there. */
#include "base/files/cache.h"
#include "base/files/folder.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

int cache_path(char path[CACHE_PATH], const char *name, int make) {
    enum { NAME_BYTES = 128 }; /* for the name of a file in the cache */
    const char *cache = getenv("XDG_CACHE_HOME"), *home = getenv("HOME");
    int n = -1;
    if (cache && *cache == '/')
        n = snprintf(path, CACHE_PATH, "%s/frana", cache);
    else if (home && *home == '/')
        n = snprintf(path, CACHE_PATH, "%s/.cache/frana", home);
    if (n < 0 || n >= CACHE_PATH - NAME_BYTES || strlen(name) >= NAME_BYTES - 1) return 0;
    if (make && folder_make_path(path)) return 0;
    strcat(strcat(path, "/"), name);
    return 1;
}

int cache_begin(struct cache_file *f, const char *name) {
    if (!cache_path(f->path, name, 1)) return 0;
    snprintf(f->fresh, sizeof f->fresh, "%s.XXXXXX", f->path);
    const int made = mkstemp(f->fresh);
    if (made < 0) return 0;
    f->file = fdopen(made, "w");
    if (f->file) return 1;
    close(made);
    unlink(f->fresh);
    return 0;
}

int cache_end(struct cache_file *f) {
    const int bad = ferror(f->file);
    const int renamed = fclose(f->file) == 0 && !bad && rename(f->fresh, f->path) == 0;
    if (!renamed) unlink(f->fresh);
    return renamed;
}
