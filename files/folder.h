/* The run folder.  (docs/run-folder.md) */
#pragma once
#include <stddef.h>

enum { FOLDER_PATH = 1024 };

/* Makes the folder and its fields/ and checkpoint/. Dies with exit code 4 where it cannot be written. Collective. */
void folder_make(const char *folder);
/* Holds the folder for this run until folder_hold_release or the program's end, and forgets what a killed run left
 * unfinished. Dies with exit code 4 where another run is at work there; does nothing where there is no such folder, or
 * it is held. Collective. */
void folder_hold(const char *folder);
/* Not collective. */
void folder_hold_release(void);
/* Whether it holds a run already: a series, a checkpoint or a field. Collective. */
int folder_has_run(const char *folder);
/* folder/name into path [FOLDER_PATH]; dies with exit code 4 when that is too long. Returns path. Not collective. */
char *folder_path(char *path, const char *folder, const char *name);
/* Forgets files that were being written when a run was killed. Collective. */
void folder_clear_parts(const char *folder);
/* Forgets what an earlier run left in the folder: series, run.json, run.log, fields and checkpoints. Collective. */
void folder_clear(const char *folder);
/* Makes a folder and those above it that are missing; 0 or errno. Not collective. */
int folder_make_path(const char *folder);
