/* Reads a CSV table. */
#include "base/files/table.h"
#include "base/files/plain_file.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Splits a line at its commas, in place. Returns the number of parts; each is copied into *part. */
static int split(char *line, char ***part) {
    int n = 1;
    line[strcspn(line, "\r\n")] = '\0';
    for (const char *c = line; *c; c++) n += *c == ',';
    *part = calloc((size_t)n, sizeof **part);
    for (int k = 0; k < n; k++) (*part)[k] = strdup(strsep(&line, ","));
    return n;
}

static void drop(char **part, int n) {
    for (int k = 0; part && k < n; k++) free(part[k]);
    free(part);
}

/* Reads the numbers of a row; 0 if it does not have exactly `columns` of them. */
static int numbers(const char *line, int columns, double *value) {
    for (int c = 0; c < columns; c++) {
        char *end;
        value[c] = strtod(line, &end);
        if (end == line || *end != (c < columns - 1 ? ',' : '\n')) return 0;
        line = end + 1;
    }
    return 1;
}

static int read_rows(FILE *f, struct table_data *d) {
    char *line = NULL;
    size_t bytes = 0;
    long capacity = 0;
    int bad = 0;
    for (ssize_t n; !bad && (n = getline(&line, &bytes, f)) > 0;) {
        if (line[n - 1] != '\n') break; /* cut off by a crash */
        if (d->rows == capacity) {
            capacity = 2 * capacity + 64;
            d->value = realloc(d->value, (size_t)capacity * (size_t)d->columns * sizeof *d->value);
        }
        if (numbers(line, d->columns, d->value + d->rows * d->columns))
            d->rows++;
        else
            bad = 1;
    }
    free(line);
    return !bad;
}

struct table_data *table_read(const char *path, const char **error) {
    const char *why = NULL;
    char *line = NULL;
    size_t bytes = 0;
    if (!error) error = &why;
    FILE *f = plain_file_read(path);
    if (!f) {
        *error = plain_file_why(errno);
        return NULL;
    }
    struct table_data *d = calloc(1, sizeof *d);
    int units = 0;
    *error = NULL;
    if (getline(&line, &bytes, f) > 0 && line[0] != '#') d->columns = split(line, &d->name);
    if (d->columns == 0)
        *error = "it has no row of names";
    else if (getline(&line, &bytes, f) <= 0 || line[0] != '#')
        *error = "its second line gives no units";
    else if ((units = split(line + 1, &d->unit)) != d->columns)
        *error = "it has not as many units as names";
    else if (!read_rows(f, d))
        *error = "a row has not as many numbers as there are names";
    free(line);
    fclose(f);
    if (!*error) return d;
    drop(d->unit, units);
    d->unit = NULL;
    table_read_free(d);
    return NULL;
}

int table_read_column(const struct table_data *d, const char *name) {
    for (int c = 0; c < d->columns; c++)
        if (strcmp(d->name[c], name) == 0) return c;
    return -1;
}

void table_read_free(struct table_data *d) {
    if (!d) return;
    drop(d->name, d->columns);
    drop(d->unit, d->unit ? d->columns : 0);
    free(d->value);
    free(d);
}
