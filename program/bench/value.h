/* Numbers of a page, computed from the files that it is made of. NAN: what is needed was not measured. */
#pragma once
#include "program/bench/page.h"

struct bench_value {
    double median, low, high; /* low, high NAN: a single number */
};

/* What is measured: a part of the bench with its size ("": any) and ranks. */
struct bench_subject {
    const char *part, *size;
    int ranks;
    enum bench_whole_kind kind; /* of a whole run */
};

typedef struct bench_value bench_value_of(const struct bench_page_files *p, const struct bench_subject *s);

/* A column of the subject's row in the tables measured here. */
double bench_value_cell(const struct bench_page_files *p, const char *part, const char *size, int ranks,
                        const char *column);
/* Substeps of the bench's block, which has the particles of the main case, without contact. */
double bench_value_substeps(const struct bench_page_files *p);
/* Force sweeps a step in the main case's stage of fracture, by Verlet. In the stage before, it takes the substeps
 * above. */
double bench_value_sweeps(const struct bench_page_files *p);

bench_value_of bench_value_ms, bench_value_ns;
bench_value_of bench_value_roofline;   /* least time that the machine's limits allow, over the time taken, % */
bench_value_of bench_value_core_speed; /* of a core with two ranks over that with one, % */
bench_value_of bench_value_lammps;     /* time of LAMMPS over ours in mixed precision, by double, measured with both */
bench_value_of bench_value_immersed;   /* forcing and probe of a step, ms */
bench_value_of bench_value_cracks;     /* pressures in a crack over the sweep of the same body, % */
bench_value_of bench_value_contact;    /* in the main case's stage of fracture, s */
bench_value_of bench_value_minutes;    /* of the main case */
bench_value_of bench_value_parts;      /* the bench's parts by their number in the main case, over its time, % */
bench_value_of bench_value_output;     /* all files and the samples' probe, of the main case's time, % */
bench_value_of bench_value_bytes;      /* held a unit */
bench_value_of bench_value_before;     /* held a unit before, by bench/reference */
bench_value_of bench_value_peers;      /* CaNS's steps and LAMMPS's sweeps, as many as the main case has, min */
