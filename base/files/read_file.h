/* Reads a small text file completely. */
#pragma once

/* The file's text, malloc'ed and ended by '\0'; NULL: the file cannot be read. Not collective. */
char *read_file(const char *path);
/* 1: the path is not a regular file, but a folder, or a pipe on which a reader would block. Not collective. */
int read_file_is_special(const char *path);
