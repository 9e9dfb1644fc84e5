/* Forces against the derivative of the energy. */
#pragma once
#include "base/par.h"
#include "solid/bonds/ghosts.h"
#include "solid/force/force.h"
#include "solid/measure/energy.h"
#include "tests/check.h"

/* sum F u and the derivative of the strain energy along u by central differences, over the sum of the sizes
 * of the terms; u: a number for each particle and component, whose third
 * argument is 7 to 9; step: in spacings. Leaves the displacements one step lower, and the forces of the state before.
 * Collective. */
static inline void check_derivative(struct solid *s, double step, double (*u)(const struct solid *s, int h, int c)) {
    double along = 0, size = 0, energy[2];
    solid_ghosts_update(s);
    solid_force(s, 0);
    for (int h = 0; h < s->n; h++)
        for (int c = 0; c < s->dim; c++) {
            const double work = solid_density(s, h) * s->volume[h] * s->a[c][h] * u(s, h, c + 7) * s->in.spacing;
            along += work;
            size += fabs(work);
        }
    for (int side = 0; side < 2; side++) {
        for (int h = 0; h < s->n; h++)
            for (int c = 0; c < s->dim; c++) s->d[c][h] += (side ? -2 : 1) * step * u(s, h, c + 7) * s->in.spacing;
        solid_ghosts_update(s);
        energy[side] = solid_energy_measure(s).strain;
    }
    check_close((energy[1] - energy[0]) / (2 * step) / par_sum(size), par_sum(along) / par_sum(size), 2e-6);
}
