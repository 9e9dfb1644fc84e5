/* A direct solver for a few hundred rows. */
#include "stokes/direct.h"
#include "base/memory.h"
#include "base/sets.h"
#include "base/par.h"

#include <stdlib.h>
#include <string.h>

#define SINGULAR 1e-9 /* a pivot below this part of its diagonal is 0 */

struct stokes_direct {
    const struct stokes_level *l;
    int rows;
    double *factor; /* [rows][rows] lower triangle of L, with L L^T = M */
    double *x;      /* [rows] */
    int *piece;     /* [rows] the first row that is connected with it; -1: the matrix is not singular there */
    int *count;     /* [rows] of a first row: rows of its piece */
};

struct entry {
    int row, column;
    double value;
};

/* The entries of this rank's rows, by global numbers: their weights, and on the diagonal what it has beyond them. */
static struct entry *entries_of(const struct stokes_level *l, int *n) {
    const long own = l->first[par_rank()];
    long *number = memory_new(MEMORY_FLUID, stokes_level_size(l), sizeof *number);
    int capacity = l->n + 1;
    struct stokes_level_row row;
    for (int i = 0; i < l->n; i++) number[i] = own + i;
    par_ghost_update_records(l->ghost, sizeof *number, number, l->n);
    for (int i = 0; i < l->n; i++) stokes_level_row_of(l, i, &row), capacity += row.n;
    struct entry *e = memory_new(MEMORY_FLUID, (size_t)capacity, sizeof *e);
    *n = 0;
    for (int i = 0; i < l->n; i++) {
        if (!(l->inverse[i] > 0)) continue;
        stokes_level_row_of(l, i, &row);
        e[(*n)++] = (struct entry){(int)number[i], (int)number[i], l->extra ? (double)l->extra[i] : 0};
        for (int k = 0; k < row.n; k++)
            e[(*n)++] = (struct entry){(int)number[i], (int)number[row.column[k]], (double)row.weight[k]};
    }
    memory_free(number);
    return e;
}

/* The lower triangle, with diagonals that are the sums of the same weights, so that a row of a singular matrix sums to
 * 0 to the last digit. is_row: rows with an unknown; weights towards others belong to the diagonal. */
static void fill(double *a, int n, const struct entry *e, size_t entries, const char *is_row) {
    for (size_t k = 0; k < entries; k++) {
        const long i = e[k].row, j = e[k].column;
        if (i == j || !is_row[j]) a[i * n + i] += e[k].value;
        if (j >= i || !is_row[j]) continue;
        a[i * n + j] -= e[k].value;
        a[i * n + i] += e[k].value;
        a[j * n + j] += e[k].value;
    }
}

/* Finds the pieces of connected rows that nothing holds. */
static void find_pieces(struct stokes_direct *d, const struct entry *e, size_t entries, const char *is_row) {
    char *is_held = memory_new(MEMORY_FLUID, (size_t)d->rows + 1, 1);
    for (int i = 0; i < d->rows; i++) d->piece[i] = i;
    for (size_t k = 0; k < entries; k++) {
        const int i = sets_root_int(d->piece, e[k].row), j = sets_root_int(d->piece, e[k].column);
        if (is_row[e[k].column]) d->piece[i > j ? i : j] = i > j ? j : i;
    }
    for (size_t k = 0; k < entries; k++)
        if (e[k].value > 0 && (e[k].row == e[k].column || !is_row[e[k].column]))
            is_held[sets_root_int(d->piece, e[k].row)] = 1;
    for (int i = d->rows - 1; i >= 0; i--) {
        const int first = sets_root_int(d->piece, i);
        d->piece[i] = is_held[first] || !is_row[i] ? -1 : first;
        d->count[first]++;
    }
    memory_free(is_held);
}

