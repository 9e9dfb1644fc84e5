/* Writes NAME.md: tables, fits, and run times at equal error. */
#include "base/arena.h"
#include "base/files/atomic_write.h"
#include "base/files/folder.h"
#include "program/study/report/report.h"
#include "program/study/result/iso.h"

#include <math.h>
#include <stdlib.h>

static void put(FILE *f, double x, int digits) {
    fputs("| ", f);
    if (isfinite(x))
        fprintf(f, "%.*g ", digits, x);
    else
        fputs("– ", f);
}

/* 10 %, 0.3 %, or a plain number if errors have no scale. */
static char *error_text(const struct study_table *t, double error) {
    return t->has_scale ? arena_text("%.3g %%", 100 * error) : arena_text("%.3g", error);
}

/* Whether some run has these costs, which need columns of the table. */
static int has_cells(const struct study_result *r, const struct study_table *t) {
    for (int i = 0; i < r->plan->cases; i++)
        if (isfinite(t->point[i].cell_step)) return 1;
    return 0;
}

static int has_bonds(const struct study_result *r, const struct study_table *t) {
    for (int i = 0; i < r->plan->cases; i++)
        if (isfinite(t->point[i].bond_sweep)) return 1;
    return 0;
}

static void put_row(FILE *f, const struct study_result *r, const struct study_table *t, int method, int level,
                    int cells, int bonds) {
    const struct study *s = r->plan->study;
    const struct study_point *p = study_result_point(r, t, method, level);
    char status[32], *error = isfinite(p->relative) ? error_text(t, p->relative) : arena_text("–");
    fprintf(f, "| %s | %s ", s->methods.variant[method].name, s->levels.variant[level].name);
    put(f, p->value, 7);
    if (s->members.n > 0 && isfinite(p->spread)) fprintf(f, "± %.2g ", p->spread);
    fprintf(f, "| %s%s ", error, isfinite(p->relative) && !p->resolved ? " *" : "");
    put(f, p->order, 3);
    put(f, p->wall, 4);
    put(f, p->wall_min, 4);
    put(f, p->wall_iqr, 2);
    put(f, p->setup, 2);
    fprintf(f, "| %ld ", p->steps);
    if (cells) put(f, p->cell_step, 4);
    if (bonds) put(f, p->bond_sweep, 4);
    put(f, 1e-6 * p->memory, 4);
    fprintf(f, "| %d | %d | %s |\n", p->ranks, p->repeats, study_report_status(p, status));
}

static void put_table(FILE *f, const struct study_result *r, const struct study_table *t) {
    const struct study *s = r->plan->study;
    const int cells = has_cells(r, t), bonds = has_bonds(r, t), columns = 13 + cells + bonds;
    fprintf(f,
            "| method | level | %s%s%s%s | error | order | wall s, median | min | quartiles apart | set-up s "
            "| steps "
            "|%s%s memory MB | ranks | repeats | status |\n",
            t->quantity->name, *t->quantity->unit ? " [" : "", t->quantity->unit, *t->quantity->unit ? "]" : "",
            cells ? " ns a cell and step |" : "", bonds ? " ns a directed bond and sweep |" : "");
    for (int c = 0; c < columns + 1; c++) fputs(c < 2 || c == columns ? "|---" : "|--:", f);
    fputs("|\n", f);
    int unresolved = 0;
    for (int m = 0; m < s->methods.n; m++)
        for (int l = 0; l < s->levels.n; l++) {
            const struct study_point *p = study_result_point(r, t, m, l);
            put_row(f, r, t, m, l, cells, bonds);
            unresolved |= isfinite(p->relative) && !p->resolved;
        }
    if (unresolved)
        fputs("\n\\* not above the reference's uncertainty: it says no more than that, and no order is "
              "fitted to "
              "it.\n",
              f);
}

static void put_fits(FILE *f, const struct study_result *r, const struct study_table *t) {
    const struct study_variants *methods = &r->plan->study->methods, *levels = &r->plan->study->levels;
    fputc('\n', f);
    for (int m = 0; m < methods->n; m++) {
        const struct study_curve *c = &t->curve[m];
        const struct study_richardson *e = &c->richardson;
        fprintf(f, "* %s:", methods->variant[m].name);
        if (isfinite(c->order)) fprintf(f, " observed order %.2f in the size;", c->order);
        if (isfinite(c->gain)) fprintf(f, " error ∝ (wall time)^%.2f;", c->gain);
        if (c->finest < 0)
            fputs(" no value", f);
        else if (isfinite(e->order))
            fprintf(f,
                    " its finest levels converge %s with order %.2f%s to %.8g, and the grid convergence index of "
                    "%s is %.2g",
                    e->kind == STUDY_MONOTONE ? "monotonely" : "in oscillations", e->order,
                    e->capped ? ", by the formal order" : "", e->extrapolated, levels->variant[c->finest].name, e->gci);
        else if (e->kind == STUDY_UNKNOWN)
            fputs(" too few levels with a size to extrapolate", f);
        else
            fprintf(f, " its finest levels are %s: nothing can be extrapolated", study_richardson_name(e->kind));
        fputs(".\n", f);
    }
}

