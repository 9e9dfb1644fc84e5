/* The seal of a finished checkpoint: a record appended to the HDF5 file, which HDF5 does not read. It holds the length
 * of the file, the positions of its arrays, a checksum of each array and one of all other bytes. Any later change of
 * the file is found before HDF5 opens the file.
 *
 * A checksum is the sum, modulo 2^64, of mix(i, w) over the words w of eight bytes, i counted through the whole array.
 * The order of the sum does not matter, so the result is the same on any number of ranks. mix maps different w to
 * different numbers, so one changed word is always found; several changed words go unnoticed once in 2^64. mix is the
 * finalizer of SplitMix64 (Steele, Lea, Flood 2014). */
#pragma once
#include <stddef.h>
#include <stdint.h>
#include <sys/types.h>

enum { SEAL_ARRAYS = 32, SEAL_NAME = 32 };
/* 1: no seal. 2: particles numbered along a space-filling curve. 3: by halves (solid/geometry/bisect.h). Arrays by
 * particle hold no places, so a change of the numbers needs a new format. */
enum { SEAL_FORMAT = 4 };

/* An array of the file: contiguous rows of so many bytes; each row begins with a new word. */
struct seal_array {
    char name[SEAL_NAME];
    uint64_t at, bytes, row, sum; /* at: from the start of the file */
};

struct seal {
    struct seal_array array[SEAL_ARRAYS];
    uint64_t arrays, bytes; /* bytes: of the file without the seal */
    uint64_t rest;          /* checksum of the bytes outside the arrays */
    uint64_t own;           /* checksum of the seal's members above */
    uint64_t format;
    char magic[16];
};

/* The contribution of these rows to an array's checksum; the first of them is the array's row number first. */
uint64_t seal_sum(const void *value, size_t rows, size_t row, uint64_t first);

/* Adds an array that has been written to the seal. */
void seal_add(struct seal *seal, const char *name, uint64_t at, uint64_t bytes, uint64_t row, uint64_t sum);
const struct seal_array *seal_find(const struct seal *seal, const char *name); /* NULL: no array of that name */

/* Appends the seal to a file of so many bytes; cuts off anything after them. Returns 0 or errno. */
int seal_file_write(struct seal *seal, const char *path, uint64_t bytes);

/* Each returns 0, or 1 with a sentence in why. seal_file_read checks everything but the arrays' values; seal_file_check
 * checks these too. */
int seal_file_read(struct seal *seal, const char *path, char *why, size_t size);
int seal_file_check(const char *path, char *why, size_t size);

/* Checksums of one part of each array, from the file: part number `part` of `parts`. The parts' checksums add up to the
 * array's. Returns 0, or 1 if the file cannot be read. */
int seal_file_sum_part(const struct seal *seal, const char *path, int part, int parts, uint64_t sum[SEAL_ARRAYS]);