/* Takes its mean over each such piece from a vector. */
static void remove_means(const struct stokes_direct *d, double *x) {
    double *sum = memory_new(MEMORY_FLUID, (size_t)d->rows + 1, sizeof *sum);
    for (int i = 0; i < d->rows; i++)
        if (d->piece[i] >= 0) sum[d->piece[i]] += x[i];
    for (int i = 0; i < d->rows; i++)
        if (d->piece[i] >= 0) x[i] -= sum[d->piece[i]] / d->count[d->piece[i]];
    memory_free(sum);
}

/* A pivot that is round-off is left out with its row and column. */
static void factorise(double *a, int n) {
    for (int j = 0; j < n; j++) {
        const double diagonal = a[(long)j * n + j];
        double pivot = diagonal;
        for (int k = 0; k < j; k++) pivot -= a[(long)j * n + k] * a[(long)j * n + k];
        const double root = pivot > SINGULAR * diagonal ? __builtin_sqrt(pivot) : 0;
        a[(long)j * n + j] = root;
        for (int i = j + 1; i < n; i++) {
            double sum = a[(long)i * n + j];
            for (int k = 0; k < j; k++) sum -= a[(long)i * n + k] * a[(long)j * n + k];
            a[(long)i * n + j] = root > 0 ? sum / root : 0;
        }
    }
}

struct stokes_direct *stokes_direct_new(const struct stokes_level *l) {
    struct stokes_direct *d = memory_new(MEMORY_FLUID, 1, sizeof *d);
    int n;
    size_t bytes;
    struct entry *mine = entries_of(l, &n), *all = par_all_gather_any(mine, (size_t)n * sizeof *mine, &bytes);
    d->l = l;
    d->rows = (int)l->first[par_size()];
    d->factor = memory_new(MEMORY_FLUID, (size_t)d->rows * (size_t)d->rows + 1, sizeof *d->factor);
    d->x = memory_new(MEMORY_FLUID, (size_t)d->rows + 1, sizeof *d->x);
    d->piece = memory_new(MEMORY_FLUID, (size_t)d->rows + 1, sizeof *d->piece);
    d->count = memory_new(MEMORY_FLUID, (size_t)d->rows + 1, sizeof *d->count);
    char *is_row = memory_new(MEMORY_FLUID, (size_t)d->rows + 1, 1);
    for (size_t k = 0; k < bytes / sizeof *all; k++) is_row[all[k].row] = 1;
    fill(d->factor, d->rows, all, bytes / sizeof *all, is_row);
    factorise(d->factor, d->rows);
    find_pieces(d, all, bytes / sizeof *all, is_row);
    MEMORY_FREE(is_row, mine);
    free(all);
    return d;
}

void stokes_direct_free(struct stokes_direct *d) {
    if (!d) return;
    MEMORY_FREE(d->factor, d->x, d->piece, d->count, d);
}

void stokes_direct_solve(struct stokes_direct *d, const float *b, float *x) {
    const int n = d->rows;
    const double *a = d->factor;
    size_t bytes;
    float *all = par_all_gather_any(b, (size_t)d->l->n * sizeof *b, &bytes);
    for (int i = 0; i < n; i++) d->x[i] = (double)all[i];
    remove_means(d, d->x); /* round-off in b, which nothing could balance */
    for (int i = 0; i < n; i++) {
        double sum = d->x[i];
        for (int k = 0; k < i; k++) sum -= a[(long)i * n + k] * d->x[k];
        d->x[i] = a[(long)i * n + i] > 0 ? sum / a[(long)i * n + i] : 0;
    }
    for (int i = n - 1; i >= 0; i--) {
        double sum = d->x[i];
        for (int k = i + 1; k < n; k++) sum -= a[(long)k * n + i] * d->x[k];
        d->x[i] = a[(long)i * n + i] > 0 ? sum / a[(long)i * n + i] : 0;
    }
    remove_means(d, d->x);
    for (int i = 0; i < d->l->n; i++) x[i] = (float)d->x[d->l->first[par_rank()] + i];
    free(all);
}
