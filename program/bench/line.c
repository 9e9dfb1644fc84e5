/* Computes the lines of the table from measured rows and whole runs. */
#include "program/bench/line.h"
#include "base/ensure.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static double cell(const struct bench_results *r, const char *part, const char *size, int ranks, const char *column) {
    return r->rows ? bench_csv_number(r->rows, bench_csv_find(r->rows, part, size, ranks), column) : NAN;
}

/* Sum over parts that are joined by +. */
static double sum(const struct bench_results *r, const char *parts, const char *size, int ranks, const char *column) {
    double all = 0;
    for (const char *at = parts; *at; at += strcspn(at, "+"), at += *at == '+') {
        char part[64];
        snprintf(part, sizeof part, "%.*s", (int)strcspn(at, "+"), at);
        all += cell(r, part, size, ranks, column);
    }
    return all;
}

static double ratio(const struct bench_line *l, const struct bench_results *r) {
    const int ranks = l->over_ranks ? l->over_ranks : l->ranks;
    return l->ranks * sum(r, l->part, l->size, l->ranks, "median_ms") /
           (ranks * sum(r, l->over ? l->over : l->part, l->size, ranks, "median_ms"));
}

static double lammps(const struct bench_line *l, const struct bench_results *r) {
    if (!r->lammps) return NAN;
    return bench_csv_number(r->lammps, 0, "ratio") / (l->over ? ratio(l, r) : 1);
}

static double cans(const struct bench_line *l, const struct bench_results *r) {
    return r->cans ? bench_csv_number(r->cans, bench_csv_find(r->cans, l->part, l->size, 0), "ratio") : NAN;
}

double bench_line_substeps(const struct bench_results *r, const struct bench_whole *run) {
    return cell(r, "solid_substeps", "", 2, "units") / bench_whole_number(run, "directed_bonds");
}

double bench_line_sweeps(const struct bench_results *r, const struct bench_whole *run) {
    return (bench_whole_sweeps(run) - bench_line_substeps(r, run) * bench_whole_of_stage(run, "settle", "steps")) /
           bench_whole_of_stage(run, "fracture", "steps");
}

/* Seconds of all parts as the bench has them: the fluid and its forcing in every step; markers and probe where the
 * solid moves, its sweeps, and contact in each sweep of fracture. */
static double parts_of(const struct bench_results *r, const struct bench_whole *run) {
    const double settle = bench_whole_of_stage(run, "settle", "steps"),
                 fracture = bench_whole_of_stage(run, "fracture", "steps"),
                 steps = bench_whole_of_stage(run, "flow", "steps") + settle + fracture;
    const struct {
        const char *part;
        double calls;
    } of[] = {{"fluid_step+forcing", steps},
              {"markers+probe", settle + fracture},
              {"interface", settle},
              {"interface_broken", fracture},
              {"solid_substeps", bench_whole_sweeps(run) / bench_line_substeps(r, run)},
              {"contact_broken", bench_line_sweeps(r, run) * fracture}};
    double ms = 0;
    for (int k = 0; k < (int)(sizeof of / sizeof *of); k++)
        ms += of[k].calls * sum(r, of[k].part, "128x64x64", 2, "median_ms");
    return 1e-3 * ms;
}

/* Time of the whole run over that of the Verlet run. A run that was resumed is no whole one. */
static double over_verlet(const struct bench_results *r, const struct bench_whole *run) {
    const struct bench_whole *verlet = bench_files_run(r, BENCH_WHOLE_VERLET);
    return verlet && run->from == 0 && verlet->from == 0 ? run->wall_seconds / verlet->wall_seconds : NAN;
}

static double over_fluid(const struct bench_results *r, const struct bench_whole *run) {
    const double steps = bench_whole_number(run, "steps") - (double)run->from;
    return run->wall_seconds / (1e-3 * steps * cell(r, "fluid_step", "128x64x64", 2, "median_ms"));
}

static double output_of(const struct bench_whole *run) {
    return bench_whole_number(run, "wall_seconds_by_part.output") + bench_whole_part(run, "flow", "probe");
}

double bench_line_value(const struct bench_line *l, const struct bench_results *r) {
    const struct bench_whole *run = bench_files_run(r, l->run);
    switch (l->kind) {
    case BENCH_LINE_MS:
        return sum(r, l->part, l->size, l->ranks, "median_ms");
    case BENCH_LINE_NS:
        return cell(r, l->part, l->size, l->ranks, "ns_per_unit");
    case BENCH_LINE_BYTES:
        return cell(r, l->part, l->size, l->ranks, "bytes_per_unit");
    case BENCH_LINE_LIMIT:
        return cell(r, l->part, l->size, l->ranks, "fraction_of_limit");
    case BENCH_LINE_RATIO:
        return ratio(l, r);
    case BENCH_LINE_LAMMPS:
        return lammps(l, r);
    case BENCH_LINE_CANS:
        return cans(l, r);
    case BENCH_LINE_MINUTES:
        return run ? run->wall_seconds / 60 : NAN;
    case BENCH_LINE_STEPS:
        return run ? over_fluid(r, run) : NAN;
    case BENCH_LINE_PARTS:
        return run ? parts_of(r, run) / run->wall_seconds : NAN;
    case BENCH_LINE_RUNS:
        return run ? over_verlet(r, run) : NAN;
    case BENCH_LINE_CONTACT:
        return run ? bench_whole_part(run, "fracture", "contact") / run->wall_seconds : NAN;
    case BENCH_LINE_OUTPUT:
        return run ? output_of(run) / run->wall_seconds : NAN;
    case BENCH_LINE_KINDS:
        break;
    }
    ENSURE(0, "kind %d of a line", (int)l->kind);
}

int bench_line_is_reached(const struct bench_line *l, double value) {
    return (l->most > 0 && value <= l->most) || (l->least > 0 && value >= l->least);
}
