/* The types of voxels: words, bytes, conversion. */
#pragma once
#include "base/files/image.h"

const char *image_number_word(enum files_image_type type);
int image_number_bytes(enum files_image_type type);        /* of one */
int image_number_is_swapped(enum files_image_order order); /* against this machine; automatic: little */
/* n numbers as they stand in a file, at any alignment. */
void image_number_convert(enum files_image_type type, int swapped, const void *bytes, long n, double *value);
