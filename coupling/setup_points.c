/* Particles of a point file: x y z volume [horizon] a line, of a plate x y area [horizon]. */
#include "base/par.h"
#include "coupling/setup_parts.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { COLUMNS_MAX = 5 };

/* The numbers of a line: how many there are, COLUMNS_MAX + 1 for more than that, -1 for something else in it. */
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

/* Whether place, volume and horizon are numbers that a particle can have. */
static int is_particle(const double *value, int dim, int columns) {
    for (int c = 0; c < columns; c++)
        if (!isfinite(value[c]) || (c >= dim && value[c] <= 0)) return 0;
    return 1;
}

/* Row by row; dies on a line that is not a particle. Returns the lines, *columns a line. */
static double *read_rows(const struct scene_body *from, int dim, long *lines, int *columns) {
    const char *what = dim == 2 ? "x y area, or x y area horizon" : "x y z volume, or x y z volume horizon";
    FILE *file = fopen(from->file, "r");
    if (!file) die(EXIT_CODE_FILE, "%s: the point file of body %s can't be opened", from->file, from->name);
    double *row = NULL, value[COLUMNS_MAX];
    char *line = NULL;
    size_t size = 0;
    long capacity = 0, at = 0;
    *lines = *columns = 0;
    while (getline(&line, &size, file) > 0) {
        const int n = numbers_of(line, value);
        at++;
        if (n == 0) continue;
        if (*columns == 0 && (n == dim + 1 || n == dim + 2)) *columns = n;
        if (n != *columns && *columns > 0 && (n == dim + 1 || n == dim + 2))
            die(EXIT_CODE_FILE, "%s: line %ld has %s horizon, unlike those before it", from->file, at,
                n == dim + 1 ? "no" : "a");
        if (n != *columns) die(EXIT_CODE_FILE, "%s: line %ld is not the numbers %s", from->file, at, what);
        if (!is_particle(value, dim, n))
            die(EXIT_CODE_FILE, "%s: line %ld: %s must be greater than 0 and everything finite", from->file,
                at, dim == 2 ? "area and horizon" : "volume and horizon");
        if (*lines == capacity) row = realloc(row, (size_t)(capacity = 2 * capacity + 64) * sizeof value);
        ENSURE(row, "no memory for %ld points", capacity);
        memcpy(row + *lines * n, value, (size_t)n * sizeof *row);
        ++*lines;
    }
    free(line);
    fclose(file);
    if (*lines == 0) die(EXIT_CODE_FILE, "%s: holds no line %s", from->file, what);
    return row;
}

void setup_points(const struct scene_body *from, int dim, struct solid_body *to) {
    double *row = NULL;
    long lines = 0;
    int columns = 0;
    if (par_rank() == 0) row = read_rows(from, dim, &lines, &columns);
    par_bcast(&lines, sizeof lines, 0);
    par_bcast(&columns, sizeof columns, 0);
    double *column = malloc((size_t)lines * (size_t)columns * sizeof *column);
    ENSURE(column, "no memory for %ld points", lines);
    for (long i = 0; row && i < lines; i++)
        for (int c = 0; c < columns; c++) column[c * lines + i] = row[i * columns + c];
    free(row);
    par_bcast(column, (size_t)lines * (size_t)columns * sizeof *column, 0);
    to->points = lines;
    for (int c = 0; c < dim; c++) to->point[c] = column + c * lines;
    to->point_volume = column + dim * lines;
    to->point_horizon = columns == dim + 2 ? column + (dim + 1) * lines : NULL;
}
