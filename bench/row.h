/* The table of a bench: a row a kernel or step, written as CSV and said on the screen. */
#pragma once
#include "bench/limits.h"
#include "bench/machine.h"

#include <stdio.h>

struct bench_row {
    const char *part;
    char size[32]; /* "128x64x64" cells, or "54872" particles */
    struct bench_sample time;
    double units; /* of the whole problem, a call */
    const char *unit;
    /* What the algorithm must move and compute a unit, counted beside the kernel's bench; 0: not counted. Bytes are
     * compulsory traffic: each array that does not stay in the cache once in and once out. */
    double bytes, flops;
};

struct bench_table {
    FILE *file; /* rank 0, or NULL */
    FILE *traffic;
    struct bench_limits limits;
    struct bench_machine machine;
};

/* folder NULL: on the screen only. Dies with exit code 4 where it cannot be written. Collective. */
void bench_row_begin(struct bench_table *t, const char *folder);
void bench_row_end(struct bench_table *t);
void bench_row_write(struct bench_table *t, const struct bench_row *row); /* Not collective: rank 0 writes. */
/* Bytes held a unit. bytes: of all ranks. */
void bench_row_memory(struct bench_table *t, const char *part, const char *size, double bytes, double units,
                      const char *unit);
/* What a call sends, by kind: messages, collectives, bytes of the rank that sends most. Collective. */
void bench_row_traffic(struct bench_table *t, const char *part, const char *size, bench_call *call, void *with,
                       int calls);
