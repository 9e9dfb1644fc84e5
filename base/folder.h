/* The run folder.  (docs/run-folder.md) */
#pragma once
#include <stddef.h>

enum { FOLDER_PATH = 1024 };

/* Makes the folder and its fields/ and checkpoint/. Dies with exit code 4 where it cannot be written. Collective. */
void folder_make(const char *folder);
/* Whether it holds a run already: a series, a checkpoint or a field. Collective. */
int folder_has_run(const char *folder);
/* folder/name into path [FOLDER_PATH]; dies with exit code 4 when that is too long. Returns path. Not collective. */
char *folder_path(char *path, const char *folder, const char *name);
/* Forgets what an earlier run left in the folder: series, run.json, run.log, fields and checkpoints. Collective. */
void folder_clear(const char *folder);
