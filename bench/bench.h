/* frana bench: times of kernels and whole steps, compared with the machine's limits.  (docs/performance.md) */
#pragma once

/* The tables of a page, made from files measured before. */
enum bench_page { BENCH_PAGE_NONE, BENCH_PAGE_PERFORMANCE, BENCH_PAGE_GROWTH };

struct bench_input {
    int quick, repeats;
    const char *only, *sizes; /* comma-separated lists, or NULL: all parts, the standard sizes */
    const char *out;          /* folder for the tables, or NULL: the standard one */
    enum bench_page page;     /* NONE: measures */
    int files;                /* for a page: tables and run.json */
    const char *const *file;  /* borrowed */
};

int bench_run(const struct bench_input *in);   /* measures, or makes a page's tables. Collective. */
int bench_table(const struct bench_input *in); /* Not collective. */
