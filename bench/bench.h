/* frana bench: times of kernels and whole steps, beside what the machine could do at best.  (docs/performance.md) */
#pragma once

/* Pages made of tables that were measured before; none: the bench measures. */
enum bench_page { BENCH_PAGE_NONE, BENCH_PAGE_PERFORMANCE, BENCH_PAGE_GROWTH };

struct bench_options {
    enum bench_page page;
    int files; /* for a page: tables and run.json, borrowed */
    const char *const *file;
    const char *out; /* folder for the tables, or NULL: on the screen only */
    int quick, repeats;
    const char *only, *sizes; /* lists of words with commas, or NULL: all, the standard ones */
};

int bench_run(const struct bench_options *o);   /* measures, or makes a page. Collective. */
int bench_table(const struct bench_options *o); /* makes a page. Not collective. */
