/* What the machine can do at best, measured: memory bandwidth and multiply-adds in registers. */
#pragma once
#include "bench/measure.h"

struct bench_limits {
    double alone;    /* B/s that one rank gets while the others wait */
    double together; /* B/s of all ranks at once */
    double peak;     /* flop/s of all ranks at once */
    struct bench_sample triad_alone, triad, fma;
    double triad_length, fma_length; /* elements a triad call, flops a multiply-add call and rank */
};

/* The roofline: the least seconds that this many bytes and flops of all ranks take. */
static inline double bench_limits_seconds(const struct bench_limits *l, double bytes, double flops) {
    const double of_bytes = bytes / l->together, of_flops = flops / l->peak;
    return of_bytes > of_flops ? of_bytes : of_flops;
}

/* length: doubles in each of the triad's three arrays, a rank. Collective. */
struct bench_limits bench_limits_measure(const struct bench_effort *effort, long length);
