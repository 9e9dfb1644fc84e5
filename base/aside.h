/* Small files that are never seen half-written: written aside as PATH.part, synced, renamed onto PATH. */
#pragma once
#include <stddef.h>
#include <stdio.h>

struct aside {
    FILE *file; /* write here */
    char path[1024], part[1032];
};

/* Each dies with exit code 4 and a sentence when the disk says no; the old file is then as it was. Not collective: for
 * files that one rank writes. */
void aside_begin(struct aside *a, const char *path);
void aside_end(struct aside *a);

/* 0, or errno: a finished file's bytes and its name are on the disk. Not collective. */
int aside_publish(const char *part, const char *path);
