/* Writes the tables of docs/performance.md and docs/scaling.md from measured times. */
#include "base/die.h"
#include "program/bench/bench.h"
#include "program/bench/line.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const char *text(const struct bench_csv *c, int row, const char *column) {
    const char *t = bench_csv_text(c, row, column);
    return *t ? t : "–";
}

/* All others are shares, in per cent. */
static const char *const unit[BENCH_LINE_KINDS] = {
    [BENCH_LINE_MS] = " ms",  [BENCH_LINE_NS] = " ns", [BENCH_LINE_BYTES] = " B", [BENCH_LINE_MINUTES] = " min",
    [BENCH_LINE_LAMMPS] = "", [BENCH_LINE_CANS] = "",  [BENCH_LINE_STEPS] = ""};

static void number(const struct bench_line *l, double value) {
    if (unit[l->kind])
        printf("%.3g%s", value, unit[l->kind]);
    else
        printf("%.3g %%", 100 * value);
}

/* A value that reaches its target is bold. */
static void entry(const struct bench_line *l, const struct bench_results *r) {
    const double value = bench_line_value(l, r);
    const struct bench_whole *run = l->kind == BENCH_LINE_MINUTES ? bench_files_run(r, l->run) : NULL;
    const char *bold = bench_line_is_reached(l, value) ? "**" : "";
    if (isnan(value)) {
        printf(" – |");
        return;
    }
    printf(" %s", bold);
    number(l, value);
    if (run && run->from > 0) printf(" from step %ld on", run->from);
    printf("%s |", bold);
}

static void line(const struct bench_line *l, const struct bench_files *f) {
    printf("| %s |", l->what);
    if (l->most > 0 || l->least > 0) {
        printf(l->most > 0 ? " ≤ " : " ≥ ");
        number(l, l->most > 0 ? l->most : l->least);
    }
    printf(" |");
    for (int m = 0; m < f->machines; m++) entry(l, &f->machine[m]);
    printf("\n");
}

static void performance(const struct bench_files *f) {
    printf("| what | to reach |");
    for (int m = 0; m < f->machines; m++) {
        const char *slash = strrchr(f->machine[m].folder, '/');
        printf(" %s |", slash ? slash + 1 : f->machine[m].folder);
    }
    printf("\n|---|---|");
    for (int m = 0; m < f->machines; m++) printf("---|");
    printf("\n");
    for (int k = 0; k < bench_lines_count; k++) line(&bench_lines[k], f);
    printf("| **targets reached** | |");
    for (int m = 0; m < f->machines; m++) {
        int reached = 0, measured = 0;
        for (int k = 0; k < bench_lines_count; k++) {
            const struct bench_line *l = &bench_lines[k];
            const double value = bench_line_value(l, &f->machine[m]);
            reached += bench_line_is_reached(l, value);
            measured += !isnan(value) && (l->most > 0 || l->least > 0);
        }
        printf(" %d of %d |", reached, measured);
    }
    printf("\n");
}

static void machine(const struct bench_csv *c) {
    printf("%s, %s cores. %s, `%s`; FFTW: %s, plans: %s; %s. %s, revision %s.\n\n", text(c, 0, "cpu"),
           text(c, 0, "cores"), text(c, 0, "compiler"), text(c, 0, "flags"), text(c, 0, "fftw"), text(c, 0, "plan"),
           text(c, 0, "mpi"), text(c, 0, "date"), text(c, 0, "revision"));
}

static void growth_of(const struct bench_csv *c, const char *part, const char *title) {
    printf("| %s | 1 rank, ms | ns a unit | 2 ranks, ms | ns a unit and core | speed-up "
           "|\n|---|---|---|---|---|---|\n",
           title);
    for (int row = 0; row < c->rows; row++) {
        const char *size = text(c, row, "size");
        const int one = bench_csv_find(c, part, size, 1), two = bench_csv_find(c, part, size, 2);
        if (strcmp(text(c, row, "part"), part) || row != (one >= 0 ? one : two)) continue;
        printf("| %s | %s | %s | %s | %s | %.2f |\n", size, text(c, one, "median_ms"), text(c, one, "ns_per_unit"),
               text(c, two, "median_ms"), text(c, two, "ns_per_unit"),
               bench_csv_number(c, one, "median_ms") / bench_csv_number(c, two, "median_ms"));
    }
    printf("\n");
}

static void sent(const struct bench_csv *c) {
    printf("| a step of | size | ranks | kind | messages | collectives | bytes "
           "|\n|---|---|---|---|---|---|---|\n");
    for (int row = 0; row < c->rows; row++)
        printf("| %s | %s | %s | %s | %s | %s | %s |\n", text(c, row, "part"), text(c, row, "size"),
               text(c, row, "ranks"), text(c, row, "kind"), text(c, row, "messages"), text(c, row, "collectives"),
               text(c, row, "bytes"));
    printf("\n");
}

static void growth(const struct bench_results *r) {
    machine(r->rows);
    growth_of(r->rows, "fluid_step", "cells");
    growth_of(r->rows, "sweep_full", "particles");
    if (r->traffic) sent(r->traffic);
}

int bench_table(const struct bench_input *in) {
    struct bench_files f = {0};
    bench_files_read(&f, in->files, in->file);
    for (int m = 0; m < f.machines || m == 0; m++)
        if (!f.machine[m].rows || !f.machine[m].rows->rows)
            die(EXIT_CODE_FILE, "frana bench --table: none of the files in %s holds measured times",
                f.machine[m].folder[0] ? f.machine[m].folder : "this folder");
    switch (in->page) {
    case BENCH_PAGE_NONE:
        break;
    case BENCH_PAGE_PERFORMANCE:
        performance(&f);
        break;
    case BENCH_PAGE_GROWTH:
        growth(&f.machine[0]);
        break;
    }
    bench_files_free(&f);
    return EXIT_CODE_DONE;
}
