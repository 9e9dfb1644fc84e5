/* The project's targets of speed and memory: what is to be reached, and what the limit is. */
#pragma once
#include "program/bench/value.h"

#include <stdio.h>

enum bench_verdict { BENCH_REACHED, BENCH_NOT_REACHED, BENCH_NOT_MEASURED };

struct bench_target {
    const char *what, *peer; /* sentences (program/bench/sentence.h); peer NULL: none was measured */
    bench_value_of *ours;
    struct bench_subject of;
    double reach; /* 0: what was held before */
    int at_least; /* 1: ours must be at least this, 0: at most */
    const char *unit;
    const char *why; /* a sentence: what the limit is, and what keeps ours from there */
};

extern const struct bench_target bench_targets[];
extern const int bench_targets_count;

/* Also returns our number and what it is compared with. */
enum bench_verdict bench_targets_verdict(const struct bench_page_files *p, const struct bench_target *t,
                                         struct bench_value *ours, double *reach);
/* Writes the table with its headline and the sentences. */
void bench_targets_write(FILE *to, const struct bench_page_files *p);
