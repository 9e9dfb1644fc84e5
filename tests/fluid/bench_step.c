/* Time of a full Runge-Kutta step, by part:
 *     bench_step [steps [nx ny nz [channel]]]
 * with walls in y and a periodic span; inflow and outflow in x, or periodic and driven (channel). */
#include "base/clock.h"
#include "base/memory.h"
#include "base/par.h"
#include "fluid/fluid.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int ascending(const void *a, const void *b) {
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const int steps = argc > 1 && atoi(argv[1]) > 0 ? atoi(argv[1]) : 50;
    struct fluid_input in = {
        .n = {128, 64, 64},
        .length = {0.2, 0.1, 0.1},
        .density = 1000,
        .viscosity = 1e-3,
        .initial_velocity = {0.1, 0, 0},
        .side = {{{.type = FLUID_INFLOW, .profile = FLUID_POISEUILLE, .bulk_velocity = 0.1},
                  {.type = FLUID_OUTFLOW}},
                 {{.type = FLUID_WALL}, {.type = FLUID_WALL}},
                 {{.type = FLUID_PERIODIC}, {.type = FLUID_PERIODIC}}}};
    for (int d = 0; d < 3 && argc > 4; d++) in.n[d] = atoi(argv[2 + d]);
    if (argc > 5 && strcmp(argv[5], "channel") == 0) {
        in.side[0][0].type = in.side[0][1].type = FLUID_PERIODIC;
        in.driving = (struct fluid_driving){FLUID_DRIVING_BULK, 0, 0.1};
    }
    const double before = par_seconds();
    struct fluid *f = fluid_new(&in);
    const double setup = par_seconds() - before, dt = 0.9 * fluid_stable_step(f).step;
    double *time = malloc((size_t)steps * sizeof *time);
    for (int i = 0; i < 5; i++) fluid_step(f, dt);
    clock_reset();
    for (int i = 0; i < steps; i++) {
        const double t = par_seconds();
        fluid_step(f, dt);
        time[i] = 1e3 * (par_seconds() - t);
    }
    qsort(time, (size_t)steps, sizeof *time, ascending);
    const double cells = (double)fluid_cells(f), bytes = par_sum((double)memory_bytes(MEMORY_FLUID));
    const double div = fluid_divergence_max(f);
    if (par_rank() == 0) {
        printf("%d ranks, %.0f cells: median %.2f ms a step (best %.2f, worst %.2f), %.1f ns per cell-step "
               "and rank; "
               "momentum %.2f, Poisson %.2f, halo %.2f ms; ",
               par_size(), cells, time[steps / 2], time[0], time[steps - 1],
               1e6 * time[steps / 2] / cells * par_size(), 1e3 * clock_seconds(CLOCK_MOMENTUM) / steps,
               1e3 * clock_seconds(CLOCK_POISSON) / steps, 1e3 * clock_seconds(CLOCK_HALO) / steps);
        printf("set-up %.2f s, %.0f B a cell, div %.1e 1/s\n", setup, bytes / cells, div);
    }
    free(time);
    fluid_free(f);
    par_end();
    return 0;
}
