/* The machine and the build of a measurement, without the host's name. */
#pragma once

struct bench_machine {
    char cpu[96], slug[64]; /* the processor's model; the same as part of a file's name */
    int cores;
    char compiler[64], flags[256], fftw[64], plan[32], mpi[64], date[16], revision[64];
};

struct bench_machine bench_machine_of(void); /* Not collective. */
