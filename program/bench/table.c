/* Writes docs/performance.md and the tables of docs/scaling.md from measured times. */
#include "base/die.h"
#include "program/bench/bench.h"
#include "program/bench/page.h"
#include "program/bench/targets.h"
#include "program/bench/value.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const char *text(const struct bench_cells *c, int row, const char *column) {
    const char *t = bench_cells_text(c, row, column);
    return *t ? t : "–";
}

/* What an image's body costs beside a box of the same particles. */
static void images(const struct bench_page_files *p) {
    const char *const which[2][3] = {{"full", "sweep_full_box", "sweep_full_image"},
                                     {"porous", "sweep_porous_box", "sweep_porous_image"}};
    for (int ranks = 1; ranks <= 2; ranks++)
        for (int k = 0; k < 2; k++) {
            const int box = bench_cells_find(p->rows, which[k][1], "", ranks),
                      image = bench_cells_find(p->rows, which[k][2], "", ranks);
            const double ours = bench_cells_number(p->rows, image, "ns_per_unit"),
                         theirs = bench_cells_number(p->rows, box, "ns_per_unit");
            if (isnan(ours / theirs)) continue;
            printf("\nThe %s block as an image, and as a box, in turn, %d rank%s: %.3g and %.3g ns a directed bond, "
                   "ratio %.3f.\n",
                   which[k][0], ranks, ranks > 1 ? "s" : "", ours, theirs, ours / theirs);
        }
    const char *const bytes[2][2] = {{"memory_image_particle", "memory_lattice_particle"},
                                     {"memory_image_bond", "memory_lattice_bond"}};
    double held[2][2];
    for (int k = 0; k < 4; k++)
        held[k / 2][k % 2] =
            bench_cells_number(p->rows, bench_cells_find(p->rows, bytes[k / 2][k % 2], "", 1), "bytes_per_unit");
    if (!isnan(held[0][0] + held[0][1] + held[1][0] + held[1][1]))
        printf("\nAn image holds %.4g bytes a particle and %.4g a directed bond, a box %.4g and %.4g.\n", held[0][0],
               held[1][0], held[0][1], held[1][1]);
}

/* What mixed precision costs beside double. */
static void precision(const struct bench_page_files *p) {
    const char *const which[4][3] = {{"full", "sweep_full_double", "sweep_full_mixed"},
                                     {"full, damped", "sweep_full_double_damped", "sweep_full_mixed_damped"},
                                     {"porous", "sweep_porous_double", "sweep_porous_mixed"},
                                     {"porous, damped", "sweep_porous_double_damped", "sweep_porous_mixed_damped"}};
    for (int ranks = 1; ranks <= 2; ranks++)
        for (int k = 0; k < 4; k++) {
            const double mixed = bench_cells_number(p->rows, bench_cells_find(p->rows, which[k][2], "", ranks),
                                                    "ns_per_unit"),
                         wide = bench_cells_number(p->rows, bench_cells_find(p->rows, which[k][1], "", ranks),
                                                   "ns_per_unit");
            if (isnan(mixed / wide)) continue;
            printf("\nThe %s block in mixed precision, and in double, in turn, %d rank%s: %.3g and %.3g ns a directed "
                   "bond, ratio %.3f.\n",
                   which[k][0], ranks, ranks > 1 ? "s" : "", mixed, wide, mixed / wide);
        }
}

/* What the fluid in a crack costs beside the same body without it. */
static void cracks(const struct bench_page_files *p) {
    const char *const part[5] = {"crack_sweep", "crack_substep_dry", "crack_substep_wet", "crack_pressures",
                                 "crack_solves"};
    for (int ranks = 1; ranks <= 2; ranks++) {
        double ms[5], each[5];
        for (int k = 0; k < 5; k++) {
            const int row = bench_cells_find(p->rows, part[k], "1000000", ranks);
            ms[k] = bench_cells_number(p->rows, row, "median_ms");
            each[k] = 1e-6 * bench_cells_number(p->rows, row, "ns_per_unit") / ranks;
        }
        if (isnan(ms[0] + ms[1] + ms[2] + ms[3] + ms[4])) continue;
        printf(
            "\nA crack of 40 spacings' radius that a fluid is pumped into, among 10⁶ particles, in turn with the same "
            "body without it, %d rank%s: its pressures take\n%.3g ms a substep, %.3g iterations in %.3g solves; a "
            "sweep takes %.3g ms: ratio %.3f. The rest of a substep takes %.3f of one without `crack_fluid`.\n",
            ranks, ranks > 1 ? "s" : "", ms[3], ms[3] / each[3], ms[4] / each[4], ms[0], ms[3] / ms[0],
            (ms[2] - ms[3]) / ms[1]);
    }
}

