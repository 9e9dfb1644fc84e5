/* The user's cache folder: what makes later runs faster or better informed, and may be lost at any time. */
#pragma once
#include <stdio.h>

enum { CACHE_PATH = 1024 };

/* Path of a file in $XDG_CACHE_HOME/frana/ or ~/.cache/frana/; make: makes the folder. Returns 0 if there is no such
 * place. Not collective. */
int cache_path(char path[CACHE_PATH], const char *name, int make);

/* A file of the folder that is written under a name of its own, which no process of any host has, and then renamed: who
 * reads or writes it meanwhile, on a host with the same home, never sees a part of it. */
struct cache_file {
    FILE *file; /* write here */
    char path[CACHE_PATH], fresh[CACHE_PATH + 8];
};
/* Returns 0 if there is no such place; nothing is to be ended then. Not collective. */
int cache_begin(struct cache_file *f, const char *name);
/* Renames the file, or removes it if it could not be written as a whole. Returns whether it was renamed. Not
 * collective. */
int cache_end(struct cache_file *f);
