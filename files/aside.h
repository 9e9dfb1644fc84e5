/* Files that are never seen half-written: written aside as PATH.part, renamed onto PATH; synced before that, so that
 * not even a power failure harms them, unless they can be made again. */
#pragma once
#include <stddef.h>
#include <stdio.h>

struct aside {
    FILE *file; /* write here */
    char path[1024], part[1032];
    int unsynced; /* set after aside_begin, if it can be made again */
};

/* Each dies with exit code 4 and a sentence when the disk says no; the old file is then as it was. Not collective: for
 * files that one rank writes. */
void aside_begin(struct aside *a, const char *path);
void aside_end(struct aside *a);

/* 0, or errno: a finished file has its name and, if synced, its bytes and name are on the disk. Not collective. */
int aside_publish(const char *part, const char *path, int synced);
