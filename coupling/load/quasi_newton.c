/* Fixed-point acceleration by Aitken's relaxation or interface quasi-Newton with least squares. */
#include "coupling/load/quasi_newton.h"
#include "base/ensure.h"
#include "base/memory.h"
#include "base/par.h"

#include <lapacke.h>
#include <math.h>
#include <string.h>

enum { C = QUASI_NEWTON_COLUMNS };

struct quasi_newton {
    struct quasi_newton_input in;
    int n, capacity;
    int columns;       /* number of columns of V and W, newest first */
    int known;         /* 1: residual and image below belong to this map */
    double factor;     /* Aitken's w */
    double *dr[C];     /* [n] V */
    double *dx[C];     /* [n] W */
    double *residual;  /* [n] of the last guess */
    double *image;     /* [n] */
    double gram[C][C]; /* V^T V */
};

struct quasi_newton *quasi_newton_new(const struct quasi_newton_input *in) {
    struct quasi_newton *q = memory_new(MEMORY_COUPLING, 1, sizeof *q);
    q->in = *in;
    return q;
}

static void vectors_free(struct quasi_newton *q) {
    for (int k = 0; k < C; k++) {
        memory_free(q->dr[k]);
        memory_free(q->dx[k]);
    }
    memory_free(q->residual);
    memory_free(q->image);
}

void quasi_newton_free(struct quasi_newton *q) {
    if (!q) return;
    vectors_free(q);
    memory_free(q);
}

static void reserve(struct quasi_newton *q, int n) {
    if (n <= q->capacity && q->residual) return;
    vectors_free(q);
    q->capacity = n + n / 4 + 64;
    const int columns = q->in.kind == QUASI_NEWTON_LEAST_SQUARES ? C : 0;
    for (int k = 0; k < columns; k++) {
        q->dr[k] = memory_new(MEMORY_COUPLING, (size_t)q->capacity, sizeof(double));
        q->dx[k] = memory_new(MEMORY_COUPLING, (size_t)q->capacity, sizeof(double));
    }
    q->residual = memory_new(MEMORY_COUPLING, (size_t)q->capacity, sizeof(double));
    q->image = memory_new(MEMORY_COUPLING, (size_t)q->capacity, sizeof(double));
}

void quasi_newton_begin(struct quasi_newton *q, int n, int forget) {
    if (par_max(n != q->n || forget) > 0) q->columns = 0;
    reserve(q, n);
    q->n = n;
    q->known = 0;
    q->factor = q->in.relaxation;
}

int quasi_newton_columns(const struct quasi_newton *q) { return q->columns; }

static double dot(int n, const double *restrict a, const double *restrict b) {
    double sum = 0;
    for (int i = 0; i < n; i++) sum += a[i] * b[i];
    return sum;
}

/* The differences to the last guess become the newest column and replace the oldest one; row 0 of V^T V is not computed
 * yet. */
static void add_column(struct quasi_newton *q, const double *x, const double *image) {
    const int last = q->columns < C ? q->columns : C - 1;
    double *const dr = q->dr[last], *const dx = q->dx[last];
    for (int k = last; k > 0; k--) {
        q->dr[k] = q->dr[k - 1];
        q->dx[k] = q->dx[k - 1];
        for (int l = last; l > 0; l--) q->gram[k][l] = q->gram[k - 1][l - 1];
    }
    q->dr[0] = dr;
    q->dx[0] = dx;
    for (int i = 0; i < q->n; i++) {
        dr[i] = image[i] - x[i] - q->residual[i];
        dx[i] = image[i] - q->image[i];
    }
    q->columns = last + 1;
}

