/* Reads the particles of a body from a point file: x y z volume [horizon], in a plate x y area [horizon]. */
#include "base/ensure.h"
#include "base/par.h"
#include "base/text.h"
#include "coupling/setup/lines.h"
#include "coupling/setup/parts.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *what_of(int dim) {
    return dim == 2 ? "x y area, or x y area horizon (as in 0.01 0.02 1e-6)"
                    : "x y z volume, or x y z volume horizon (as in 0.01 0.02 0.03 1e-9)";
}

/* Whether position, volume and horizon are valid for a particle. */
static int is_particle(const double *value, int dim, int columns) {
    for (int c = 0; c < columns; c++)
        if (!isfinite(value[c]) || (c >= dim && value[c] <= 0)) return 0;
    return 1;
}

/* Farthest from 0, spacings; as of a body on the lattice (solid/geometry/compound.c). */
static const double FARTHEST = 1e9;

struct rows {
    const struct scene_domain *domain;
    double spacing;
    long outside, outside_line; /* beyond the sides; the first one's line */
    double outside_at[3];
    int dim;
    double *row; /* [lines][columns] */
    long lines, capacity;
    int columns;
};

/* Takes a place into the period, and counts one beyond the other sides; to rounding. */
static void place(struct rows *to, long at, double *x) {
    const double *size = to->domain->size;
    double given[3] = {0};
    int is_in = 1;
    memcpy(given, x, (size_t)to->dim * sizeof *x);
    for (int c = 0; c < to->dim; c++) {
        const double slack = 1e-9 * size[c];
        if (x[c] >= -slack && x[c] <= size[c] + slack) continue;
        if (to->domain->periodic[c])
            x[c] -= size[c] * floor(x[c] / size[c]);
        else
            is_in = 0;
    }
    if (is_in) return;
    if (to->outside++ > 0) return;
    to->outside_line = at;
    memcpy(to->outside_at, given, sizeof given);
}

/* Adds the numbers of line number `at`. */
static char *take(void *with, long at, int n, const double *value) {
    struct rows *to = with;
    const int dim = to->dim, is_one = n == dim + 1 || n == dim + 2;
    if (to->columns == 0 && is_one) to->columns = n;
    if (n != to->columns && is_one)
        return text_new("line %ld has %s horizon, unlike those before it", at, n == dim + 1 ? "no" : "a");
    if (n != to->columns) return text_new("line %ld is not the numbers %s", at, what_of(dim));
    if (!is_particle(value, dim, n))
        return text_new("line %ld: %s must be greater than 0 and everything finite", at,
                        dim == 2 ? "area and horizon" : "volume and horizon");
    for (int c = 0; c < dim; c++)
        if (fabs(value[c]) > FARTHEST * to->spacing)
            return text_new("line %ld: %c = %g m is more than %g spacings from 0 (solid.spacing = %g m)", at, "xyz"[c],
                            value[c], FARTHEST, to -> spacing);
    if (to->lines == to->capacity) {
        to->capacity = 2 * to->capacity + 64;
        to->row = realloc(to->row, (size_t)to->capacity * (size_t)n * sizeof *to->row);
        ENSURE(to->row, "no memory for %ld points", to->capacity);
    }
    double *row = memcpy(to->row + to->lines++ * n, value, (size_t)n * sizeof *value);
    place(to, at, row);
    return NULL;
}

/* Reads all lines. *why: NULL, or why a line is not a particle. */
static struct rows read_rows(const struct scene_body *from, const struct scene_domain *domain, int dim, double spacing,
                             char **why) {
    struct rows rows = {.domain = domain, .spacing = spacing, .dim = dim};
    char what[SCENE_NAME + 32];
    snprintf(what, sizeof what, "point file of body %s", from->name);
    const long lines = setup_lines_read(from->own.file, what, take, &rows, why);
    if (!*why && lines == 0) *why = text_new("holds no line %s", what_of(dim));
    if (!*why && rows.outside == lines)
        *why = text_new("all of the %ld particles lie outside the domain, the first at x = %g m, y = %g m: are they in "
                        "m?",
                        lines, rows.outside_at[0], rows.outside_at[1]);
    return rows;
}

void setup_points(const struct scene_body *from, const struct scene_domain *domain, int dim, double spacing,
                  struct solid_body *to) {
    struct rows rows = {0};
    char *why = NULL;
    if (par_rank() == 0) rows = read_rows(from, domain, dim, spacing, &why);
    setup_lines_die(from->own.file, why);
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
    to->outside = rows.outside;
    to->outside_line = rows.outside_line;
    memcpy(to->outside_at, rows.outside_at, sizeof to->outside_at);
    par_bcast(&to->outside, sizeof to->outside, 0);
    par_bcast(&to->outside_line, sizeof to->outside_line, 0);
    par_bcast(to->outside_at, sizeof to->outside_at, 0);
    for (int c = 0; c < dim; c++) to->point[c] = column + c * lines;
    to->point_volume = column + dim * lines;
    to->point_horizon = columns == dim + 2 ? column + (dim + 1) * lines : NULL;
}
