/* Sorted lists of cells' numbers. */
#pragma once

/* For qsort. */
static inline int stokes_numbers_ascending(const void *a, const void *b) {
    const long x = *(const long *)a, y = *(const long *)b;
    return (x > y) - (x < y);
}

/* The place of a number in an ascending list that has it. */
static inline int stokes_numbers_find(const long *number, int n, long wanted) {
    int low = 0, high = n;
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        if (number[middle] <= wanted)
            low = middle;
        else
            high = middle;
    }
    return low;
}
