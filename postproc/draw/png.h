/* A PNG file from 8-bit RGB. */
#pragma once

/* rgb [height][width][3], top row first. Returns 0, or -1 when the file could not be written (errno says why). */
int postproc_png_write(const char *path, int width, int height, const unsigned char *rgb);
