/* The measured files of several machines: each machine has a folder of its own. */
#pragma once
#include "base/files/folder.h"
#include "program/bench/csv.h"
#include "program/bench/whole.h"

enum { BENCH_RUNS_MAX = 8, BENCH_MACHINES_MAX = 8 };

/* Of one machine. */
struct bench_results {
    char folder[FOLDER_PATH];
    struct bench_csv *rows, *traffic;
    struct bench_csv *lammps, *cans; /* other programs and frana, in turn */
    int runs;
    struct bench_whole run[BENCH_RUNS_MAX]; /* in folders below this one */
};

struct bench_files {
    int machines;
    struct bench_results machine[BENCH_MACHINES_MAX]; /* in the order of their first tables */
};

/* Reads tables and run.json. Dies with exit code 4. Not collective. */
void bench_files_read(struct bench_files *f, int n, const char *const *path);
void bench_files_free(struct bench_files *f);
/* The last whole run of that kind, or NULL. */
const struct bench_whole *bench_files_run(const struct bench_results *r, enum bench_whole_kind kind);
