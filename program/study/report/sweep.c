/* Writes the report of a sweep: medians and bands against the swept key. */
#include "base/arena.h"
#include "base/files/atomic_write.h"
#include "base/files/csv.h"
#include "base/files/folder.h"
#include "postproc/charts/plot.h"
#include "program/study/report/report.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const struct study *study_of(const struct study_result *r) { return r->plan->study; }

/* repeats: runs of the point in all. Runs that are done may be without a value, such as a time that is not reached. */
static const char *status_of(const struct study_point *p, int repeats, char status[64]) {
    const char *between = "";
    int n = 0;
    const struct {
        int runs;
        const char *what;
    } part[] = {{p->failed, "failed"},
                {p->unmade, "not run"},
                {p->repeats > 0 ? repeats - p->failed - p->unmade - p->repeats : 0, "without a value"}};
    for (int k = 0; k < 3; k++)
        if (part[k].runs > 0) {
            n += snprintf(status + n, (size_t)(64 - n), "%s%d %s", between, part[k].runs, part[k].what);
            between = "; ";
        }
    if (n == 0) snprintf(status, 64, "%s", p->repeats ? "done" : "no value");
    return status;
}

static void put_row(FILE *f, const struct study_result *r, const struct study_table *t, int method, int level) {
    const struct study_point *p = study_result_point(r, t, method, level);
    char status[64];
    study_csv_put_names(f, study_of(r), t, method, level, study_of(r)->levels.variant[level].at);
    study_csv_put(f, p->value, 15);
    for (int e = 0; e < STUDY_BAND_ENDS; e++) study_csv_put(f, p->band[e], 15);
    study_csv_put(f, p->mean, 15);
    study_csv_put(f, p->deviation, 6);
    fprintf(f, ",%d,%d,%d", p->repeats, p->failed, p->unmade);
    study_csv_put(f, p->wall, 6);
    fprintf(f, ",%d,", p->ranks);
    csv_put(f, status_of(p, study_of(r)->repeats, status));
    fputc('\n', f);
}

/* Begins OUT/NAME + ending. */
static void begin(struct atomic_write *a, const struct study_result *r, const char *out, const char *ending) {
    char path[FOLDER_PATH];
    atomic_write_begin(a, folder_path(path, out, arena_text("%s%s", study_of(r)->name, ending)));
}

static void put_points(FILE *f, const struct study_result *r) {
    const struct study *s = study_of(r);
    fputs(
        "# value: median of the runs; lower, upper: their quartiles; least, most: their range\n"
        "method,level,at,quantity,unit,value,least,lower,upper,most,mean,deviation,values,failed,not_run,wall_median_s,"
        "ranks,status\n",
        f);
    for (int q = 0; q < r->tables; q++)
        for (int m = 0; m < s->methods.n; m++)
            for (int l = 0; l < s->levels.n; l++) put_row(f, r, &r->table[q], m, l);
}

static void put_run(FILE *f, const struct study_result *r, const struct study_run *run, int q) {
    static const char *const state[] = {
        [STUDY_TODO] = "not run", [STUDY_DONE] = "done", [STUDY_FAILED] = "failed", [STUDY_SKIPPED] = "left out"};
    const struct study_case *c = &r->plan->at[run->at];
    study_csv_put_names(f, study_of(r), &r->table[q], c->method, c->level, study_of(r)->levels.variant[c->level].at);
    fprintf(f, ",%d,", run->repeat + 1);
    csv_put(f, run->member ? run->member : "");
    study_csv_put(f, run->value[q], 15);
    study_csv_put(f, run->outcome.wall, 6);
    fprintf(f, ",%s,", state[run->outcome.state]);
    csv_put(f, run->folder);
    fputc('\n', f);
}

static void put_runs(FILE *f, const struct study_result *r) {
    fputs("method,level,at,quantity,unit,repeat,member,value,wall_s,status,folder\n", f);
    for (int q = 0; q < r->tables; q++)
        for (int i = 0; i < r->plan->runs; i++) put_run(f, r, &r->plan->run[i], q);
}

/* A method's medians and bands. */
static struct postproc_curve curve_new(const struct study_result *r, const struct study_table *t, int method) {
    const struct study *s = study_of(r);
    const size_t n = (size_t)s->levels.n;
    double *x = arena_new(n, sizeof *x), *y = arena_new(n, sizeof *y),
           *band = arena_new(n, sizeof *band * STUDY_BAND_ENDS);
    for (int l = 0; l < s->levels.n; l++) {
        const struct study_point *p = study_result_point(r, t, method, l);
        x[l] = s->levels.variant[l].at;
        y[l] = p->value;
        memcpy(&band[l * STUDY_BAND_ENDS], p->band, sizeof p->band);
    }
    return (struct postproc_curve){.title = s->methods.variant[method].name,
                                   .n = s->levels.n,
                                   .x = x,
                                   .y = y,
                                   .points = 1,
                                   .band = s->repeats > 1 ? band : NULL};
}

/* Whether all numbers are positive and span more than this factor, so that an axis is logarithmic. */
static int spans(const double *x, int n, double factor) {
    double low = INFINITY, high = 0;
    for (int i = 0; i < n; i++) {
        if (isnan(x[i])) continue;
        low = fmin(low, x[i]);
        high = fmax(high, x[i]);
    }
    return low > 0 && high > factor * low;
}

