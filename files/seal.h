/* The seal of a finished checkpoint: a record behind the file's own end, which HDF5 does not look at. It says how long
 * the file is, where its arrays stand, and holds a sum of each array and one of all other bytes, so that whatever has
 * changed since is found, and found before HDF5 is given the file.
 *
 * A sum is that of mix(i, w) over the words w of eight bytes, i counted through the whole array, modulo 2^64: the order
 * does not matter, so any ranks make the same one. mix takes different w to different numbers, so one word that has
 * changed always shows; several hide each other once in 2^64. It is the finalizer of SplitMix64 (Steele, Lea, Flood
 * 2014). */
#pragma once
#include <stddef.h>
#include <stdint.h>
#include <sys/types.h>

enum { SEAL_ARRAYS = 32, SEAL_NAME = 32, SEAL_FORMAT = 2 }; /* format 1 had no seal */

/* An array of the file: contiguous rows of so many bytes, each begun with a new word. */
struct seal_array {
    char name[SEAL_NAME];
    uint64_t at, bytes, row, sum; /* at: from the file's begin */
};

struct seal {
    struct seal_array array[SEAL_ARRAYS];
    uint64_t arrays, bytes; /* bytes: of the file without the seal */
    uint64_t rest;          /* sum of what stands outside the arrays */
    uint64_t own;           /* sum of all above */
    uint64_t format;
    char magic[16];
};

/* The part of an array's sum that comes from these rows, of which the first is the array's first-th. */
uint64_t seal_sum(const void *value, size_t rows, size_t row, uint64_t first);

/* Notes an array that has been written. */
void seal_add(struct seal *seal, const char *name, uint64_t at, uint64_t bytes, uint64_t row, uint64_t sum);
const struct seal_array *seal_find(const struct seal *seal, const char *name); /* NULL: none */

/* Ends a file of so many bytes with the seal; cuts off what stood behind them. 0, or errno. */
int seal_file_write(struct seal *seal, const char *path, uint64_t bytes);

/* Each 0, or 1 and a sentence on the file. seal_file_read looks at everything but the arrays' values, seal_file_check
 * at these too. */
int seal_file_read(struct seal *seal, const char *path, char *why, size_t size);
int seal_file_check(const char *path, char *why, size_t size);

/* The sums of the part-th of so many parts of each array, as the file has it; they add up to the arrays'. 0, or 1 where
 * it cannot be read. */
int seal_file_sum_part(const struct seal *seal, const char *path, int part, int parts, uint64_t sum[SEAL_ARRAYS]);
