/* Allocation, counted by part of the program, aligned to 64 bytes; large arrays ask for huge pages. */
#pragma once
#include <stddef.h>

enum memory_part { MEMORY_FLUID, MEMORY_SOLID, MEMORY_IBM, MEMORY_COUPLING, MEMORY_OUTPUT, MEMORY_PARTS };

/* Zeroed. Dies with exit code 4 when there is no memory left. Not collective. */
void *memory_new(enum memory_part part, size_t count, size_t size);
/* Scratch: NaN-filled in debug builds, zeroed (touched) otherwise. Not collective. */
double *memory_new_work(enum memory_part part, size_t count);
/* A copy of n items of `size` bytes, with room for one more. from may be NULL where n is 0. Not collective. */
void *memory_copy(enum memory_part part, const void *from, size_t n, size_t size);
/* An array of `capacity` items, of which the first `used` are those of old (may be NULL), which is freed.
 * Not collective. */
void *memory_grown(enum memory_part part, void *old, size_t used, size_t capacity, size_t size);
/* Makes room for one more item in a list of n, by doubling: list and capacity are set. Not collective. */
#define MEMORY_MORE(part, list, n, capacity)                                                                           \
    do {                                                                                                               \
        if ((n) < (capacity)) break;                                                                                   \
        (capacity) = 2 * (capacity) + 64;                                                                              \
        (list) = memory_grown(part, list, (size_t)(n), (size_t)(capacity), sizeof *(list));                            \
    } while (0)
/* The same as memory_grown without keeping what old held. Not collective. */
void *memory_renew(enum memory_part part, void *old, size_t capacity, size_t size);
void memory_free(void *p);
/* Frees several allocations, in the order in which they stand: MEMORY_FREE(a, b, c). Not collective. */
#define MEMORY_FREE(...)                                                                                               \
    memory_free_all((void *const[]){__VA_ARGS__}, sizeof(void *const[]){__VA_ARGS__} / sizeof(void *))
void memory_free_all(void *const *list, size_t n);
/* Counts bytes that were not allocated here, or, with a minus, that were given back. Not collective. */
void memory_count(enum memory_part part, long bytes);
size_t memory_bytes(enum memory_part part);      /* now held by this rank */
size_t memory_high_water(enum memory_part part); /* the most that it held since the last call */
size_t memory_peak(void);                        /* the process's largest resident size, bytes */
const char *memory_name(enum memory_part part);
