/* One number of a sampled curve. Pure. */
#pragma once
#include "program/study/file/file.h"

struct study_samples {
    long n, stride;      /* sample i is at i * stride */
    const double *t, *x; /* s, any unit; x NAN: no value */
};

/* last, first, max, min, mean over time (trapezium rule), or the time when x is first above the limit or
 * first largest, over the samples with
 * after <= t <= before; NAN without samples. */
double study_window(const struct study_samples *s, enum study_at at, double after, double before, double above);
