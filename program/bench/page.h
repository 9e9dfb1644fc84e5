/* What the files of a page hold: measured rows, peers and whole runs. */
#pragma once
#include "program/bench/cells.h"
#include "program/bench/whole.h"

enum { BENCH_RUNS_MAX = 8 };

struct bench_page_files {
    struct bench_cells *rows, *traffic;  /* measured here */
    struct bench_cells *peer, *flow;     /* LAMMPS and CaNS, measured here in turn with ours */
    struct bench_cells *earlier, *bytes; /* bench/reference: CaNS, measured earlier; memory held before */
    int runs;
    struct bench_whole run[BENCH_RUNS_MAX];
};

/* Reads a table or a run.json, and adds it to those read before. Dies with exit code 4. Not collective. */
void bench_page_read(struct bench_page_files *p, const char *path);
void bench_page_free(struct bench_page_files *p);
/* The last whole run by that integrator, or NULL. */
const struct bench_whole *bench_page_run(const struct bench_page_files *p, enum bench_whole_kind kind);
