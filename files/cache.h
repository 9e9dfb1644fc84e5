/* The user's cache folder: what makes later runs faster or better informed, and may be lost at any time. */
#pragma once

enum { CACHE_PATH = 1024 };

/* Path of a file in $XDG_CACHE_HOME/frana/ or ~/.cache/frana/; make: makes the folder. Returns 0 if there is no such
 * place. Not collective. */
int cache_path(char path[CACHE_PATH], const char *name, int make);
