/* Allocation, counted by part of the program, aligned to 64 bytes; large arrays ask for huge pages. */
#pragma once
#include <stddef.h>

enum memory_part { MEMORY_FLUID, MEMORY_SOLID, MEMORY_IBM, MEMORY_COUPLING, MEMORY_OUTPUT, MEMORY_PARTS };

/* Zeroed. Dies with exit code 4 when there is no memory left. Not collective. */
void *memory_new(enum memory_part part, size_t count, size_t size);
/* Scratch: NaN-filled in debug builds, zeroed (touched) otherwise. Not collective. */
double *memory_new_work(enum memory_part part, size_t count);
void memory_free(void *p);
size_t memory_bytes(enum memory_part part); /* now held by this rank */
size_t memory_peak(void);                   /* the process's largest resident size, bytes */
const char *memory_name(enum memory_part part);
