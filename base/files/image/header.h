/* Text headers of images (MetaImage, NRRD): lines, words, numbers; where the voxels are. */
#pragma once
#include "base/files/image/source.h"

enum { IMAGE_HEADER_MAX = 1 << 20, IMAGE_HEADER_LINE = 1024 };

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

/* Copies the next line without its end, cut off where it is too long; 0 at the text's end. */
int image_header_line(struct image_header_text *text, char line[IMAGE_HEADER_LINE]);
/* Without blanks at both ends, in place. */
char *image_header_trim(char *word);
/* The index of a word in a list of n without regard to case, or -1. */
int image_header_find(const char *word, const char *const *list, int n);
/* Whether the words, each between bars as in "|um|micron|", have this one, without regard to case. */
int image_header_has(const char *words, const char *word);
/* Takes `key = value` apart at the sign (NULL: none) and keeps the value of a key that is one of the words: value [n],
 * "" where not given. *k: its index, -1: another key. Nonzero with a sentence for one that is given twice. */
int image_header_take(struct image_source *s, char *line, char *sign, int n, const char *const *word,
                      char (*value)[IMAGE_HEADER_LINE], int *k);
/* Exactly n numbers between blanks; 0 if there are other things. */
int image_header_integers(const char *text, int n, long *value);
int image_header_numbers(const char *text, int n, double *value);
/* Metres in a unit of length ("mm", "um", "micron", ...); 0: it is none. */
double image_header_metres(const char *unit);
/* Reads a header from memory: n, type, voxel and unit of s, and where the voxels are; nonzero with a sentence. */
typedef int image_header_parse(struct image_source *s, const char *text, size_t bytes, struct image_header *h);
/* Opens the file of the voxels. */
typedef int image_header_data(struct image_source *s, const char *path, const struct image_header *h);
/* Opens an image by its header, with its voxels in the same file or in another one. */
int image_header_open(struct image_source *s, const struct files_image_input *input, image_header_parse *parse,
                      image_header_data *data);
