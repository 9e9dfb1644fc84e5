/* Measured limits of the machine: memory bandwidth and multiply-add rate in registers. */
#pragma once
#include "program/bench/measure.h"

struct bench_limits {
    double alone;    /* B/s of one rank while the others wait */
    double together; /* B/s of all ranks at once */
    double peak;     /* flop/s of all ranks at once */
    struct bench_sample triad_alone, triad, fma;
    double triad_length, fma_length; /* elements in a triad call; flops in a multiply-add call of one rank */
};

/* The roofline: the shortest time, s, for this many bytes and flops of all ranks. */
static inline double bench_limits_seconds(const struct bench_limits *l, double bytes, double flops) {
    const double of_bytes = bytes / l->together, of_flops = flops / l->peak;
    return of_bytes > of_flops ? of_bytes : of_flops;
}

/* length: doubles in each of the triad's three arrays, on each rank. Collective. */
struct bench_limits bench_limits_measure(const struct bench_repetition *repetition, long length);
