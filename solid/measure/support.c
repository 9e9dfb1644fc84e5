/* Finds the reactions that hold bodies in balance under given forces, as of a rigid support. */
#include "solid/measure/support.h"
#include "base/par.h"

#include <lapacke.h>
#include <math.h>

enum { MOTIONS = 6 }; /* three translations, three rotations */
/* Weight of a particle that is free in a direction, over that of a held one. */
static const double FREE = 1e-9;

struct solid_support_extent solid_support_extent_of(const struct solid *s, const uint8_t *chosen) {
    struct solid_support_extent e = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}, {0}};
    for (int h = 0; h < s->n; h++)
        for (int c = 0; c < s->dim && chosen[s->body[h]]; c++) {
            e.low[c] = fmin(e.low[c], s->x0[c][h]);
            e.high[c] = fmax(e.high[c], s->x0[c][h]);
        }
    par_min_array(e.low, 3);
    par_max_array(e.high, 3);
    for (int c = s->dim; c < 3; c++) e.low[c] = e.high[c] = 0;
    for (int c = 0; c < 3; c++)
        e.endless[c] =
            c >= s->dim || (s->in.periodic[c] && e.high[c] - e.low[c] > s->in.length[c] - 1.5 * s->in.spacing);
    return e;
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

static double weight_of(const struct solid *s, int h, int c) {
    return s->volume[h] * (s->flag[h] & SOLID_HELD_X << c ? 1 : FREE);
}

void solid_support_add(const struct solid *s, const uint8_t *chosen, const struct solid_support_extent *e,
                       double *const force[3]) {
    double a[MOTIONS][MOTIONS] = {{0}}, b[MOTIONS] = {0}, move[MOTIONS], x[3] = {0}, row[MOTIONS];
    int is[MOTIONS];
    motions_of(s, e, is);
    for (int h = 0; h < s->n; h++) {
        for (int c = 0; c < s->dim; c++) x[c] = s->x0[c][h] - 0.5 * (e->low[c] + e->high[c]);
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
        for (int c = 0; c < s->dim; c++) x[c] = s->x0[c][h] - 0.5 * (e->low[c] + e->high[c]);
        for (int c = 0; c < s->dim && chosen[s->body[h]]; c++) {
            row_of(x, c, row);
            for (int k = 0; k < MOTIONS; k++)
                force[c][h] += is[k] * move[k] * row[k] * weight_of(s, h, c) / s->volume[h];
        }
    }
}
