/* Sorted lists of numbers. */
#include "base/sort.h"

#include <stdlib.h>

static int ascending(const void *a, const void *b) {
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

void sort_ascending(double *x, size_t n) {
    if (n > 1) qsort(x, n, sizeof *x, ascending);
}

double sort_median(double *x, size_t n) {
    sort_ascending(x, n);
    return n ? 0.5 * (x[(n - 1) / 2] + x[n / 2]) : 0;
}

static int ascending_long(const void *a, const void *b) {
    const long x = *(const long *)a, y = *(const long *)b;
    return (x > y) - (x < y);
}

long sort_unique(long *x, long n) {
    long kept = 0;
    if (n > 1) qsort(x, (size_t)n, sizeof *x, ascending_long);
    for (long i = 0; i < n; i++)
        if (i == 0 || x[i] != x[i - 1]) x[kept++] = x[i];
    return kept;
}

long sort_find(const long *x, long n, long wanted) {
    long low = 0, high = n;
    while (high - low > 1) {
        const long middle = low + (high - low) / 2;
        *(x[middle] <= wanted ? &low : &high) = middle;
    }
    return low;
}
