/* A whole run, from the run.json that it left. */
#pragma once

struct bench_whole {
    char title[256];
    double wall_seconds, ranks;
    long from; /* the step at which it was resumed, 0: it began there */
    int rk3;   /* 1: the last stage's solid went by RK3, 0: by velocity Verlet */
};

/* Dies with exit code 4 on a file that is missing, or of a run that is not done. Not collective. */
struct bench_whole bench_whole_read(const char *path);
