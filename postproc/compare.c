/* frana post with several runs: common curves, distributions at the end, a table of their numbers. */
#include "base/die.h"
#include "base/arena.h"
#include "base/files/atomic_write.h"
#include "base/memory.h"
#include "base/files/folder.h"
#include "postproc/data/pdf.h"
#include "postproc/gnuplot.h"
#include "postproc/post.h"
#include "postproc/report.h"
#include "postproc/sections/sections.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { RUNS_MAX = 16 };

/* The last part of a folder's name. */
static void label_of(const char *folder, char label[64]) {
    size_t end = strlen(folder);
    while (end > 1 && folder[end - 1] == '/') end--;
    size_t start = end;
    while (start > 0 && folder[start - 1] != '/') start--;
    snprintf(label, 64, "%.*s", (int)(end - start), folder + start);
}

static void pdfs_draw(struct postproc_charts *charts, int n, struct postproc_history *const *run,
                      const char *const *label, const char *plots, enum postproc_measure kind) {
    const struct postproc_body_kind *k = &postproc_body_kind[kind];
    struct postproc_pdf pdf[RUNS_MAX] = {{0}};
    struct postproc_curve curve[RUNS_MAX];
    struct postproc_mark mark[RUNS_MAX];
    double *middle[RUNS_MAX] = {NULL};
    int curves = 0, marks = 0;
    for (int r = 0; r < n; r++) {
        struct postproc_body *b = postproc_body_new(run[r], run[r]->end);
        const double *value = !b ? NULL : b->measure[kind];
        if (value) {
            long m;
            double *sample = postproc_body_sample(b, value, &m);
            pdf[r] = postproc_pdf_new(m, sample);
            memory_free(sample);
        }
        postproc_body_free(b);
        if (pdf[r].bins < 2) continue; /* no values, or all values equal */
        middle[r] = arena_new((size_t)pdf[r].bins, sizeof(double));
        for (int i = 0; i < pdf[r].bins; i++) middle[r][i] = pdf[r].low + (i + 0.5) * pdf[r].width;
        curve[curves++] = (struct postproc_curve){
            .title = label[r], .n = pdf[r].bins, .x = middle[r], .y = pdf[r].density, .bars = 1};
        const double threshold = postproc_body_threshold(kind, run[r]);
        if (threshold > 0) mark[marks++] = (struct postproc_mark){threshold, label[r]};
    }
    postproc_charts_add(charts, &(struct postproc_plot){
                                    .folder = plots,
                                    .name = k->name,
                                    .title = k->at_end,
                                    .xlabel = k->xlabel,
                                    .ylabel = "probability density",
                                    .curves = curves,
                                    .curve = curve,
                                    .marks = marks,
                                    .mark = mark,
                                    .log_y = 1,
                                });
}

/* Writes a table with one row for each quantity and one column for each run, to the report and to out/summary.csv.
 * Returns 0, or -1 (errno). */
static int table_write(struct postproc_report *report, int n, const struct postproc_output *const *run,
                       const char *const *label, const char *out) {
    char path[FOLDER_PATH];
    FILE *file = atomic_write_open(folder_path(path, out, "summary.csv"));
    if (!file) return -1;
    const int m = n + 2;
    const char **cell = arena_new((size_t)(POSTPROC_FACTS + 1) * (size_t)m, sizeof *cell);
    int rows = 1;
    cell[0] = "quantity";
    cell[1] = "unit";
    fputs("quantity,unit", file);
    for (int r = 0; r < n; r++) {
        cell[2 + r] = label[r];
        fprintf(file, ",%s", label[r]);
    }
    fputc('\n', file);
    /* the quantities that any run has, in the order of the first run that has them */
    for (int r = 0; r < n; r++)
        for (int i = 0; i < run[r]->facts.n; i++) {
            const struct postproc_fact *fact = &run[r]->facts.fact[i];
            int seen = 0;
            for (int q = 0; q < r; q++) seen |= postproc_facts_find(&run[q]->facts, fact->quantity) != NULL;
            if (seen || rows == POSTPROC_FACTS + 1) continue;
            cell[rows * m] = fact->quantity;
            cell[rows * m + 1] = fact->unit;
            fprintf(file, "\"%s\",%s", fact->quantity, fact->unit);
            for (int q = 0; q < n; q++) {
                const struct postproc_fact *its = postproc_facts_find(&run[q]->facts, fact->quantity);
                cell[rows * m + 2 + q] = its ? its->text : "";
                fprintf(file, ",\"%s\"", its ? its->text : "");
            }
            fputc('\n', file);
            rows++;
        }
    postproc_report_table(report, rows, m, cell);
    const int bad = ferror(file);
    return atomic_write_close(file, path, bad);
}

