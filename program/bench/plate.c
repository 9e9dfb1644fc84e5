/* Measures force sweeps over the bonds of a plate with holes. */
#include "base/par.h"
#include "program/bench/parts.h"
#include "solid/bonds/list_rows.h"
#include "solid/solid.h"

#include <math.h>

enum { HOLES = 8 };
static const double SPACING = 1e-3; /* m */

/* A plate with eight round holes in two rows. The edges are the exact curves, and cells are clipped by them. */
static struct solid *plate_new(const int sites[2]) {
    static const signed char straight[4] = {0}, round[2] = {1, 1};
    const double width = sites[0] * SPACING, height = sites[1] * SPACING, radius = 0.053 * height;
    const double corner[4][2] = {{0, 0}, {width, 0}, {width, height}, {0, height}}, none[4][2] = {{0}};
    double end[HOLES][2][2], centre[HOLES][2][2];
    struct solid_outline outline[1 + HOLES] = {{0, 4, corner, none, straight}};
    for (int k = 0; k < HOLES; k++) {
        const double at[2] = {(k + 0.5) * width / HOLES, (0.31 + 0.37 * (k % 2)) * height};
        for (int q = 0; q < 2; q++) {
            for (int c = 0; c < 2; c++) centre[k][q][c] = end[k][q][c] = at[c];
            end[k][q][0] += q ? radius : -radius;
        }
        outline[1 + k] = (struct solid_outline){1, 2, end[k], centre[k], round};
    }
    const struct solid_material material = {65e9, 2235, 204, 3, PHYSICS_CONSTANT, 0, 0};
    return bench_sweep_plate(1 + HOLES, outline, &material, NULL);
}

/* Each bond is computed once, for both its ends. Flops: the relative displacement 2, eps = eta.(2 xi + eta)/xi^2 6, the
 * stretch's polynomial of degree four 9, weights 4, zeta 2, and the force added at both ends 8: 31 a bond, 15.5
 * directed. With damping relative velocities 2, their part along zeta 3, 1/(1 + eps) 2, scales 2, the sum 1, and the
 * power 2: 12 more. A directed bond is 4 B for the other end, two singles for xi, and a double; nothing in the rows of
 * the lattice (solid/bonds/list_rows.h). Particles: displacement in, acceleration in and out, and w in. */
static void measure(struct bench *bench, const char *part, struct solid *s, double damping) {
    s->stage.damping_relative = damping;
    struct bench_row row = bench_sweep_row(part, s, bench_measure_one(&bench->repetition, bench_sweep, s));
    row.flops = 15.5 + (damping > 0 ? 6 : 0);
    const double in_rows = (double)par_sum_long(solid_list_rows_bonds(s->family->list[0])) / row.units;
    row.bytes = 20 * (1 - in_rows) + 8 * (damping > 0 ? 9 : 7) * (double)s->n_global / row.units;
    bench_row_write(&bench->table, &row);
}

void bench_plate(struct bench *bench) {
    const int sites[2] = {bench->quick ? 60 : 420, bench->quick ? 45 : 270};
    struct solid *s = plate_new(sites);
    measure(bench, "sweep_plate", s, 0);
    measure(bench, "sweep_plate_damped", s, 1e8);
    solid_free(s);
}