/* sum[k] = V_k.r, sum[columns + k] = V_0.V_k, over all ranks. */
static void products(struct quasi_newton *q, const double *r, double *sum) {
    const int m = q->columns;
    for (int k = 0; k < m; k++) {
        sum[k] = dot(q->n, q->dr[k], r);
        sum[m + k] = dot(q->n, q->dr[0], q->dr[k]);
    }
    par_sum_array(sum, 2 * m);
    for (int k = 0; k < m; k++) q->gram[0][k] = q->gram[k][0] = sum[m + k];
}

static void drop_column(struct quasi_newton *q, int k, double *right) {
    double *const dr = q->dr[k], *const dx = q->dx[k];
    q->columns--;
    for (int i = k; i < q->columns; i++) {
        q->dr[i] = q->dr[i + 1];
        q->dx[i] = q->dx[i + 1];
        right[i] = right[i + 1];
        memcpy(q->gram[i], q->gram[i + 1], sizeof q->gram[i]);
    }
    for (int i = 0; i < q->columns; i++)
        memmove(&q->gram[i][k], &q->gram[i][k + 1], (size_t)(q->columns - k) * sizeof(double));
    q->dr[q->columns] = dr; /* its memory is kept for reuse */
    q->dx[q->columns] = dx;
}

/* Cholesky's factor L of V^T V, which is the transpose of the R of V = Q R: L_kk is the norm of the part of column k
 * that is independent of the newer ones. A column whose independent part is less than the filter's fraction is dropped
 * (preCICE's QR2). */
static void factorise(struct quasi_newton *q, double l[C][C], double *right) {
    for (int k = 0; k < q->columns;) {
        double left = q->gram[k][k];
        for (int j = 0; j < k; j++) {
            double sum = q->gram[k][j];
            for (int i = 0; i < j; i++) sum -= l[k][i] * l[j][i];
            l[k][j] = sum / l[j][j];
            left -= l[k][j] * l[k][j];
        }
        if (!(left > q->in.filter * q->in.filter * q->gram[k][k])) {
            drop_column(q, k, right);
            continue;
        }
        l[k][k] = sqrt(left);
        k++;
    }
}

/* x <- H(x) + W c, V^T V c = -V^T r. */
static void least_squares(struct quasi_newton *q, double *x, const double *image, const double *r) {
    double c[2 * C], l[C][C] = {{0}};
    products(q, r, c);
    factorise(q, l, c);
    const int m = q->columns;
    for (int k = 0; k < m; k++) c[k] = -c[k];
    if (m > 0) ENSURE(LAPACKE_dpotrs(LAPACK_ROW_MAJOR, 'L', m, 1, l[0], C, c, 1) == 0, "%d columns", m);
    memcpy(x, image, (size_t)q->n * sizeof *x);
    for (int k = 0; k < m; k++)
        for (int i = 0; i < q->n; i++) x[i] += c[k] * q->dx[k][i];
}

static void aitken(struct quasi_newton *q, const double *r) {
    double sum[2] = {0};
    for (int i = 0; i < q->n; i++) {
        const double change = r[i] - q->residual[i];
        sum[0] += q->residual[i] * change;
        sum[1] += change * change;
    }
    par_sum_array(sum, 2);
    if (sum[1] > 0) q->factor *= -sum[0] / sum[1];
}

void quasi_newton_next(struct quasi_newton *q, double *x, const double *image) {
    const int is_aitken = q->in.kind == QUASI_NEWTON_AITKEN;
    if (q->known && !is_aitken) add_column(q, x, image);
    double *restrict last = q->residual; /* becomes r after the last use of the old residual */
    if (q->known && is_aitken) {
        for (int i = 0; i < q->n; i++) q->image[i] = image[i] - x[i];
        aitken(q, q->image);
    }
    for (int i = 0; i < q->n; i++) last[i] = image[i] - x[i];
    memcpy(q->image, image, (size_t)q->n * sizeof *image);
    q->known = 1;
    if (!is_aitken && q->columns > 0) {
        least_squares(q, x, image, last);
        return;
    }
    for (int i = 0; i < q->n; i++) x[i] += q->factor * last[i];
}
