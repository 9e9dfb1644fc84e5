/* Time of a full Runge-Kutta step of a channel with inflow, outflow, walls and a periodic span:
 *     bench_step [steps [nx ny nz]]                                                                        */
#include "base/clock.h"
#include "base/par.h"
#include "fluid/fluid.h"

#include <stdio.h>
#include <stdlib.h>

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const int steps = argc > 1 ? atoi(argv[1]) : 50;
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
    struct fluid *f = fluid_new(&in);
    const double dt = 0.9 * fluid_stable_step(f).step;
    double best = 1e9;
    for (int i = 0; i < 5; i++) fluid_step(f, dt);
    clock_reset();
    const double start = par_seconds();
    for (int i = 0; i < steps; i++) {
        const double t = par_seconds();
        fluid_step(f, dt);
        if (par_seconds() - t < best) best = par_seconds() - t;
    }
    const double step = (par_seconds() - start) / steps, cells = (double)fluid_cells(f);
    const double div = fluid_divergence_max(f);
    if (par_rank() == 0)
        printf("%d ranks, %.0f cells: %.2f ms a step (best %.2f), %.1f ns per cell-step and rank; momentum "
               "%.2f, Poisson %.2f, halo %.2f ms; "
               "div %.1e 1/s\n",
               par_size(), cells, 1e3 * step, 1e3 * best, 1e9 * step / cells * par_size(),
               1e3 * clock_seconds(CLOCK_MOMENTUM) / steps, 1e3 * clock_seconds(CLOCK_POISSON) / steps,
               1e3 * clock_seconds(CLOCK_HALO) / steps, div);
    fluid_free(f);
    par_end();
    return 0;
}
