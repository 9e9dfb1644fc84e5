/* Reads a curve from a table of a run. */
#include "program/study/runs/curve.h"
#include "base/arena.h"
#include "base/files/table.h"
#include "program/study/expression.h"
#include "program/study/text.h"
#include "scene/text/problem.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A row of a table; missing: the name of a column that the table does not have. */
struct row {
    const struct table_data *table;
    const double *value;
    char **missing;
};

static double cell(const char *name, const void *with) {
    const struct row *r = with;
    const int at = table_read_column(r->table, name);
    if (at < 0 && !*r->missing) *r->missing = arena_text("%s", name);
    return at < 0 ? NAN : r->value[at];
}

static double value(const struct row *r, const char *column, const char **why) {
    return strchr(column, '[') ? study_expression_value(column, cell, r, why) : cell(column, r);
}

/* COLUMN = VALUE, taken apart: the column, NULL without `=`; *number: the value. */
static char *condition(const char *where, double *number) {
    const char *sign = strchr(where, '=');
    if (!sign) return NULL;
    size_t length = (size_t)(sign - where);
    while (length > 0 && where[length - 1] == ' ') length--;
    *number = study_text_number(sign + 1 + strspn(sign + 1, " "));
    return arena_text("%.*s", (int)length, where);
}

static void no_column(const struct table_data *d, const char *path, const char *name, char **why) {
    *why = arena_text("%s has no column %s%s", path, name,
                      scene_problem_hint(name, d->columns, (const char *const *)d->name).text);
}

/* Fills the curve; returns what is wrong with the arithmetic, or NULL. */
static const char *fill(struct study_curve *c, const struct table_data *d, const char *column,
                        const char *condition_column, double is, char **missing) {
    const int t = table_read_column(d, "t");
    const char *why = NULL;
    for (long i = 0; i < d->rows && !why && !*missing; i++) {
        const struct row r = {d, d->value + i * d->columns, missing};
        if (condition_column && cell(condition_column, &r) != is) continue;
        c->t[c->n] = t < 0 ? (double)(i + 1) : r.value[t];
        c->x[c->n++] = value(&r, column, &why);
    }
    return why;
}

int study_curve_read(struct study_curve *c, const char *path, const char *column, const char *where, char **why,
                     int *wrong) {
    const char *error = NULL;
    struct table_data *d = table_read(path, &error);
    double is = NAN;
    char *condition_column = where ? condition(where, &is) : NULL, *missing = NULL;
    *c = (struct study_curve){0};
    if (!d) {
        *why = arena_text("%s: %s", path, error);
    } else if (where && (!condition_column || isnan(is))) {
        *why = arena_text("where: %s: must be COLUMN = NUMBER", where);
        *wrong = 1;
    } else {
        c->t = calloc((size_t)d->rows + 1, sizeof *c->t);
        c->x = calloc((size_t)d->rows + 1, sizeof *c->x);
        error = fill(c, d, column, condition_column, is, &missing);
        *wrong = error || missing;
        if (error)
            *why = arena_text("%s: %s", column, error);
        else if (missing)
            no_column(d, path, missing, why);
    }
    table_read_free(d);
    if (!*why) return 1;
    study_curve_free(c);
    return 0;
}

void study_curve_free(struct study_curve *c) {
    free(c->t);
    free(c->x);
    *c = (struct study_curve){0};
}
