/* Finds the reactions that hold bodies in balance under given forces, as of a rigid support. */
#include "solid/measure/support.h"
#include "base/memory.h"
#include "base/par.h"

#include <lapacke.h>
#include <math.h>

enum { MOTIONS = 6 }; /* three translations, three rotations */
/* Weight of a particle that is free in a direction, over that of a held one. */
static const double FREE = 1e-9;

/* A coordinate at the start, m, within the period of a periodic direction. */
static double wrapped(const struct solid *s, int c, int h) {
    const double x = s->x0[c][h];
    return s->in.periodic[c] ? x - s->in.length[c] * floor(x / s->in.length[c]) : x;
}

/* The width of a gap that bonds may cross, m. */
static double bridged(const struct solid *s) {
    double most = 1.5;
    for (int m = 0; m < s->in.materials; m++) most = fmax(most, s->in.material[m].horizon_ratio);
    return most * s->in.spacing;
}

/* The extent along a periodic direction begins behind the widest gap between the particles of neighbouring bins. */
static void put_together(const struct solid *s, const uint8_t *chosen, int c, struct solid_support_extent *e) {
    const double length = s->in.length[c];
    const int n = (int)ceil(length / s->in.spacing);
    double *low = memory_new(MEMORY_OUTPUT, (size_t)n, sizeof *low),
           *high = memory_new(MEMORY_OUTPUT, (size_t)n, sizeof *high);
    for (int k = 0; k < n; k++) {
        low[k] = INFINITY;
        high[k] = -INFINITY;
    }
    for (int h = 0; h < s->n; h++) {
        if (!chosen[s->body[h]]) continue;
        const double x = wrapped(s, c, h);
        const int k = (int)fmin(n - 1, x / length * n);
        low[k] = fmin(low[k], x);
        high[k] = fmax(high[k], x);
    }
    par_min_array(low, n);
    par_max_array(high, n);
    double before = e->high[c] - length, gap = 0;
    const double last = e->high[c];
    for (int k = 0; k < n; k++) {
        if (!(low[k] < INFINITY)) continue;
        if (low[k] - before > gap) {
            gap = low[k] - before;
            e->low[c] = low[k];
            e->high[c] = before < 0 ? last : before + length;
        }
        before = high[k];
    }
    e->endless[c] = gap < bridged(s);
    MEMORY_FREE(low, high);
}

struct solid_support_extent solid_support_extent_of(const struct solid *s, const uint8_t *chosen) {
    struct solid_support_extent e = {.low = {INFINITY, INFINITY, INFINITY}, .high = {-INFINITY, -INFINITY, -INFINITY}};
    for (int h = 0; h < s->n; h++)
        for (int c = 0; c < s->dim && chosen[s->body[h]]; c++) {
            e.low[c] = fmin(e.low[c], wrapped(s, c, h));
            e.high[c] = fmax(e.high[c], wrapped(s, c, h));
        }
    par_min_array(e.low, 3);
    par_max_array(e.high, 3);
    for (int c = s->dim; c < 3; c++) {
        e.low[c] = e.high[c] = 0;
        e.endless[c] = 1;
    }
    for (int c = 0; c < s->dim; c++) {
        if (!s->in.periodic[c] || !(e.low[c] < INFINITY)) continue;
        e.period[c] = s->in.length[c];
        put_together(s, chosen, c, &e);
    }
    return e;
}

double solid_support_place(const struct solid *s, const struct solid_support_extent *e, int c, int h) {
    const double x = wrapped(s, c, h);
    return x < e->low[c] ? x + e->period[c] - e->low[c] : x - e->low[c];
}

/* The displacement of a particle at x from the centre by each rigid motion: row c of [I, -[x]]. */
static void row_of(const double x[3], int c, double row[MOTIONS]) {
    const int p = (c + 1) % 3, q = (c + 2) % 3;
    for (int k = 0; k < MOTIONS; k++) row[k] = 0;
    row[c] = 1;
    row[3 + p] = x[q]; /* (b x X)_c = b_p X_q - b_q X_p */
    row[3 + q] = -x[p];
}

/* Which motions there are: a rotation moves the two directions across it. */
static void motions_of(const struct solid *s, const struct solid_support_extent *e, int is[MOTIONS]) {
    for (int c = 0; c < 3; c++) {
        is[c] = c < s->dim;
        is[3 + c] = !e->endless[(c + 1) % 3] && !e->endless[(c + 2) % 3];
    }
}

/* Solves the symmetric a x = b; motions that nothing resists stay 0, as the shortest x has them. Scaled by its
 * diagonal, so that rotations and translations count alike. */
static void solve(double a[MOTIONS][MOTIONS], double b[MOTIONS], double x[MOTIONS]) {
    static const double ROUND_OFF = 1e-13;
    double scale[MOTIONS], singular[MOTIONS];
    int rank;
    for (int k = 0; k < MOTIONS; k++) scale[k] = a[k][k] > 0 ? 1 / sqrt(a[k][k]) : 1;
    for (int k = 0; k < MOTIONS; k++) {
        for (int j = 0; j < MOTIONS; j++) a[k][j] *= scale[k] * scale[j];
        x[k] = b[k] * scale[k];
    }
    LAPACKE_dgelsd(LAPACK_ROW_MAJOR, MOTIONS, MOTIONS, 1, a[0], MOTIONS, x, 1, singular, ROUND_OFF, &rank);
    for (int k = 0; k < MOTIONS; k++) x[k] *= scale[k];
}

static void from_middle(const struct solid *s, const struct solid_support_extent *e, int h, double x[3]) {
    for (int c = 0; c < s->dim; c++) x[c] = solid_support_place(s, e, c, h) - 0.5 * (e->high[c] - e->low[c]);
}

static double weight_of(const struct solid *s, int h, int c) {
    return s->volume[h] * (s->flag[h] & SOLID_HELD_X << c ? 1 : FREE);
}

void solid_support_add(const struct solid *s, const uint8_t *chosen, const struct solid_support_extent *e,
                       double *const force[3]) {
    double a[MOTIONS][MOTIONS] = {{0}}, b[MOTIONS] = {0}, move[MOTIONS], x[3] = {0}, row[MOTIONS];
    int is[MOTIONS];
    motions_of(s, e, is);
    for (int h = 0; h < s->n; h++) {
        from_middle(s, e, h, x);
        for (int c = 0; c < s->dim && chosen[s->body[h]]; c++) {
            row_of(x, c, row);
            for (int k = 0; k < MOTIONS; k++) {
                for (int j = 0; is[k] && j < MOTIONS; j++) a[k][j] += is[j] * weight_of(s, h, c) * row[k] * row[j];
                b[k] -= is[k] * s->volume[h] * force[c][h] * row[k];
            }
        }
    }
    par_sum_array(a[0], MOTIONS * MOTIONS);
    par_sum_array(b, MOTIONS);
    solve(a, b, move);
    for (int h = 0; h < s->n; h++) {
        from_middle(s, e, h, x);
        for (int c = 0; c < s->dim && chosen[s->body[h]]; c++) {
            row_of(x, c, row);
            for (int k = 0; k < MOTIONS; k++)
                force[c][h] += is[k] * move[k] * row[k] * weight_of(s, h, c) / s->volume[h];
        }
    }
}