/* What breakage costs a block that does not break. */
static void breakage(const struct bench_page_files *p) {
    const char *const size = "128x64x64";
    const double off = bench_value_cell(p, "coupled_step", size, 2, "median_ms"),
                 on = bench_value_cell(p, "coupled_step_breakage", size, 2, "median_ms");
    if (!isnan(on / off))
        printf("The same block, intact: a coupled step with breakage on takes %.3f of one with breakage off (2 ranks, "
               "taken in turn).\n",
               on / off);
}

/* Other programs and ours, as they were measured in turn. */
static void peers(const struct bench_page_files *p) {
    for (int row = 0; p->peer && row < p->peer->rows; row++)
        printf("%sLAMMPS and frana in one go, in turn, 1 rank, %s directed bonds each: %s and %s ns a bond, "
               "ratio %s (%s).\n",
               row ? "" : "\n", text(p->peer, row, "bonds"), text(p->peer, row, "theirs_ns"),
               text(p->peer, row, "ours_ns"), text(p->peer, row, "ratio"), text(p->peer, row, "spread"));
    for (int row = 0; p->flow && row < p->flow->rows; row++)
        printf("\nCaNS and frana in one go, in turn, %s ranks, %s, %s cells: %s and %s ms a step, ratio %s (%s).\n",
               text(p->flow, row, "ranks"), text(p->flow, row, "part"), text(p->flow, row, "size"),
               text(p->flow, row, "theirs_ms"), text(p->flow, row, "ours_ms"), text(p->flow, row, "ratio"),
               text(p->flow, row, "spread"));
    printf("\n");
}

static void targets(const struct bench_page_files *p) {
    printf(
        "## To reach\n\nOurs is the median, with the lowest and highest of the repeats. Of ratios and sums they "
        "follow from those of the single times,\nwhich were not taken in turn. LAMMPS, as Debian has it, was measured "
        "here in turn with ours. CaNS was measured earlier, in turn\nwith ours of that time "
        "(`bench/reference/cans.csv`). Memory is compared with that of an earlier revision "
        "(`bench/reference/memory.csv`).\n\n");
    bench_targets_write(stdout, p);
    breakage(p);
    images(p);
    precision(p);
    cracks(p);
    peers(p);
}

static void machine(const struct bench_cells *c) {
    printf("%s, %s cores. %s, `%s`; FFTW: %s, plans: %s; %s. %s, revision %s.\n\n", text(c, 0, "cpu"),
           text(c, 0, "cores"), text(c, 0, "compiler"), text(c, 0, "flags"), text(c, 0, "fftw"), text(c, 0, "plan"),
           text(c, 0, "mpi"), text(c, 0, "date"), text(c, 0, "revision"));
}

static void measured(const struct bench_cells *c, int ranks) {
    printf("## On %d rank%s\n\n"
           "| part | size | ms | low–high | ns a unit | unit | bytes | flops | GB/s | of the limit |\n"
           "|---|---|---|---|---|---|---|---|---|---|\n",
           ranks, ranks > 1 ? "s" : "");
    for (int row = 0; row < c->rows; row++) {
        if ((int)bench_cells_number(c, row, "ranks") != ranks || isnan(bench_cells_number(c, row, "median_ms")))
            continue;
        const double fraction = bench_cells_number(c, row, "fraction_of_limit");
        printf("| %s | %s | %s | %s–%s | %s | %s | %s | %s | %s | ", text(c, row, "part"), text(c, row, "size"),
               text(c, row, "median_ms"), text(c, row, "low_ms"), text(c, row, "high_ms"), text(c, row, "ns_per_unit"),
               text(c, row, "unit"), text(c, row, "bytes_per_unit"), text(c, row, "flops_per_unit"),
               text(c, row, "gb_per_s"));
        if (isnan(fraction))
            printf("– |\n");
        else
            printf("%.0f %% |\n", 100 * fraction);
    }
    printf("\n");
}

