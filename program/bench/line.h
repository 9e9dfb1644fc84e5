/* Lines of the table of docs/performance.md: what each compares, and what it is to reach. */
#pragma once
#include "program/bench/files.h"

enum bench_line_kind {
    BENCH_LINE_MS,      /* of a call */
    BENCH_LINE_NS,      /* a unit, of one core */
    BENCH_LINE_BYTES,   /* a unit */
    BENCH_LINE_LIMIT,   /* least time that the machine's limits allow, over the time taken */
    BENCH_LINE_RATIO,   /* seconds of the cores over those of `over` */
    BENCH_LINE_LAMMPS,  /* time of LAMMPS's sweep over ours: measured by `over`, for `part` by its time over that */
    BENCH_LINE_CANS,    /* time of CaNS's step over ours */
    BENCH_LINE_MINUTES, /* of the whole run */
    BENCH_LINE_STEPS,   /* time of the whole run over that of its fluid steps by the bench */
    BENCH_LINE_PARTS,   /* time of all parts of the bench, as many as the whole run has, over the run's */
    BENCH_LINE_RUNS,    /* time of the whole run over that of the Verlet run */
    BENCH_LINE_CONTACT, /* of the whole run's time: contact in the stage of fracture */
    BENCH_LINE_OUTPUT,  /* of the whole run's time: files, and the samples' probe of a solid at rest */
    BENCH_LINE_KINDS
};

struct bench_line {
    const char *what;
    enum bench_line_kind kind;
    const char *part, *size; /* several parts are joined by +; size "": any */
    int ranks;
    const char *over; /* part that the time is divided by; NULL: the same */
    int over_ranks;   /* 0: as many */
    enum bench_whole_kind run;
    double most, least; /* to reach; 0: nothing */
};
extern const struct bench_line bench_lines[];
extern const int bench_lines_count;

/* Ratios are fractions. NAN: not measured. */
double bench_line_value(const struct bench_line *l, const struct bench_results *r);
int bench_line_is_reached(const struct bench_line *l, double value); /* 0 without a target, or if not measured */
/* Substeps of the bench's block, which has the bonds of the main case, without contact. */
double bench_line_substeps(const struct bench_results *r, const struct bench_whole *run);
/* Force sweeps a step in the main case's stage of fracture. The stage before has the substeps above. */
double bench_line_sweeps(const struct bench_results *r, const struct bench_whole *run);
