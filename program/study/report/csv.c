/* Writes NAME.csv: one row for each method, level and quantity. */
#include "base/arena.h"
#include "base/files/atomic_write.h"
#include "base/files/csv.h"
#include "base/files/folder.h"
#include "program/study/report/report.h"

#include <math.h>

/* Writes an empty cell if there is not a number. */
void study_csv_put(FILE *f, double x, int digits) {
    fputc(',', f);
    if (isfinite(x)) fprintf(f, "%.*g", digits, x);
}

void study_csv_put_names(FILE *f, const struct study *s, const struct study_table *t, int method, int level,
                         double number) {
    csv_put(f, s->methods.variant[method].name);
    fputc(',', f);
    csv_put(f, s->levels.variant[level].name);
    study_csv_put(f, number, 10);
    fputc(',', f);
    csv_put(f, t->quantity->name);
    fputc(',', f);
    csv_put(f, t->quantity->unit);
}

void study_csv_put_head(FILE *f, const struct study *s, const struct study_maker *m) {
    fprintf(f, "# %s\n# machine: %s, %d cores\n# compiler: %s, %s\n", s->title, m->processor, m->cores, m->compiler,
            m->flags);
    fprintf(f, "# frana: %s, revision %s\n# libraries: %s, FFTW %s\n# date: %s\n", m->version, m->revision, m->mpi,
            m->fftw, m->date);
}

static void put_head(FILE *f, const struct study_result *r, const struct study_maker *m) {
    const struct study *s = r->plan->study;
    study_csv_put_head(f, s, m);
    if (s->members.n > 0)
        fprintf(f, "# ensemble: value is the mean of %d runs from %s to %s, value_spread their standard deviation\n",
                s->members.n, s->members.text[0], s->members.text[s->members.n - 1]);
    for (int q = 0; q < r->tables; q++) {
        fprintf(f, "# reference of %s: %s\n", r->table[q].quantity->name, study_report_reference(r, &r->table[q]));
        char *advice = study_advice_write(r, &r->table[q]);
        if (*advice) fprintf(f, "# advice on %s: %s\n", r->table[q].quantity->name, advice);
    }
    fputs("method,level,size,quantity,unit,value,reference,uncertainty,error,relative_error,order,wall_"
          "median_s,"
          "wall_min_s,wall_iqr_s,setup_s,steps,ns_per_cell_step,ns_per_bond_sweep,memory_mb,ranks,repeats,"
          "value_spread,status\n",
          f);
}

static void put_row(FILE *f, const struct study_result *r, const struct study_table *t, int method, int level) {
    const struct study *s = r->plan->study;
    const struct study_point *p = study_result_point(r, t, method, level);
    char status[32];
    study_csv_put_names(f, s, t, method, level, s->levels.variant[level].size);
    study_csv_put(f, p->value, 15);
    study_csv_put(f, t->reference, 15);
    study_csv_put(f, t->uncertainty, 6);
    study_csv_put(f, p->error, 6);
    study_csv_put(f, p->relative, 6);
    study_csv_put(f, p->order, 4);
    study_csv_put(f, p->wall, 6);
    study_csv_put(f, p->wall_min, 6);
    study_csv_put(f, p->wall_iqr, 4);
    study_csv_put(f, p->setup, 4);
    fprintf(f, ",%ld", p->steps);
    study_csv_put(f, p->cell_step, 5);
    study_csv_put(f, p->bond_sweep, 5);
    study_csv_put(f, 1e-6 * p->memory, 5);
    fprintf(f, ",%d,%d", p->ranks, p->repeats);
    study_csv_put(f, p->spread, 4);
    fputc(',', f);
    csv_put(f, study_report_status(p, status));
    fputc('\n', f);
}

void study_csv_write(const struct study_result *r, const struct study_maker *maker, const char *out) {
    const struct study *s = r->plan->study;
    char path[FOLDER_PATH];
    struct atomic_write a;
    atomic_write_begin(&a, folder_path(path, out, arena_text("%s.csv", s->name)));
    put_head(a.file, r, maker);
    for (int q = 0; q < r->tables; q++)
        for (int m = 0; m < s->methods.n; m++)
            for (int l = 0; l < s->levels.n; l++) put_row(a.file, r, &r->table[q], m, l);
    atomic_write_end(&a);
}