/* The time in which a method reaches an error. */
struct reach {
    double time; /* s; NAN: not reached, or already written */
    int at_most; /* 1: the error of its coarsest level is smaller */
};

/* "dual 1.3 s, uniform 6.2 s: 4.8 times as long". */
static void put_reached(FILE *f, const struct study_variants *methods, struct reach *reach, int reached) {
    struct reach best = {NAN, 0};
    for (int k = 0; k < reached; k++) { /* the fastest of those not yet written */
        int next = -1;
        for (int m = 0; m < methods->n; m++)
            if (isfinite(reach[m].time) && (next < 0 || reach[m].time < reach[next].time)) next = m;
        const struct reach its = reach[next];
        fprintf(f, "%s%s %s%.3g s", k ? ", " : "", methods->variant[next].name, its.at_most ? "at most " : "",
                its.time);
        if (k == 0)
            best = its;
        else if (!its.at_most)
            fprintf(f, ": %s%.3g times as long", best.at_most ? "at least " : "", its.time / best.time);
        reach[next].time = NAN;
    }
    fputs("\n", f);
}

/* Writes the times at one error. Returns 0 and writes nothing if fewer than two methods reach the error or if all reach
 * it at their coarsest level. */
static int put_iso(FILE *f, const struct study_result *r, const struct study_table *t, double at, double *work,
                   struct reach *reach) {
    const struct study_variants *methods = &r->plan->study->methods;
    const int levels = r->plan->study->levels.n;
    const double floor = t->uncertainty > 0 ? t->uncertainty / t->scale : 0;
    int reached = 0, between = 0;
    for (int m = 0; m < methods->n; m++) {
        study_result_curve(r, t, m, work, work + levels);
        reach[m].time = study_iso_time(levels, work, work + levels, at, floor, &reach[m].at_most);
        reached += isfinite(reach[m].time);
        between += isfinite(reach[m].time) && !reach[m].at_most;
    }
    if (reached < 2 || between < 1) return 0;
    fprintf(f, "* at %s error: ", error_text(t, at));
    put_reached(f, methods, reach, reached);
    return 1;
}

static void put_isos(FILE *f, const struct study_result *r, const struct study_table *t) {
    const struct study *s = r->plan->study;
    if (s->methods.n < 2) return;
    double *work = arena_new(2 * (size_t)s->levels.n, sizeof *work);
    struct reach *reach = arena_new((size_t)s->methods.n, sizeof *reach);
    int lines = 0;
    fputs("\nWall time at equal error, between the levels in logarithms:\n\n", f);
    for (int k = 0; k < STUDY_ROUND_ERRORS; k++) lines += put_iso(f, r, t, study_iso_round(k), work, reach);
    if (!lines) fputs("* no round error is reached by two methods.\n", f);
}

/* Writes by how much the values of repeats differ. */
static void put_spread(FILE *f, const struct study_result *r, const struct study_table *t) {
    double worst = 0;
    for (int i = 0; i < r->plan->cases; i++)
        if (t->point[i].spread > 1e-12 * fabs(t->point[i].value)) worst = fmax(worst, t->point[i].spread);
    if (worst > 0 && r->plan->study->members.n > 0)
        fprintf(f, "\nValues are means ± standard deviations of %d runs.\n", r->plan->study->members.n);
    else if (worst > 0)
        fprintf(f, "\nRepeats differ in the value by up to %.2g; the median is shown.\n", worst);
}

static void put_quantity(FILE *f, const struct study_result *r, const struct study_table *t) {
    char *advice = study_advice_write(r, t);
    fprintf(f, "\n## %s\n\nReference: %s.\n\n", t->quantity->name, study_report_reference(r, t));
    if (*advice) fprintf(f, "**%s.**\n\n", advice);
    put_table(f, r, t);
    put_spread(f, r, t);
    put_fits(f, r, t);
    put_isos(f, r, t);
    if (t->plotted) fprintf(f, "\n![error against wall time](%s.png)\n", study_report_name(r, t));
}

void study_page_write(const struct study_result *r, const struct study_maker *m, const char *out) {
    const struct study *s = r->plan->study;
    char path[FOLDER_PATH];
    struct atomic_write a;
    atomic_write_begin(&a, folder_path(path, out, arena_text("%s.md", s->name)));
    fprintf(a.file,
            "# %s\n\nMeasured on %s, %d cores, by frana %s (%s), %s with %s, %s, FFTW %s, %s. Wall seconds "
            "are of the "
            "steps; set-up is apart.\n",
            s->title, m->processor, m->cores, m->version, m->revision, m->compiler, m->flags, m->mpi, m->fftw, m->date);
    for (int q = 0; q < r->tables; q++) put_quantity(a.file, r, &r->table[q]);
    atomic_write_end(&a);
}
