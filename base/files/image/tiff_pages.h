/* The pages of a TIFF: what each must be, and what they say together. Private to base/files/image/tiff*.c. */
#pragma once
#include "base/files/image/source.h"

#include <tiffio.h>

/* What all pages must share. */
struct page {
    uint32_t width, height;
    uint16_t bits, number; /* SAMPLEFORMAT_... */
};

struct tiff {
    TIFF *file;
    struct page first;
    uint64_t *at; /* [pages] bytes of the pages' directories */
    long pages;
    long slices; /* of ImageJ's, one behind the other in the only page; else 0 */
    /* of the page that is open, -1: none */
    long open;
    uint32_t next_row; /* that libtiff decodes without beginning again */
    uint32_t rows, tile[2];
    char *piece;            /* a row or a tile */
    size_t bytes, capacity; /* of it; that are allocated */
    char error[200];        /* by libtiff */
};

/* Checks the page whose directory libtiff has loaded, page k. */
int image_tiff_pages_check(struct image_source *s, struct tiff *t, long k, struct page *p);
/* Finds all pages, and type, size and voxel of the image; nonzero with a sentence. bytes: of the file. */
int image_tiff_pages_find(struct image_source *s, struct tiff *t, long long bytes);
