/* Small text files, read whole. */
#pragma once

/* The file's text, malloc'ed and ended by '\0'; NULL: the file cannot be read. Not collective. */
char *whole_new(const char *path);
