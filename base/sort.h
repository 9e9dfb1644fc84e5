/* Sorted lists of numbers. */
#pragma once
#include <stddef.h>

void sort_ascending(double *x, size_t n);           /* in place */
double sort_median(double *x, size_t n);            /* sorts; the mean of the two middle ones, 0 without any */
long sort_unique(long *x, long n);                  /* sorts, each number once; returns how many are left */
long sort_find(const long *x, long n, long wanted); /* the place of the last number <= wanted; 0: none is */
