/* frana bench: times of kernels and whole steps, compared with the machine's limits.  (docs/performance.md) */
#pragma once
#include "base/clock.h"

/* The tables of a page, made from files measured before. */
enum bench_page { BENCH_PAGE_NONE, BENCH_PAGE_PERFORMANCE, BENCH_PAGE_GROWTH };

struct run;

/* Called with the seconds of one step of a run, and with those in each part of the clocks. Collective. */
typedef void bench_observer(const struct run *run, double seconds, const double part[CLOCK_ALL]);

struct bench_input {
    int quick, repeats;
    const char *only, *sizes; /* comma-separated lists, or NULL: all parts, the standard sizes */
    const char *out;          /* folder for the tables, or NULL: the standard one */
    enum bench_page page;     /* NONE: measures */
    int files;                /* for a page: tables and run.json */
    const char *const *file;  /* borrowed */
    bench_observer *observe;  /* or NULL; not called for small problems */
};

int bench_run(const struct bench_input *in);   /* measures, or makes a page's tables. Collective. */
int bench_table(const struct bench_input *in); /* Not collective. */