static int log_y(const struct postproc_curve *curve, int curves) {
    int spanned = 0;
    for (int k = 0; k < curves; k++) {
        for (long i = 0; i < curve[k].n; i++)
            if (curve[k].y[i] <= 0 || (curve[k].band && curve[k].band[i * STUDY_BAND_ENDS] <= 0)) return 0;
        spanned |= spans(curve[k].y, (int)curve[k].n, 100);
    }
    return spanned;
}

/* Whether there are values at two places of the axis at least, so that there is something to draw. */
static int extends(const struct postproc_curve *curve, int curves) {
    double low = INFINITY, high = -INFINITY;
    for (int k = 0; k < curves; k++)
        for (long i = 0; i < curve[k].n; i++)
            if (!isnan(curve[k].y[i])) {
                low = fmin(low, curve[k].x[i]);
                high = fmax(high, curve[k].x[i]);
            }
    return high > low;
}

/* Draws a quantity against the swept key. Returns whether gnuplot succeeded. */
static int draw(const struct study_result *r, struct study_table *t, const char *out) {
    const struct study *s = study_of(r);
    struct postproc_curve *curve = arena_new((size_t)s->methods.n, sizeof *curve);
    for (int m = 0; m < s->methods.n; m++) curve[m] = curve_new(r, t, m);
    if (!extends(curve, s->methods.n)) return 1;
    char *name = study_report_name(r, t),
         *label = arena_text("%s%s%s%s", t->quantity->name, *t->quantity->unit ? "  [" : "", t->quantity->unit,
                             *t->quantity->unit ? "]" : "");
    const enum postproc_plot_status status = postproc_plot_draw(&(struct postproc_plot){
        .folder = out,
        .name = name,
        .title = s->title,
        .xlabel = s->axis,
        .ylabel = label,
        .curves = s->methods.n,
        .curve = curve,
        .log_x = spans(curve[0].x, s->levels.n, 30),
        .log_y = log_y(curve, s->methods.n),
        .whole = 1,
    });
    t->plotted = status == POSTPROC_PLOT_DONE;
    return t->plotted;
}

static void put_cell(FILE *f, double x, int digits) {
    if (isfinite(x))
        fprintf(f, "| %.*g ", digits, x);
    else
        fputs("| – ", f);
}

static void put_table(FILE *f, const struct study_result *r, const struct study_table *t) {
    const struct study *s = study_of(r);
    fprintf(
        f,
        "| method | %s | median | lower quartile | upper quartile | least | most | values | wall s, median | status "
        "|\n|---|---|--:|--:|--:|--:|--:|--:|--:|---|\n",
        s->axis ? s->axis : "point");
    for (int m = 0; m < s->methods.n; m++)
        for (int l = 0; l < s->levels.n; l++) {
            const struct study_point *p = study_result_point(r, t, m, l);
            static const int end[] = {STUDY_LOWER, STUDY_UPPER, STUDY_LEAST, STUDY_MOST};
            char status[64];
            fprintf(f, "| %s | %s ", s->methods.variant[m].name, s->levels.variant[l].name);
            put_cell(f, p->value, 6);
            for (int e = 0; e < STUDY_BAND_ENDS; e++) put_cell(f, p->band[end[e]], 6);
            fprintf(f, "| %d ", p->repeats);
            put_cell(f, p->wall, 4);
            fprintf(f, "| %s |\n", status_of(p, study_of(r)->repeats, status));
        }
}

static void put_page(FILE *f, const struct study_result *r, const struct study_maker *m) {
    const struct study *s = study_of(r);
    fprintf(
        f,
        "# %s\n\nA sweep: it compares with no reference, and claims no error. Made on %s, %d cores, by frana %s (%s), "
        "%s.\n",
        s->title, m->processor, m->cores, m->version, m->revision, m->date);
    if (s->members.n > 0)
        fprintf(f, "Each point is an ensemble of %d runs, `%s` to `%s`.\n", s->members.n, s->members.text[0],
                s->members.text[s->members.n - 1]);
    for (int q = 0; q < r->tables; q++) {
        const struct study_table *t = &r->table[q];
        char *name = study_report_name(r, t);
        fprintf(f, "\n## %s%s%s%s\n\n", t->quantity->name, *t->quantity->unit ? " [" : "", t->quantity->unit,
                *t->quantity->unit ? "]" : "");
        put_table(f, r, t);
        if (t->plotted) fprintf(f, "\n![%s against %s](%s.png)\n", t->quantity->name, s->axis, name);
        if (t->plotted && s->repeats > 1)
            fputs(
                "\nLines are medians, the shaded bands go from quartile to quartile, the dotted lines are the range.\n",
                f);
    }
}

int study_sweep_write(struct study_result *r, const struct study_maker *maker, const char *out) {
    struct atomic_write a;
    int plotted = 1;
    for (int q = 0; q < r->tables && study_of(r)->axis; q++) plotted &= draw(r, &r->table[q], out);
    begin(&a, r, out, ".csv");
    study_csv_put_head(a.file, study_of(r), maker);
    put_points(a.file, r);
    atomic_write_end(&a);
    begin(&a, r, out, "_runs.csv");
    study_csv_put_head(a.file, study_of(r), maker);
    put_runs(a.file, r);
    atomic_write_end(&a);
    begin(&a, r, out, ".md");
    put_page(a.file, r, maker);
    atomic_write_end(&a);
    return plotted;
}
