/* Computes what the targets are compared with, from measured rows and whole runs. */
#include "program/bench/value.h"

#include <math.h>

static double cell(const struct bench_cells *c, const struct bench_subject *s, const char *column) {
    return c ? bench_cells_number(c, bench_cells_find(c, s->part, s->size, s->ranks), column) : NAN;
}

double bench_value_cell(const struct bench_page_files *p, const char *part, const char *size, int ranks,
                        const char *column) {
    return cell(p->rows, &(struct bench_subject){part, size, ranks, 0}, column);
}

static struct bench_value single(double number) { return (struct bench_value){number, NAN, NAN}; }

struct bench_value bench_value_ms(const struct bench_page_files *p, const struct bench_subject *s) {
    return (struct bench_value){cell(p->rows, s, "median_ms"), cell(p->rows, s, "low_ms"), cell(p->rows, s, "high_ms")};
}

static struct bench_value times(struct bench_value v, double factor) {
    return (struct bench_value){factor * v.median, factor * v.low, factor * v.high};
}

/* over / v, in per cent */
static struct bench_value per_cent(double over, struct bench_value v) {
    return (struct bench_value){100 * over / v.median, 100 * over / v.high, 100 * over / v.low};
}

struct bench_value bench_value_ns(const struct bench_page_files *p, const struct bench_subject *s) {
    const struct bench_value ms = bench_value_ms(p, s);
    return times(ms, cell(p->rows, s, "ns_per_unit") / ms.median);
}

struct bench_value bench_value_roofline(const struct bench_page_files *p, const struct bench_subject *s) {
    const struct bench_value ms = bench_value_ms(p, s);
    return per_cent(cell(p->rows, s, "fraction_of_limit") * ms.median, ms);
}

struct bench_value bench_value_core_speed(const struct bench_page_files *p, const struct bench_subject *s) {
    struct bench_subject one = *s, two = *s;
    one.ranks = 1, two.ranks = 2;
    const struct bench_value alone = bench_value_ns(p, &one), both = bench_value_ns(p, &two);
    return (struct bench_value){100 * alone.median / both.median, 100 * alone.low / both.high,
                                100 * alone.high / both.low};
}

struct bench_value bench_value_lammps(const struct bench_page_files *p, const struct bench_subject *s) {
    if (!p->peer) return single(NAN);
    const double in_double = bench_value_cell(p, "sweep_full_double", s->size, s->ranks, "ns_per_unit"),
                 in_mixed = bench_value_cell(p, "sweep_full_mixed", s->size, s->ranks, "ns_per_unit");
    return single(bench_cells_number(p->peer, 0, "ratio") * in_double / in_mixed);
}

struct bench_value bench_value_immersed(const struct bench_page_files *p, const struct bench_subject *s) {
    const struct bench_value forcing = bench_value_ms(p, &(struct bench_subject){"forcing", s->size, s->ranks, 0}),
                             probe = bench_value_ms(p, &(struct bench_subject){"probe", s->size, s->ranks, 0});
    return (struct bench_value){forcing.median + probe.median, forcing.low + probe.low, forcing.high + probe.high};
}

struct bench_value bench_value_cracks(const struct bench_page_files *p, const struct bench_subject *s) {
    return single(100 * bench_value_cell(p, "crack_pressures", s->size, s->ranks, "median_ms") /
                  bench_value_cell(p, "crack_sweep", s->size, s->ranks, "median_ms"));
}

struct bench_value bench_value_contact(const struct bench_page_files *p, const struct bench_subject *s) {
    const struct bench_whole *run = bench_page_run(p, s->kind);
    return single(run ? bench_whole_part(run, "fracture", "contact") : NAN);
}

struct bench_value bench_value_minutes(const struct bench_page_files *p, const struct bench_subject *s) {
    const struct bench_whole *run = bench_page_run(p, s->kind);
    return single(run ? run->wall_seconds / 60 : NAN);
}

double bench_value_substeps(const struct bench_page_files *p) {
    const struct bench_whole *run = bench_page_run(p, BENCH_WHOLE_VERLET); /* whose bonds are those of the block */
    return run ? bench_value_cell(p, "solid_substeps", "", 2, "units") / bench_whole_number(run, "directed_bonds")
               : NAN;
}

double bench_value_sweeps(const struct bench_page_files *p) {
    const struct bench_whole *run = bench_page_run(p, BENCH_WHOLE_VERLET);
    if (!run) return NAN;
    return (bench_whole_sweeps(run) - bench_value_substeps(p) * bench_whole_number(run, "timeline/settle/steps")) /
           bench_whole_number(run, "timeline/fracture/steps");
}

/* Seconds of all parts as the bench has them: the fluid and its forcing in every step; markers and probe where the
 * solid moves, its sweeps, and contact in each sweep of fracture. */
static double parts(const struct bench_page_files *p, const struct bench_whole *run, const char *column) {
    const double settle = bench_whole_number(run, "timeline/settle/steps"),
                 fracture = bench_whole_number(run, "timeline/fracture/steps"),
                 steps = bench_whole_number(run, "timeline/flow/steps") + settle + fracture;
    const struct {
        const char *part;
        double calls;
    } of[] = {{"fluid_step", steps},
              {"forcing", steps},
              {"markers", settle + fracture},
              {"probe", settle + fracture},
              {"interface", settle},
              {"interface_broken", fracture},
              {"solid_substeps", bench_whole_sweeps(run) / bench_value_substeps(p)},
              {"contact_broken", bench_value_sweeps(p) * fracture}};
    double ms = 0;
    for (int k = 0; k < (int)(sizeof of / sizeof *of); k++)
        ms += of[k].calls * bench_value_cell(p, of[k].part, "128x64x64", 2, column);
    return 1e-3 * ms;
}

struct bench_value bench_value_parts(const struct bench_page_files *p, const struct bench_subject *s) {
    const struct bench_whole *run = bench_page_run(p, s->kind);
    if (!run) return single(NAN);
    const double wall = run->wall_seconds;
    return (struct bench_value){100 * parts(p, run, "median_ms") / wall, 100 * parts(p, run, "low_ms") / wall,
                                100 * parts(p, run, "high_ms") / wall};
}

/* Only samples probe a solid at rest. */
struct bench_value bench_value_output(const struct bench_page_files *p, const struct bench_subject *s) {
    const struct bench_whole *run = bench_page_run(p, s->kind);
    if (!run) return single(NAN);
    const double files = bench_whole_number(run, "wall_seconds_by_part/output");
    return single(100 * (files + bench_whole_part(run, "flow", "probe")) / run->wall_seconds);
}

struct bench_value bench_value_bytes(const struct bench_page_files *p, const struct bench_subject *s) {
    return single(cell(p->rows, s, "bytes_per_unit"));
}

struct bench_value bench_value_before(const struct bench_page_files *p, const struct bench_subject *s) {
    return single(cell(p->bytes, s, "bytes_per_unit"));
}

struct bench_value bench_value_peers(const struct bench_page_files *p, const struct bench_subject *s) {
    const struct bench_whole *run = bench_page_run(p, s->kind);
    if (!run || !p->peer) return single(NAN);
    const double flow = cell(p->earlier, &(struct bench_subject){"fluid_step", "128x64x64", 2, 0}, "best_ms"),
                 bond = bench_cells_number(p->peer, 0, "theirs_ns");
    return single((1e-3 * flow * (bench_whole_number(run, "steps") - (double)run->from) +
                   1e-9 * bond * bench_whole_sweeps(run) * bench_whole_number(run, "directed_bonds") / run->ranks) /
                  60);
}