static void memory(const struct bench_cells *c) {
    printf("## Memory\n\n| part | size | ranks | bytes | a |\n|---|---|---|---|---|\n");
    for (int row = 0; row < c->rows; row++)
        if (!strncmp(text(c, row, "part"), "memory", 6))
            printf("| %s | %s | %s | %s | %s |\n", text(c, row, "part"), text(c, row, "size"), text(c, row, "ranks"),
                   text(c, row, "bytes_per_unit"), text(c, row, "unit"));
    printf("\n");
}

static void performance(const struct bench_page_files *p) {
    printf("# Performance\n\nMade by `bench/run.sh`, not by hand. A time is the median over repeats of "
           "several calls, after a "
           "warm-up, of the slowest\nrank; *ns a unit* are of one core; *bytes* and *flops* are what the "
           "algorithm must move "
           "and compute a unit, counted beside\neach kernel's bench in `program/bench/`; *of the limit* is the least "
           "time that the "
           "bandwidth and the multiply-adds measured in the same\nrun allow (roofline), over the time taken. "
           "Where that "
           "is above what memory gives, the data stay in the cache.\n\n"
           "Where the time of a whole run goes, by part, stage and rank, is in [timeline.md](timeline.md). The "
           "verdicts depend on the\nmachine: [performance_zen5.md](performance_zen5.md) has them of an AMD EPYC of "
           "the next generation, [performance_xeon.md](performance_xeon.md) of an Intel\nXeon, "
           "[performance_avx2.md](performance_avx2.md) of a processor without AVX-512.\n\n");
    machine(p->rows);
    targets(p);
    measured(p->rows, 1);
    measured(p->rows, 2);
    memory(p->rows);
}

static void growth_of(const struct bench_cells *c, const char *part, const char *title) {
    printf("| %s | 1 rank, ms | ns a unit | 2 ranks, ms | ns a unit and core | speed-up "
           "|\n|---|---|---|---|---|---|\n",
           title);
    for (int row = 0; row < c->rows; row++) {
        const char *size = text(c, row, "size");
        const int one = bench_cells_find(c, part, size, 1), two = bench_cells_find(c, part, size, 2);
        if (strcmp(text(c, row, "part"), part) || row != (one >= 0 ? one : two)) continue;
        printf("| %s | %s | %s | %s | %s | %.2f |\n", size, text(c, one, "median_ms"), text(c, one, "ns_per_unit"),
               text(c, two, "median_ms"), text(c, two, "ns_per_unit"),
               bench_cells_number(c, one, "median_ms") / bench_cells_number(c, two, "median_ms"));
    }
    printf("\n");
}

static void sent(const struct bench_cells *c) {
    printf("| a step of | size | ranks | kind | messages | collectives | bytes "
           "|\n|---|---|---|---|---|---|---|\n");
    for (int row = 0; row < c->rows; row++)
        printf("| %s | %s | %s | %s | %s | %s | %s |\n", text(c, row, "part"), text(c, row, "size"),
               text(c, row, "ranks"), text(c, row, "kind"), text(c, row, "messages"), text(c, row, "collectives"),
               text(c, row, "bytes"));
    printf("\n");
}

int bench_table(const struct bench_input *in) {
    struct bench_page_files p = {0};
    for (int k = 0; k < in->files; k++) bench_page_read(&p, in->file[k]);
    if (!p.rows || !p.rows->rows) die(EXIT_CODE_FILE, "frana bench --table: none of the files holds measured times");
    switch (in->page) {
    case BENCH_PAGE_NONE:
        break;
    case BENCH_PAGE_PERFORMANCE:
        performance(&p);
        break;
    case BENCH_PAGE_GROWTH:
        machine(p.rows);
        growth_of(p.rows, "fluid_step", "cells");
        growth_of(p.rows, "sweep_full", "particles");
        if (p.traffic) sent(p.traffic);
        break;
    }
    bench_page_free(&p);
    return EXIT_CODE_DONE;
}
