/* One number of a sampled curve. Pure. */
#pragma once
#include "study/file/file.h"

struct study_samples {
    long n, stride;      /* sample i stands at i * stride */
    const double *t, *x; /* s, any unit; where x is NAN there is no value */
};

/* last, max, min, mean over time (trapezium rule), or the time when x is first above the limit, over the samples of
 * after <= t <= before; NAN where there are none. */
double study_window(const struct study_samples *s, enum study_at at, double after, double before, double above);
