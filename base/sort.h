/* Sorting of numbers. */
#pragma once
#include <stddef.h>

void sort_ascending(double *x, size_t n); /* in place */
