/* frana bench: times of kernels and whole steps, compared with the machine's limits.  (docs/performance.md) */
#pragma once
#include "base/clock.h"

struct run;

/* Called with the seconds of one step of a run, and with those in each part of the clocks. Collective. */
typedef void bench_observer(const struct run *run, double seconds, const double part[CLOCK_ALL]);

struct bench_input {
    int quick, repeats;
    const char *only, *sizes; /* comma-separated lists, or NULL: all parts, the standard sizes */
    const char *out;          /* folder for the tables, or NULL: the standard one */
    bench_observer *observe;  /* or NULL; not called for small problems */
};

int bench_run(const struct bench_input *in); /* Collective. */
