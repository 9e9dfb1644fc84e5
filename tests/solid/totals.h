/* Motions of any body of tests/solid/make.h, and sums that internal forces must leave as they are. */
#pragma once
#include "base/par.h"
#include "solid/bonds/ghosts.h"
#include "tests/solid/make.h"

#include <string.h>

/* Displacements of this strain, and velocities with a rotation. Collective. */
static inline void shake(struct solid *s, double strain, double speed) {
    for (int h = 0; h < s->n; h++)
        for (int c = 0; c < 3; c++) {
            s->d[c][h] = strain * SPACING * noise(s, h, c);
            s->v[c][h] = speed * noise(s, h, c + 3) + speed * (c + 1) * s->x0[(c + 1) % 3][h] / SPACING;
        }
    solid_ghosts_update(s);
}

/* rate 0: momentum and angular momentum; rate 1: total force and torque. Also the sum of the sizes of the terms.
 * Collective. */
static inline void totals(const struct solid *s, int rate, double total[6], double *size) {
    double sum[7] = {0};
    double *const *y = rate ? s->a : s->v;
    for (int h = 0; h < s->n; h++) {
        double x[3];
        solid_position(s, h, x);
        const double m = DENSITY * s->volume[h];
        for (int c = 0; c < 3; c++) {
            const int d = (c + 1) % 3, e = (c + 2) % 3;
            sum[c] += m * y[c][h];
            sum[3 + c] += m * (x[d] * y[e][h] - x[e] * y[d][h]) / SPACING;
            sum[6] += m * fabs(y[c][h]) * 10;
        }
    }
    par_sum_array(sum, 7);
    memcpy(total, sum, 6 * sizeof *total);
    *size = sum[6];
}
