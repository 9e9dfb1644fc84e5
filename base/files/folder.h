/* The run folder.  (docs/run-folder.md) */
#pragma once
#include <stddef.h>

enum { FOLDER_PATH = 1024 };

/* A file of this name in a run folder counts as a run's from now on: a new run deletes it, or moves it. name: borrowed.
 * Not collective. */
void folder_own(const char *name);
/* Makes the folder with its fields/ and checkpoint/. Dies with exit code 4 if it is not writable. Collective. */
void folder_make(const char *folder);
/* Locks the folder for this run until folder_hold_release or the end of the program, and deletes the unfinished files
 * of a killed run. Dies with exit code 4 if another run holds the folder. Does nothing if there is no such folder or if
 * this run already holds it. Collective. */
void folder_hold(const char *folder);
/* Not collective. */
void folder_hold_release(void);
/* Whether the folder contains a run: a series, a solution, a checkpoint or a field. Collective. */
int folder_has_run(const char *folder);
/* Whether the folder contains files or folders, and none that a run writes. Collective. */
int folder_is_foreign(const char *folder);
/* Moves the files and folders of a run that did not end to a new folder in it, unfinished_1 or the next number, and
 * writes its path to archive [FOLDER_PATH]. Dies with exit code 4 if that is not possible. Collective. */
void folder_archive(const char *folder, char *archive);
/* Writes folder/name to path [FOLDER_PATH]; dies with exit code 4 if it is too long. Returns path. Not collective. */
char *folder_path(char *path, const char *folder, const char *name);
/* Deletes the files that were being written when a run was killed. Collective. */
void folder_clear_parts(const char *folder);
/* Deletes the files of an earlier run: series, run.json, run.log, fields and checkpoints. Collective. */
void folder_clear(const char *folder);
/* Makes a folder and those above it that are missing; 0 or errno. Not collective. */
int folder_make_path(const char *folder);
