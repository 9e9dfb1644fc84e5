/* The triangles of an STL. */
#pragma once
#include "base/files/image/source.h"

/* malloc'ed [triangles][corner][x, y, z] in the file's unit; NULL with a sentence. */
double (*image_stl_read(struct image_source *s, const char *path, int *triangles))[3][3];
/* Whether a file of so many bytes that begins with these is an STL. */
int image_stl_read_is(const char *first, size_t n, long long bytes);
