/* Strained state and force sweep that the solid's benches time. */
#include "program/bench/parts.h"
#include "solid/bonds/family.h"
#include "solid/bonds/ghosts.h"
#include "solid/force/force.h"

#include <math.h>

void bench_sweep_strain(struct solid *s) {
    for (int h = 0; h < s->n; h++)
        for (int c = 0; c < s->dim; c++) s->d[c][h] = 2e-4 * s->in.spacing * sin(300 * s->x0[(c + 1) % s->dim][h] + c);
    solid_ghosts_update(s);
}

void bench_sweep(void *solid) {
    struct solid *s = solid;
    solid_ghosts_update(s);
    solid_force(s, 1);
}
