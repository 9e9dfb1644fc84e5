/* Puts the sparse matrix of the nonlocal operator together, and multiplies by it. */
#include "meshless/nonlocal/matrix.h"
#include "base/die.h"
#include "base/memory.h"
#include "base/par.h"
#include "base/par_ghost.h"
#include "base/sort.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Bonds of this length and a little more belong to the family: on a lattice delta is often a bond's length. */
static const double reach_slack = 1 + 1e-9;
/* Points nearer than this fraction of the spacing coincide. */
static const double coincident = 1e-9;

/* All points sorted into cells as wide as the horizon. */
struct cells {
    const struct meshless_matrix_input *in;
    double low[3], width[3];
    int n[3];
    long *start, *item; /* [cells + 2], [points] */
};

static int cell_at(const struct cells *k, int c, double x) {
    const int at = (int)floor((x - k->low[c]) / k->width[c]);
    return at < 0 ? 0 : at >= k->n[c] ? k->n[c] - 1 : at;
}

static void cells_new(struct cells *k, const struct meshless_matrix_input *in) {
    const struct meshless_points *p = in->points;
    *k = (struct cells){.in = in, .n = {1, 1, 1}};
    long all = 1;
    for (int c = 0; c < p->dim; c++) {
        double high = -INFINITY;
        k->low[c] = INFINITY;
        for (long i = 0; i < p->n; i++) {
            k->low[c] = fmin(k->low[c], p->x[c][i]);
            high = fmax(high, p->x[c][i]);
        }
        const double wanted = floor((high - k->low[c]) / (in->horizon * reach_slack));
        const double most = fmax(1, pow((double)p->n, 1.0 / p->dim)); /* cells without number help nobody */
        k->n[c] = (int)fmax(1, fmin(wanted, most));
        k->width[c] = fmax((high - k->low[c]) / k->n[c], in->horizon);
        all *= k->n[c];
    }
    k->start = memory_new(MEMORY_SOLID, (size_t)all + 2, sizeof *k->start);
    k->item = memory_new(MEMORY_SOLID, (size_t)p->n + 1, sizeof *k->item);
    long *cell = memory_new(MEMORY_SOLID, (size_t)p->n + 1, sizeof *cell);
    for (long i = 0; i < p->n; i++)
        for (int c = p->dim - 1; c >= 0; c--) cell[i] = cell[i] * k->n[c] + cell_at(k, c, p->x[c][i]);
    for (long i = 0; i < p->n; i++) k->start[cell[i] + 2]++;
    for (long q = 2; q < all + 2; q++) k->start[q] += k->start[q - 1];
    for (long i = 0; i < p->n; i++) k->item[k->start[cell[i] + 1]++] = i;
    memory_free(cell);
}

static void cells_free(struct cells *k) { MEMORY_FREE(k->start, k->item); }

static double power(double x, double n) { return n == 2 ? x * x : n == 1 ? x : pow(x, n); }

static _Noreturn void refuse_pair(const struct meshless_points *p, long i, long j) {
    die(EXIT_CODE_SCENE,
        "points %ld and %ld of the arrangement coincide at (%g, %g, %g): each needs a place of its own; another seed "
        "or a "
        "smaller perturbation gives one",
        i, j, p->x[0][i], p->dim > 1 ? p->x[1][i] : 0, p->dim > 2 ? p->x[2][i] : 0);
}

/* Visits the bonds of point i in a fixed order: number, value V_i V_j / r^P. */
static long visit(const struct cells *k, long i, void (*take)(void *with, long j, double value), void *with) {
    const struct meshless_points *p = k->in->points;
    const double reach = k->in->horizon * reach_slack;
    int from[3] = {0}, to[3] = {0};
    long n = 0;
    for (int c = 0; c < p->dim; c++) {
        from[c] = cell_at(k, c, p->x[c][i] - reach);
        to[c] = cell_at(k, c, p->x[c][i] + reach);
    }
    for (int z = from[2]; z <= to[2]; z++)
        for (int y = from[1]; y <= to[1]; y++) {
            const long *start = k->start + ((long)z * k->n[1] + y) * k->n[0];
            for (long q = start[from[0]]; q < start[to[0] + 1]; q++) {
                const long j = k->item[q];
                double r2 = 0;
                if (j == i) continue;
                for (int c = 0; c < p->dim; c++) r2 += (p->x[c][j] - p->x[c][i]) * (p->x[c][j] - p->x[c][i]);
                if (r2 > reach * reach) continue;
                const double r = sqrt(r2);
                if (r <= coincident * p->spacing) refuse_pair(p, i, j);
                take(with, j, p->volume[i] * p->volume[j] / power(r, k->in->exponent));
                n++;
            }
        }
    return n;
}

/* The rows while they are put together. */
struct rows {
    struct meshless_matrix *a;
    const long *number; /* [points] of the unknown; -1: given */
    long *id;           /* [entries] columns by global number */
    long row, used, capacity, given_used, given_capacity;
};

static void take(void *with, long j, double value) {
    struct rows *r = with;
    struct meshless_matrix *a = r->a;
    a->diagonal[r->row] += value;
    if (r->number[j] < 0) {
        if (r->given_used == r->given_capacity) {
            const size_t used = (size_t)r->given_used,
                         capacity = (size_t)(r->given_capacity = 2 * r->given_capacity + 1024);
            a->given = memory_grown(MEMORY_SOLID, a->given, used, capacity, sizeof *a->given);
            a->given_value = memory_grown(MEMORY_SOLID, a->given_value, used, capacity, sizeof *a->given_value);
        }
        a->given[r->given_used] = j;
        a->given_value[r->given_used++] = value;
        return;
    }
    if (r->used == r->capacity) {
        const size_t used = (size_t)r->used, capacity = (size_t)(r->capacity = 2 * r->capacity + 1024);
        r->id = memory_grown(MEMORY_SOLID, r->id, used, capacity, sizeof *r->id);
        a->value = memory_grown(MEMORY_SOLID, a->value, used, capacity, sizeof *a->value);
    }
    r->id[r->used] = r->number[j];
    a->value[r->used++] = -value;
}

