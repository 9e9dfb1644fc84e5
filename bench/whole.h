/* A whole run, from its run.json. */
#pragma once

struct bench_whole {
    char title[256];
    double wall_seconds, ranks;
    long from; /* the step at which it was resumed; 0: not resumed */
    int rk3;   /* 1: the solid of the last stage was integrated by RK3, 0: by velocity Verlet */
};

/* Dies with exit code 4 if the file is missing or if the run has not finished. Not collective. */
struct bench_whole bench_whole_read(const char *path);