static int compare(int n, struct postproc_history *const *run, const char *const *label, const char *out) {
    struct postproc_output *output[RUNS_MAX];
    struct postproc_charts charts = {0};
    char plots[FOLDER_PATH];
    int fault = folder_make_path(folder_path(plots, out, "plots"));
    struct postproc_report *report = fault ? NULL : postproc_report_begin(out, "Runs compared");
    if (!report) return fault ? fault : errno;
    postproc_charts_draw(&charts, n, run, label, plots);
    postproc_charts_crack_draw(&charts, n, run, label, plots);
    for (int kind = 0; kind < POSTPROC_MEASURES; kind++)
        pdfs_draw(&charts, n, run, label, plots, (enum postproc_measure)kind);
    for (int r = 0; r < n; r++) {
        output[r] = arena_new(1, sizeof *output[r]);
        postproc_sections_run(output[r], run[r]);
        postproc_sections_medium(output[r], run[r]);
        postproc_sections_fracture(output[r], run[r]);
        postproc_sections_crack_numbers(output[r], run[r]);
        postproc_sections_crack_fluid_numbers(output[r], run[r]);
        postproc_sections_wall(output[r], run[r]);
    }
    postproc_gnuplot_end();
    if (table_write(report, n, (const struct postproc_output *const *)output, label, out)) fault = errno;
    for (int k = 0; k < charts.n; k++) {
        char path[128];
        snprintf(path, sizeof path, "plots/%s.png", charts.name[k]);
        postproc_report_image(report, path, charts.title[k]);
    }
    if (charts.worst != POSTPROC_PLOT_DONE) {
        postproc_report_text(report,
                             "Plots are missing: gnuplot was not found or failed. Their scripts are in plots (*.gp).");
        fprintf(stderr, "frana: %s: plots are missing: gnuplot was not found or failed\n", out);
    }
    if (postproc_report_end(report) && !fault) fault = errno ? errno : EIO;
    if (!fault) printf("%s: report.md, report.html, summary.csv, %d plots of %d runs\n", out, charts.n, n);
    return fault;
}

int postproc_compare(int n, const char *const *rundir, const char *out) {
    struct postproc_history *run[RUNS_MAX];
    char name[RUNS_MAX][64], error[FOLDER_PATH + 256];
    const char *label[RUNS_MAX];
    if (n < 1 || n > RUNS_MAX) {
        fprintf(stderr, "frana: post: %d run folders: 1 to %d can be compared\n", n, RUNS_MAX);
        return EXIT_CODE_SCENE;
    }
    int have = 0, fault = 0, code = EXIT_CODE_DONE;
    for (; have < n; have++) {
        run[have] = postproc_history_new(rundir[have], error, sizeof error);
        if (!run[have]) break;
        label_of(rundir[have], name[have]);
        label[have] = name[have];
    }
    if (have < n) {
        fprintf(stderr, "frana: %s\n", error);
        code = EXIT_CODE_FILE;
    } else if ((fault = compare(n, run, label, out)) != 0) {
        fprintf(stderr, "frana: %s: cannot be written: %s\n", out, strerror(fault));
        code = EXIT_CODE_FILE;
    }
    for (int r = 0; r < have; r++) postproc_history_free(run[r]);
    return code;
}
