/* A direct solver for a few hundred rows. */
#include "stokes/direct.h"
#include "base/memory.h"
#include "base/par.h"

#include <stdlib.h>
#include <string.h>

#define SINGULAR 1e-6 /* a pivot below this part of its diagonal is 0: the entries are floats */

struct stokes_direct {
    const struct stokes_level *l;
    int rows;
    double *factor; /* [rows][rows] lower triangle of L, with L L^T = M */
    double *x;      /* [rows] */
};

struct entry {
    int row, column;
    double value;
};

/* The entries of this rank's rows, by global numbers. */
static struct entry *entries_of(const struct stokes_level *l, int *n) {
    const long own = l->first[par_rank()];
    long *number = memory_new(MEMORY_FLUID, stokes_level_size(l), sizeof *number);
    int room = l->n + 1;
    struct stokes_level_row row;
    for (int i = 0; i < l->n; i++) number[i] = own + i;
    par_ghost_update_records(l->ghost, sizeof *number, number, l->n);
    for (int i = 0; i < l->n; i++) stokes_level_row_of(l, i, &row), room += row.n;
    struct entry *e = memory_new(MEMORY_FLUID, (size_t)room, sizeof *e);
    *n = 0;
    for (int i = 0; i < l->n; i++) {
        if (!(l->inverse[i] > 0)) continue;
        stokes_level_row_of(l, i, &row);
        e[(*n)++] = (struct entry){(int)number[i], (int)number[i], 1 / (double)l->inverse[i]};
        for (int k = 0; k < row.n; k++)
            e[(*n)++] = (struct entry){(int)number[i], (int)number[row.column[k]], -(double)row.weight[k]};
    }
    memory_free(number);
    return e;
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
    for (size_t k = 0; k < bytes / sizeof *all; k++)
        d->factor[(long)all[k].row * d->rows + all[k].column] += all[k].value;
    factorise(d->factor, d->rows);
    memory_free(mine);
    free(all);
    return d;
}

void stokes_direct_free(struct stokes_direct *d) {
    if (!d) return;
    memory_free(d->factor);
    memory_free(d->x);
    memory_free(d);
}

void stokes_direct_solve(struct stokes_direct *d, const float *b, float *x) {
    const int n = d->rows;
    const double *a = d->factor;
    size_t bytes;
    float *all = par_all_gather_any(b, (size_t)d->l->n * sizeof *b, &bytes);
    for (int i = 0; i < n; i++) {
        double sum = (double)all[i];
        for (int k = 0; k < i; k++) sum -= a[(long)i * n + k] * d->x[k];
        d->x[i] = a[(long)i * n + i] > 0 ? sum / a[(long)i * n + i] : 0;
    }
    for (int i = n - 1; i >= 0; i--) {
        double sum = d->x[i];
        for (int k = i + 1; k < n; k++) sum -= a[(long)k * n + i] * d->x[k];
        d->x[i] = a[(long)i * n + i] > 0 ? sum / a[(long)i * n + i] : 0;
    }
    for (int i = 0; i < d->l->n; i++) x[i] = (float)d->x[d->l->first[par_rank()] + i];
    free(all);
}
