/* Text headers of images (MetaImage, NRRD): lines, words, numbers; where the voxels are. */
#pragma once
#include "base/files/image/source.h"

enum { IMAGE_HEADER_MOST = 1 << 20, IMAGE_HEADER_LINE = 1024 };

struct image_header {
    enum files_image_order order; /* automatic: not said */
    char data[IMAGE_HEADER_LINE]; /* file of the voxels; "": this one, behind the header */
    long long skip;               /* bytes before the voxels in their file, or IMAGE_RAW_AT_END */
    long lines;                   /* to skip before these bytes */
    int is_compressed;            /* by gzip or zlib */
    size_t bytes;                 /* of the header itself */
};

struct image_header_text {
    const char *at, *end;
};

/* The text at the file's beginning, malloc'ed, at most IMAGE_HEADER_MOST bytes; NULL with a sentence. */
char *image_header_load(struct image_source *s, const char *path, size_t *bytes);
/* Copies the next line without its end, cut off where it is too long; 0 at the text's end. */
int image_header_line(struct image_header_text *text, char line[IMAGE_HEADER_LINE]);
/* Without blanks at both ends, in place. */
char *image_header_trim(char *word);
/* The index of a word in a list of n without regard to case, or -1. */
int image_header_find(const char *word, const char *const *list, int n);
/* Exactly n numbers between blanks; 0 if there are other things. */
int image_header_integers(const char *text, int n, long *value);
int image_header_numbers(const char *text, int n, double *value);
/* Metres in a unit of length ("mm", "um", "micron", ...); 0: it is none. */
double image_header_metres(const char *unit);
/* Path of h->data beside the header's file; static text is not used: `path` has room for both. Nonzero with a sentence.
 */
int image_header_path(struct image_source *s, const char *file, const char *data, char *path, size_t capacity);
/* The byte order of header and user; nonzero with a sentence where they differ. */
int image_header_order(struct image_source *s, struct image_header *h, enum files_image_order given);
