/* Times of a call: warm-up, then repeats of several calls each; the median over the repeats, and their extremes. */
#pragma once
#include "base/clock.h"

enum { BENCH_REPEATS_MAX = 1000 };

struct bench_repetition {
    int repeats;    /* at least five */
    double seconds; /* duration of a repeat, s */
};

/* Seconds a call, on the slowest rank. */
struct bench_sample {
    long calls; /* in a repeat */
    int repeats;
    double median, low, high;
};

/* The channels of a measurement: the wall clock, and each part of the program's clocks (base/clock.h). */
enum { BENCH_WALL, BENCH_CLOCK, BENCH_CHANNELS = BENCH_CLOCK + CLOCK_ALL };

typedef void bench_call(void *with);

/* Times `call` on each of n arguments in turn, repeat by repeat, so that a disturbance of the machine affects all of
 * them. sample [n][BENCH_CHANNELS], n <= BENCH_ARGUMENTS. Collective. */
enum { BENCH_ARGUMENTS = 8 };
void bench_measure(const struct bench_repetition *repetition, bench_call *call, int n, void *const *with,
                   struct bench_sample (*sample)[BENCH_CHANNELS]);
/* The same of one argument by the wall clock. */
struct bench_sample bench_measure_one(const struct bench_repetition *repetition, bench_call *call, void *with);