/* The columns of other ranks: their list, and the place of each column in it. */
static void number_columns(struct meshless_matrix *a, const long *id) {
    const long n = a->start[a->rows];
    long *other = memory_new(MEMORY_SOLID, (size_t)n + 1, sizeof *other), others = 0;
    for (long k = 0; k < n; k++)
        if (id[k] < a->first[0] || id[k] >= a->first[1]) other[others++] = id[k];
    a->ghosts = (int)sort_unique(other, others);
    a->ghost_id = other;
    a->column = memory_new(MEMORY_SOLID, (size_t)n + 1, sizeof *a->column);
    for (long k = 0; k < n; k++)
        a->column[k] = id[k] >= a->first[0] && id[k] < a->first[1] ? (int)(id[k] - a->first[0])
                                                                   : a->rows + (int)sort_find(other, a->ghosts, id[k]);
}

struct meshless_matrix *meshless_matrix_new(const struct meshless_matrix_input *in) {
    const struct meshless_points *p = in->points;
    struct meshless_matrix *a = memory_new(MEMORY_SOLID, 1, sizeof *a);
    struct cells k;
    cells_new(&k, in);
    long *number = memory_new(MEMORY_SOLID, (size_t)p->n + 1, sizeof *number),
         *point = memory_new(MEMORY_SOLID, (size_t)p->n + 1, sizeof *point);
    for (long q = 0; q < p->n; q++) { /* by cell, so that the rows of a rank are near to each other */
        const long i = k.item[q];
        number[i] = in->free[i] ? a->rows_global : -1;
        if (in->free[i]) point[a->rows_global++] = i;
    }
    const long size = par_size(), rank = par_rank();
    long *first = memory_new(MEMORY_SOLID, (size_t)size + 1, sizeof *first);
    for (long s = 0; s <= size; s++) first[s] = a->rows_global * s / size;
    a->points = p;
    memcpy(a->first, first + rank, sizeof a->first);
    a->rows = (int)(a->first[1] - a->first[0]);
    a->point = memory_copy(MEMORY_SOLID, point + a->first[0], (size_t)a->rows, sizeof *a->point);
    a->start = memory_new(MEMORY_SOLID, (size_t)a->rows + 1, sizeof *a->start);
    a->given_start = memory_new(MEMORY_SOLID, (size_t)a->rows + 1, sizeof *a->given_start);
    a->diagonal = memory_new(MEMORY_SOLID, (size_t)a->rows + 1, sizeof *a->diagonal);
    struct rows r = {.a = a, .number = number};
    for (; r.row < a->rows; r.row++) {
        const long i = a->point[r.row];
        if (visit(&k, i, take, &r) == 0)
            die(EXIT_CODE_SCENE,
                "point %ld of the arrangement, at (%g, %g, %g), has no neighbour within the horizon %g m: a larger "
                "horizon "
                "or a smaller spacing than %g m gives it some",
                i, p->x[0][i], p->dim > 1 ? p->x[1][i] : 0, p->dim > 2 ? p->x[2][i] : 0, in->horizon, p->spacing);
        a->start[r.row + 1] = r.used;
        a->given_start[r.row + 1] = r.given_used;
    }
    cells_free(&k);
    number_columns(a, r.id);
    a->entries = par_sum_long(r.used + a->rows);
    a->exchange = par_ghost_new(first, a->ghosts, a->ghost_id);
    MEMORY_FREE(r.id, first, point, number);
    return a;
}

void meshless_matrix_free(struct meshless_matrix *a) {
    if (!a) return;
    par_ghost_free(a->exchange);
    MEMORY_FREE(a->point, a->start, a->column, a->value, a->diagonal, a->ghost_id, a->given_start, a->given,
                a->given_value, a);
}

void meshless_matrix_times(struct meshless_matrix *a, double *x, double *y) {
    par_ghost_update(a->exchange, 1, &x, a->rows);
    for (int i = 0; i < a->rows; i++) {
        double sum = a->diagonal[i] * x[i];
        for (long k = a->start[i]; k < a->start[i + 1]; k++) sum += a->value[k] * x[a->column[k]];
        y[i] = sum;
    }
}

double meshless_matrix_dot(const struct meshless_matrix *a, const double *x, const double *y) {
    double sum = 0;
    for (int i = 0; i < a->rows; i++) sum += x[i] * y[i];
    return par_sum(sum);
}

double *meshless_matrix_dense(const struct meshless_matrix *a) {
    const size_t n = (size_t)a->rows_global;
    double *local = memory_new(MEMORY_SOLID, (size_t)a->rows * n + 1, sizeof *local);
    for (int i = 0; i < a->rows; i++) {
        double *row = local + (size_t)i * n;
        row[a->first[0] + i] = a->diagonal[i];
        for (long k = a->start[i]; k < a->start[i + 1]; k++) {
            const int c = a->column[k];
            row[c < a->rows ? a->first[0] + c : a->ghost_id[c - a->rows]] += a->value[k];
        }
    }
    size_t bytes = 0;
    double *all = par_all_gather_any(local, (size_t)a->rows * n * sizeof *local, &bytes), *dense = NULL;
    if (par_rank() == 0) dense = memory_copy(MEMORY_SOLID, all, n * n, sizeof *dense);
    free(all);
    memory_free(local);
    return dense;
}
