/* Reads the particles of a body from a point file: x y z volume [horizon], in a plate x y area [horizon]. */
#include "base/die.h"
#include "base/ensure.h"
#include "base/par.h"
#include "base/text.h"
#include "coupling/setup/parts.h"
#include "scene/text/node.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { COLUMNS_MAX = 5 };

/* Reads the numbers of a line. Returns how many there are, COLUMNS_MAX + 1 if there are more, -1 if there is anything
 * else. */
static int numbers_of(const char *line, double value[COLUMNS_MAX]) {
    int n = 0;
    for (char *end;; line = end) {
        line += strspn(line, " \t\r\n,");
        if (!*line || *line == '#') return n;
        const double v = strtod(line, &end);
        if (end == line) return -1;
        if (n == COLUMNS_MAX) return COLUMNS_MAX + 1;
        value[n++] = v;
    }
}

static const char *what_of(int dim) {
    return dim == 2 ? "x y area, or x y area horizon" : "x y z volume, or x y z volume horizon";
}

/* Whether position, volume and horizon are valid for a particle. */
static int is_particle(const double *value, int dim, int columns) {
    for (int c = 0; c < columns; c++)
        if (!isfinite(value[c]) || (c >= dim && value[c] <= 0)) return 0;
    return 1;
}

struct rows {
    double *row; /* [lines][columns] */
    long lines, capacity;
    int columns;
    char *why; /* NULL, or the mistake, malloc'ed */
};

/* Adds the numbers of line number `at`. Returns 0, or 1 with a reason in why. */
static int take(struct rows *to, int dim, long at, int n, const double value[COLUMNS_MAX]) {
    const int is_one = n == dim + 1 || n == dim + 2;
    if (to->columns == 0 && is_one) to->columns = n;
    if (n != to->columns && is_one)
        to->why = text_new("line %ld has %s horizon, unlike those before it", at, n == dim + 1 ? "no" : "a");
    else if (n != to->columns)
        to->why = text_new("line %ld is not the numbers %s", at, what_of(dim));
    else if (!is_particle(value, dim, n))
        to->why = text_new("line %ld: %s must be greater than 0 and everything finite", at,
                           dim == 2 ? "area and horizon" : "volume and horizon");
    if (to->why) return 1;
    if (to->lines == to->capacity) {
        to->capacity = 2 * to->capacity + 64;
        to->row = realloc(to->row, (size_t)to->capacity * (size_t)n * sizeof *to->row);
        ENSURE(to->row, "no memory for %ld points", to->capacity);
    }
    memcpy(to->row + to->lines++ * n, value, (size_t)n * sizeof *value);
    return 0;
}

/* Reads lines until one that is no particle. */
static void read_lines(struct rows *to, FILE *file, int dim) {
    double value[COLUMNS_MAX];
    char *line = NULL;
    size_t size = 0;
    ssize_t bytes;
    for (long at = 1; !to->why && (bytes = getline(&line, &size, file)) > 0; at++) {
        const int n = strlen(line) == (size_t)bytes ? numbers_of(line, value) : -1; /* a zero byte does not end a
                                                                                     * line */
        if (n != 0) take(to, dim, at, n, value);
    }
    free(line);
    if (!to->why && to->lines == 0) to->why = text_new("holds no line %s", what_of(dim));
}

/* Reads all lines; dies on a line that is no particle. */
static struct rows read_rows(const struct scene_body *from, int dim) {
    struct rows rows = {0};
    FILE *file = fopen(from->file, "r");
    if (!file) die(EXIT_CODE_FILE, "%s: the point file of body %s can't be opened", from->file, from->name);
    read_lines(&rows, file, dim);
    fclose(file);
    if (!rows.why) return rows;
    char why[256];
    snprintf(why, sizeof why, "%s", rows.why);
    free(rows.why);
    free(rows.row);
    die(EXIT_CODE_FILE, "%s: %s", from->file, why);
}

void setup_points(const struct scene_body *from, int dim, struct solid_body *to) {
    struct rows rows = {0};
    if (par_rank() == 0) rows = read_rows(from, dim);
    long lines = rows.lines;
    int columns = rows.columns;
    par_bcast(&lines, sizeof lines, 0);
    par_bcast(&columns, sizeof columns, 0);
    double *column = malloc((size_t)lines * (size_t)columns * sizeof *column);
    ENSURE(column, "no memory for %ld points", lines);
    for (long i = 0; rows.row && i < lines; i++)
        for (int c = 0; c < columns; c++) column[c * lines + i] = rows.row[i * columns + c];
    free(rows.row);
    par_bcast(column, (size_t)lines * (size_t)columns * sizeof *column, 0);
    to->points = lines;
    for (int c = 0; c < dim; c++) to->point[c] = column + c * lines;
    to->point_volume = column + dim * lines;
    to->point_horizon = columns == dim + 2 ? column + (dim + 1) * lines : NULL;
}
