/* Writes a CSV table row by row, and cuts it back to a step on resume. */
#include "base/files/table.h"
#include "base/clock.h"
#include "base/die.h"
#include "base/par.h"
#include "base/files/atomic_write.h"
#include "base/files/log.h"
#include "base/files/plain_file.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct table {
    int columns;
    FILE *file; /* rank 0 */
    char path[1024];
};

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

/* Copies the rows to keep character by character, so that numbers keep their digits. A last row without an end of line
 * was cut off by a crash and is dropped. */
static void copy_rows(FILE *from, FILE *to, int step_column, long last_step) {
    char *line = NULL;
    size_t bytes = 0;
    for (ssize_t n, number = 0; (n = getline(&line, &bytes, from)) > 0; number++) {
        if (line[n - 1] != '\n') break;
        if (number < 2) continue; /* names and units */
        const char *at = line;
        for (int c = 0; c < step_column && at; c++) {
            at = strchr(at, ',');
            if (at) at++;
        }
        char *end = NULL;
        const double step = at ? strtod(at, &end) : NAN;
        if (at && end != at && step <= (double)last_step) fputs(line, to);
    }
    free(line);
}

/* Returns a sentence on the fault, or NULL. */
static const char *cut(const char *path, int columns, const char *const *name, const char *const *unit,
                       long resume_step) {
    const char *error = NULL;
    struct table_data *old = table_read(path, &error);
    if (!old) return error;
    int step_column = table_read_column(old, "step");
    if (step_column < 0) step_column = 0;
    if (!has_columns(old, columns, name)) error = "it has other columns than this run writes";
    table_read_free(old);
    if (error) return error;
    FILE *from = plain_file_read(path);
    if (!from) return plain_file_why(errno);
    struct atomic_write a;
    atomic_write_begin(&a, path);
    header(a.file, "", columns, name);
    header(a.file, "#", columns, unit);
    copy_rows(from, a.file, step_column, resume_step);
    fclose(from);
    atomic_write_end(&a);
    return NULL;
}

static const char *begin(struct table *t, const char *const *name, const char *const *unit, long resume_step) {
    FILE *old = resume_step >= 0 ? plain_file_read(t->path) : NULL;
    if (old) {
        fclose(old);
        const char *error = cut(t->path, t->columns, name, unit, resume_step);
        if (error) return error;
    }
    t->file = plain_file_write(t->path, old != NULL);
    if (!t->file) return plain_file_why(errno);
    if (!old && resume_step > 0) log_line("%s is not there: it begins after step %ld", t->path, resume_step);
    if (!old) {
        header(t->file, "", t->columns, name);
        header(t->file, "#", t->columns, unit);
    }
    return fflush(t->file) == 0 ? NULL : strerror(errno);
}

/* On rank 0: sentence "" if all rows are there. Returns how many are. */
static long find_missing(const char *path, long step, long rows, char sentence[256]) {
    struct table_data *old = table_read(path, NULL);
    const int c = old ? table_read_column(old, "step") : -1;
    long found = 0, rising = 1;
    for (long k = 0; c >= 0 && k < old->rows; k++) {
        const double at = old->value[k * old->columns + c];
        if (at > (double)step) continue;
        rising &= k == 0 || at > old->value[(k - 1) * old->columns + c];
        found++;
    }
    if (c >= 0 && found != rows)
        snprintf(sentence, 256, "has %ld rows up to step %ld, and %ld were written", found, step, rows);
    else if (!rising)
        snprintf(sentence, 256, "has rows up to step %ld that are not in their order", step);
    table_read_free(old);
    return found;
}

const char *table_misses(const char *path, long step, long *rows) {
    static char sentence[256];
    sentence[0] = '\0';
    if (par_rank() == 0) *rows = find_missing(path, step, *rows, sentence);
    par_bcast(rows, sizeof *rows, 0);
    par_bcast(sentence, sizeof sentence, 0);
    return sentence[0] ? sentence : NULL;
}

struct table *table_new(const char *path, int columns, const char *const *name, const char *const *unit,
                        long resume_step) {
    struct table *t = calloc(1, sizeof *t);
    char sentence[256] = "";
    t->columns = columns;
    snprintf(t->path, sizeof t->path, "%s", path);
    if (par_rank() == 0) {
        const char *error = begin(t, name, unit, resume_step);
        if (error) snprintf(sentence, sizeof sentence, "%s", error);
    }
    par_bcast(sentence, sizeof sentence, 0);
    if (sentence[0]) die_all(EXIT_CODE_FILE, "%s: cannot be written: %s", path, sentence);
    return t;
}

/* A number with 15 digits. Whole numbers, whose digits are the same, are printed as such, which is faster. */
static void add_number(FILE *f, double value) {
    if (isnan(value))
        fputs("nan", f);
    else if (fabs(value) < 1e15 && value == (double)(long)value && !(value == 0 && signbit(value)))
        fprintf(f, "%ld", (long)value);
    else
        fprintf(f, "%.15g", value);
}

void table_add(struct table *t, const double *value) {
    FILE *f = t->file;
    if (!f) return;
    clock_begin(CLOCK_OUTPUT);
    for (int c = 0; c < t->columns; c++) {
        if (c) fputc(',', f);
        add_number(f, value[c]);
    }
    fputc('\n', f);
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

void table_free(struct table *t) {
    if (!t) return;
    if (t->file && fclose(t->file) != 0) die(EXIT_CODE_FILE, "%s: cannot be written: %s", t->path, strerror(errno));
    free(t);
}
