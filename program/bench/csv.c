/* Reads a CSV table of measured times. */
#include "program/bench/csv.h"
#include "base/die.h"
#include "base/ensure.h"
#include "base/files/plain_file.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LINE = 4096 };

/* Splits a line at its commas. Returns the number of cells, which are malloc'ed into cell [at most]. */
static int cut(char *line, char **cell, int most) {
    int n = 0;
    line[strcspn(line, "\r\n")] = '\0';
    for (char *at = line; at && n < most; n++) {
        char *comma = strchr(at, ',');
        if (comma) *comma = '\0';
        cell[n] = strdup(at);
        at = comma ? comma + 1 : NULL;
    }
    return n;
}

static void add_row(struct bench_csv *c, char **cell) {
    const size_t columns = (size_t)c->columns;
    c->cell = realloc(c->cell, (size_t)(c->rows + 1) * columns * sizeof *c->cell);
    ENSURE(c->cell, "no memory for %d rows", c->rows);
    memcpy(c->cell + (size_t)c->rows++ * columns, cell, columns * sizeof *cell);
}

struct bench_csv *bench_csv_read(struct bench_csv *cells, const char *path) {
    char line[LINE], *cell[64];
    FILE *file = plain_file_read(path);
    if (!file) die(EXIT_CODE_FILE, "%s: cannot be opened (%s)", path, strerror(errno));
    if (!fgets(line, sizeof line, file)) die(EXIT_CODE_FILE, "%s: is empty", path);
    const int columns = cut(line, cell, 64);
    if (!cells) {
        cells = calloc(1, sizeof *cells);
        cells->columns = columns;
        cells->name = calloc((size_t)columns, sizeof *cells->name);
        memcpy(cells->name, cell, (size_t)columns * sizeof *cell);
    } else {
        for (int k = 0; k < columns; k++) {
            if (columns != cells->columns || strcmp(cell[k], cells->name[k]))
                die(EXIT_CODE_FILE, "%s: has other columns than the table before it", path);
            free(cell[k]);
        }
    }
    while (fgets(line, sizeof line, file)) {
        if (cut(line, cell, 64) != columns)
            die(EXIT_CODE_FILE, "%s: a row has not the %d cells of its header", path, columns);
        add_row(cells, cell);
    }
    fclose(file);
    return cells;
}

void bench_csv_free(struct bench_csv *c) {
    if (!c) return;
    for (int k = 0; k < c->columns; k++) free(c->name[k]);
    for (int k = 0; k < c->rows * c->columns; k++) free(c->cell[k]);
    free(c->name);
    free(c->cell);
    free(c);
}

const char *bench_csv_text(const struct bench_csv *c, int row, const char *column) {
    for (int k = 0; row >= 0 && k < c->columns; k++)
        if (!strcmp(c->name[k], column)) return c->cell[row * c->columns + k];
    return "";
}

double bench_csv_number(const struct bench_csv *c, int row, const char *column) {
    const char *text = bench_csv_text(c, row, column);
    return *text ? strtod(text, NULL) : NAN;
}

int bench_csv_find(const struct bench_csv *c, const char *part, const char *size, int ranks) {
    for (int row = 0; row < c->rows; row++)
        if (!strcmp(bench_csv_text(c, row, "part"), part) &&
            (!*size || !strcmp(bench_csv_text(c, row, "size"), size)) &&
            (!ranks || (int)bench_csv_number(c, row, "ranks") == ranks))
            return row;
    return -1;
}
