/* The table of a bench: one row for each kernel or step, written as CSV and to the screen. */
#pragma once
#include "program/bench/limits.h"
#include "program/bench/machine.h"

#include <stdio.h>

struct bench_row {
    const char *part;
    char size[32]; /* "128x64x64" cells, or "54872" particles */
    struct bench_sample time;
    double units; /* work units (cells, bonds, ...) of the whole problem in a call */
    const char *unit;
    /* Bytes that the algorithm must move and flops that it must compute for each unit, counted beside the kernel's
     * bench; 0: not counted. Bytes are compulsory traffic: each array that does not stay in the cache is read once and
     * written once. */
    double bytes, flops;
};

struct bench_table {
    FILE *file; /* rank 0, or NULL */
    FILE *traffic;
    struct bench_limits limits;
    struct bench_machine machine;
};

/* folder NULL: on the screen only. Dies with exit code 4 if the folder is not writable. Collective. */
void bench_row_begin(struct bench_table *t, const char *folder);
void bench_row_end(struct bench_table *t);
void bench_row_write(struct bench_table *t, const struct bench_row *row); /* Not collective: rank 0 writes. */
/* The same with n[0] x n[1] x n[2] as its size. */
void bench_row_write_cells(struct bench_table *t, const int n[3], struct bench_row row);
/* Memory for each unit. bytes: of all ranks. */
void bench_row_memory(struct bench_table *t, const char *part, const char *size, double bytes, double units,
                      const char *unit);
/* Traffic of a call by kind: messages, collective calls and bytes of the rank that sends most. Collective. */
void bench_row_traffic(struct bench_table *t, const char *part, const char *size, bench_call *call, void *with,
                       int calls);
