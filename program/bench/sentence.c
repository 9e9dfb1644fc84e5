/* Writes the sentences of a page, with numbers from the files that it is made of. */
#include "program/bench/sentence.h"
#include "base/ensure.h"
#include "program/bench/value.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The words between braces: word[0] is the number's name, the others say of what it is. */
typedef char words[4][32];

static struct bench_subject subject(const words w) {
    return (struct bench_subject){w[1], strcmp(w[2], "-") ? w[2] : "", atoi(w[3]), 0};
}

/* The column of a row that a name stands for; NULL: none. */
static const char *column_of(const char *name) {
    static const char *const column[][2] = {{"ms", "median_ms"},         {"ns", "ns_per_unit"},
                                            {"bytes", "bytes_per_unit"}, {"flops", "flops_per_unit"},
                                            {"cans", "theirs_ms"},       {"cans_best", "best_ms"},
                                            {"cans_ours", "ours_ms"},    {"lammps", "theirs_ns"},
                                            {"lammps_ratio", "ratio"},   {NULL, NULL}};
    int k = 0;
    while (column[k][0] && strcmp(column[k][0], name)) k++;
    return column[k][1];
}

static double of_run(const struct bench_whole *run, const words w) {
    char path[80];
    if (!run) return NAN;
    if (!strcmp(w[0], "stage")) {
        snprintf(path, sizeof path, "timeline/%s/steps", w[1]);
        return 1e3 * bench_whole_part(run, w[1], w[2]) / bench_whole_number(run, path);
    }
    snprintf(path, sizeof path, "wall_seconds_by_part/%s", w[1]);
    return 100 * bench_whole_number(run, path) / run->wall_seconds;
}

/* Mean over the ranks of what all parts waited, of the run's time, %. */
static double waiting(const struct bench_whole *run) {
    static const char *const part[] = {"momentum", "poisson", "halo",      "forcing", "probe",
                                       "solid",    "contact", "interface", "judging", "output"};
    double sum = 0;
    for (int k = 0; run && k < (int)(sizeof part / sizeof *part); k++) {
        char path[80];
        snprintf(path, sizeof path, "seconds_by_part_and_rank/%s/waiting/mean", part[k]);
        sum += bench_whole_number(run, path);
    }
    return run ? 100 * sum / run->wall_seconds : NAN;
}

static double number_of(const struct bench_page_files *p, const words w) {
    const struct bench_subject of = subject(w), whole = {.kind = (enum bench_whole_kind)atoi(w[1])};
    const char *column = column_of(w[0]);
    if (column && !strncmp(w[0], "cans", 4))
        return p->earlier ? bench_cells_number(p->earlier, bench_cells_find(p->earlier, w[1], w[2], 0), column) : NAN;
    if (column && !strncmp(w[0], "lammps", 6)) return p->peer ? bench_cells_number(p->peer, 0, column) : NAN;
    if (column) return bench_value_cell(p, of.part, of.size, of.ranks, column);
    if (!strcmp(w[0], "roofline")) return bench_value_roofline(p, &of).median;
    if (!strcmp(w[0], "least")) return 0.01 * bench_value_roofline(p, &of).median * bench_value_ms(p, &of).median;
    if (!strcmp(w[0], "before")) return bench_value_before(p, &of).median;
    if (!strcmp(w[0], "peers")) return bench_value_peers(p, &whole).median;
    if (!strcmp(w[0], "sweeps")) return bench_value_sweeps(p);
    if (!strcmp(w[0], "substeps_alone")) return bench_value_substeps(p);
    if (!strcmp(w[0], "substeps")) {
        const struct bench_whole *run = bench_page_run(p, whole.kind);
        return run ? bench_whole_number(run, "substeps") : NAN;
    }
    if (!strcmp(w[0], "waiting")) return waiting(bench_page_run(p, BENCH_WHOLE_VERLET));
    ENSURE(!strcmp(w[0], "stage") || !strcmp(w[0], "share"), "{%s}: no such number", w[0]);
    const char *kind = strcmp(w[0], "stage") ? w[2] : w[3];
    return of_run(bench_page_run(p, (enum bench_whole_kind)atoi(kind)), w);
}

void bench_sentence_write(FILE *to, const struct bench_page_files *p, const char *sentence) {
    for (const char *at = sentence; *at;) {
        const char *open = strchr(at, '{'), *close = open ? strchr(open, '}') : NULL;
        if (!close) {
            fputs(at, to);
            return;
        }
        char inner[128];
        words w = {"", "", "", ""};
        snprintf(inner, sizeof inner, "%.*s", (int)(close - open - 1), open + 1);
        sscanf(inner, "%31s %31s %31s %31s", w[0], w[1], w[2], w[3]);
        const double number = number_of(p, w);
        fprintf(to, "%.*s", (int)(open - at), at);
        fprintf(to, isnan(number) ? "–" : "%.*g", fabs(number) < 1000 ? 3 : 4, number);
        at = close + 1;
    }
}
