/* Times of a call: warm-up, then repeats of several calls each; the median over the repeats, and their extremes. */
#pragma once
#include "base/clock.h"

enum { BENCH_REPEATS_MAX = 1000 };

struct bench_effort {
    int repeats;    /* at least five */
    double seconds; /* that a repeat should last */
};

/* Seconds a call, the slowest rank's. */
struct bench_sample {
    long calls; /* in a repeat */
    int repeats;
    double median, low, high;
};

/* What is measured at once: the wall clock, and each part of the program's own (base/clock.h). */
enum { BENCH_WALL, BENCH_CLOCK, BENCH_CHANNELS = BENCH_CLOCK + CLOCK_ALL };

typedef void bench_call(void *with);

/* `call` on each of n things in turn, repeat by repeat, so that what disturbs the machine disturbs all of them.
 * of [n][BENCH_CHANNELS], n <= 8. Collective. */
enum { BENCH_THINGS = 8 };
void bench_measure(const struct bench_effort *effort, bench_call *call, int n, void *const *with,
                   struct bench_sample (*of)[BENCH_CHANNELS]);
/* Sorts; the middle one, or the mean of the two. Not collective. */
double bench_measure_median(int n, double *value);
