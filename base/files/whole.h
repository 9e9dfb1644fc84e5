/* Small text files, read whole. */
#pragma once

/* The file's text, malloc'ed and ended by '\0'; NULL: the file cannot be read. Not collective. */
char *whole_new(const char *path);
/* 1: the path is something else than a file, as a folder or a pipe, for which one would wait. Not collective. */
int whole_is_no_file(const char *path);
