/* ns per directed bond of a force sweep on a full and on a porous block:  bench_force [seconds each] */
#include "base/par.h"
#include "solid/family.h"
#include "solid/solid.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

/* The processor's time, s: what a busy machine takes for others does not count. */
static double cpu_seconds(void) {
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static const double SPACING = 1.5625e-3;

static struct solid *block(int porous, int list) {
    struct solid_body body = {.name = "block", .shape = SOLID_BOX, .high = {38, 38, 38}};
    if (porous) { /* the main case's */
        body = (struct solid_body){.shape = SOLID_BOX, .low = {16, -3, 0}, .high = {64, 67, 64}};
        body.cavity_period = 16 * SPACING;
        body.cavity_radius = 9.15 * SPACING;
        body.cavity_centre[0] = 16.15 * SPACING;
    }
    for (int c = 0; c < 3; c++) {
        body.low[c] *= SPACING;
        body.high[c] *= SPACING;
    }
    const struct solid_material material = {1e8, 3000, 0.05, 3};
    const struct solid_input in = {.spacing = SPACING,
                                   .bodies = 1,
                                   .body = &body,
                                   .materials = 1,
                                   .material = &material,
                                   .surface_correction = 1,
                                   .periodic = {0, 0, porous},
                                   .length = {128 * SPACING, 64 * SPACING, 64 * SPACING},
                                   .general_bonds = list};
    return solid_new(&in);
}

static void measure(const char *name, int porous, int list, double damping, double seconds) {
    struct solid *s = block(porous, list);
    s->stage.damping_relative = damping;
    for (int h = 0; h < s->n; h++)
        for (int c = 0; c < 3; c++) s->d[c][h] = 2e-4 * SPACING * sin(300 * s->x0[(c + 1) % 3][h] + c);
    solid_ghosts_update(s);
    solid_force(s, 1);
    const double bonds = (double)par_sum_long(solid_family_directed(s));
    double best = INFINITY, start = par_seconds();
    long sweeps = 0;
    do {
        par_barrier();
        const double t = cpu_seconds();
        solid_ghosts_update(s);
        solid_force(s, 1);
        best = fmin(best, par_max(cpu_seconds() - t));
        sweeps++;
    } while (par_min(par_seconds() - start) < seconds);
    const double mean = (par_seconds() - start) / (double)sweeps;
    const double t0 = cpu_seconds();
    solid_advance(s, 1e-6, 10);
    const double step = par_max(cpu_seconds() - t0) / 30;
    solid_count_bonds(s);
    if (par_rank() == 0)
        printf("%-20s %6ld particles %6.1f bonds each  sweep %7.3f ms  ns/bond/core, cpu: sweep %.3f, RK3 "
               "%.3f; wall: "
               "%.3f; broken %ld\n",
               name, s->n_global, bonds / (double)s->n_global, 1e3 * best, 1e9 * best / bonds * par_size(),
               1e9 * step / bonds * par_size(), 1e9 * mean / bonds * par_size(), s->bonds_broken);
    solid_free(s);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const double seconds = argc > 1 ? atof(argv[1]) : 1;
    measure("full 38^3", 0, 0, 0, seconds);
    measure("porous 48 x 70 x 64", 1, 0, 0, seconds);
    measure("full, damped", 0, 0, 1e3, seconds);
    measure("porous, damped", 1, 0, 1e3, seconds);
    measure("full, lists", 0, 1, 0, seconds);
    measure("porous, lists", 1, 1, 0, seconds);
    measure("full, lists, damped", 0, 1, 1e3, seconds);
    par_end();
    return 0;
}
