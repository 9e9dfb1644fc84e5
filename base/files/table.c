/* Writes a CSV table row by row, and cuts it back to a checkpoint on resume. */
#include "base/files/table.h"
#include "base/clock.h"
#include "base/die.h"
#include "base/ensure.h"
#include "base/par.h"
#include "base/files/atomic_write.h"
#include "base/files/log.h"
#include "base/files/plain_file.h"
#include "base/files/table_rows.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { NUMBER = 32 }; /* bytes of a number and its comma */

struct table {
    int columns, step_column;
    FILE *file; /* rank 0, as all below */
    char path[1024];
    char *row;              /* [columns * NUMBER], work */
    struct table_rows rows; /* its rows */
    double last;            /* step of the last one */
    struct table *next;     /* another open one */
};

static struct table *open_tables;

static void header(FILE *f, const char *before, int columns, const char *const *text) {
    fputs(before, f);
    for (int c = 0; c < columns; c++) fprintf(f, "%s%s", c ? "," : "", text[c]);
    fputc('\n', f);
}

static int has_columns(const struct table_data *d, int columns, const char *const *name) {
    if (d->columns != columns) return 0;
    for (int c = 0; c < columns; c++)
        if (strcmp(d->name[c], name[c]) != 0) return 0;
    return 1;
}

static int step_column_of(int columns, const char *const *name) {
    for (int c = 0; c < columns; c++)
        if (strcmp(name[c], "step") == 0) return c;
    return 0;
}

/* Returns a sentence on the fault, or NULL. Rows that stay are copied character by character, so that numbers keep
 * their digits. */
static const char *cut(struct table *t, const char *const *name, const char *const *unit, long resume_step) {
    const char *error = NULL;
    struct table_data *old = table_read(t->path, &error);
    if (!old) return error;
    if (!has_columns(old, t->columns, name)) error = "it has other columns than this run writes";
    table_read_free(old);
    if (error) return error;
    FILE *from = plain_file_read(t->path);
    if (!from) return plain_file_why(errno);
    struct atomic_write a;
    atomic_write_begin(&a, t->path);
    header(a.file, "", t->columns, name);
    header(a.file, "#", t->columns, unit);
    t->rows = table_rows_copy(from, a.file, t->step_column, resume_step, table_rows_expected(t->path));
    fclose(from);
    atomic_write_end(&a);
    return NULL;
}

static const char *begin(struct table *t, const char *const *name, const char *const *unit, long resume_step) {
    FILE *old = resume_step >= 0 ? plain_file_read(t->path) : NULL;
    if (resume_step >= 0 && !old && errno != ENOENT) return plain_file_why(errno);
    if (old) {
        fclose(old);
        const char *error = cut(t, name, unit, resume_step);
        if (error) return error;
    }
    t->file = plain_file_write(t->path, old != NULL);
    if (!t->file) return plain_file_why(errno);
    if (!old && resume_step > 0) log_line("%s is not there: it begins after step %ld", t->path, resume_step);
    if (!old) {
        header(t->file, "", t->columns, name);
        header(t->file, "#", t->columns, unit);
    }
    t->row = malloc((size_t)t->columns * NUMBER);
    ENSURE(t->row, "no memory for a row");
    t->last = (double)resume_step;
    t->next = open_tables;
    open_tables = t;
    return fflush(t->file) == 0 ? NULL : strerror(errno);
}

struct table *table_new(const char *path, int columns, const char *const *name, const char *const *unit,
                        long resume_step) {
    struct table *t = calloc(1, sizeof *t);
    char sentence[256] = "";
    t->columns = columns;
    t->step_column = step_column_of(columns, name);
    snprintf(t->path, sizeof t->path, "%s", path);
    if (par_rank() == 0) {
        const char *error = begin(t, name, unit, resume_step);
        if (error) snprintf(sentence, sizeof sentence, "%s", error);
    }
    par_bcast(sentence, sizeof sentence, 0);
    if (sentence[0]) die_all(EXIT_CODE_FILE, "%s: cannot be written: %s", path, sentence);
    return t;
}

/* A number with 15 digits; returns their bytes. Whole numbers, whose digits are the same, are printed as such, which is
 * faster. */
static int put_number(char *to, double value) {
    if (isnan(value)) return snprintf(to, NUMBER, "nan");
    if (fabs(value) < 1e15 && value == (double)(long)value && !(value == 0 && signbit(value)))
        return snprintf(to, NUMBER, "%ld", (long)value);
    return snprintf(to, NUMBER, "%.15g", value);
}

double table_written(double value) {
    char text[NUMBER];
    put_number(text, value);
    return strtod(text, NULL);
}

void table_add(struct table *t, const double *value) {
    if (!t->file) return;
    clock_begin(CLOCK_OUTPUT);
    size_t n = 0;
    for (int c = 0; c < t->columns; c++) {
        n += (size_t)put_number(t->row + n, value[c]);
        t->row[n++] = c + 1 < t->columns ? ',' : '\n';
    }
    fwrite(t->row, 1, n, t->file);
    table_rows_add(&t->rows, t->row, n);
    t->last = value[t->step_column];
    clock_end(CLOCK_OUTPUT);
}

void table_flush(struct table *t) {
    if (!t->file) return;
    clock_begin(CLOCK_OUTPUT);
    if (fflush(t->file) != 0 || ferror(t->file))
        die(EXIT_CODE_FILE, "%s: cannot be written: %s", t->path, strerror(errno));
    clock_end(CLOCK_OUTPUT);
}

void table_row(struct table *t, const double *value) {
    table_add(t, value);
    table_flush(t);
}

/* The rows up to a step. A run that went back to an earlier state has written later ones. */
static struct table_rows rows_up_to(const struct table *t, long step) {
    if (t->last <= (double)step) return t->rows;
    FILE *file = plain_file_read(t->path);
    struct table_rows rows = {0};
    if (file) rows = table_rows_copy(file, NULL, t->step_column, step, NULL);
    if (file) fclose(file);
    return rows;
}

void table_all_rows(long step, char *text, size_t size) {
    memset(text, 0, size);
    if (par_rank() == 0)
        for (const struct table *t = open_tables; t; t = t->next) {
            const struct table_rows rows = rows_up_to(t, step);
            table_rows_describe(text, size, t->path, &rows);
        }
    par_bcast(text, size, 0);
}

void table_free(struct table *t) {
    if (!t) return;
    for (struct table **at = &open_tables; *at; at = &(*at)->next)
        if (*at == t) {
            *at = t->next;
            break;
        }
    if (t->file && fclose(t->file) != 0) die(EXIT_CODE_FILE, "%s: cannot be written: %s", t->path, strerror(errno));
    free(t->row);
    free(t);
}
