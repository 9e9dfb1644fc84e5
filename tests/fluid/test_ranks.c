/* The same fields on any number of ranks and threads to 1e-12: one rank writes them, the others compare. */
/* Two fluids exist at the same time. */
#include "tests/fluid/fluid_case.h"
#include "base/threads.h"
#include "tests/check.h"
#include "tests/one_rank.h"

#include <stdio.h>
#include <stdlib.h>

enum { NX = 18, NY = 14, NZ = 16, CASES = 11, CELLS = NX * NY * NZ };

/* 4 to 6: implicit diffusion with a larger viscosity, of the first three; 7 to 10: one projection a step, of the first
 * four. */
static struct fluid_input scene(int which) {
    if (which >= 7) {
        struct fluid_input in = scene(which - 7);
        in.projection = FLUID_LAST_STAGE;
        return in;
    }
    if (which >= 4) {
        struct fluid_input in = scene(which - 4);
        in.viscosity = 0.05;
        in.implicit = 1;
        return in;
    }
    struct fluid_input in = {.n = {NX, NY, NZ}, .length = {1.8, 1.4, 1.6}, .density = 1.2, .viscosity = 0.01};
    all_sides(&in, 0, FLUID_PERIODIC);
    all_sides(&in, 1, FLUID_WALL);
    all_sides(&in, 2, FLUID_PERIODIC);
    in.initial_velocity[0] = 0.5;
    if (which != 1) {
        in.side[0][0] = (struct fluid_side){.type = FLUID_INFLOW, .profile = FLUID_POISEUILLE, .bulk_velocity = 0.5};
        in.side[0][1].type = FLUID_OUTFLOW;
    } else {
        in.driving = (struct fluid_driving){FLUID_DRIVING_BULK, 0, 0.5};
    }
    if (which == 2) {
        in.side[2][1] = (struct fluid_side){.type = FLUID_INFLOW, .profile = FLUID_POISEUILLE, .bulk_velocity = 0.3};
        in.side[2][0].type = FLUID_OUTFLOW;
        in.immersed = 1;
    }
    if (which == 3) {
        in.side[1][0] = (struct fluid_side){.type = FLUID_PRESSURE, .pressure = 0.2};
        in.side[2][1].type = FLUID_OUTFLOW;
        in.side[2][0].type = FLUID_SLIP;
    }
    return in;
}

/* u, v, w, p of a whole domain on every rank. */
static void gather(struct fluid *f, double *all) {
    const struct fluid_grid *g = fluid_grid_of(f);
    memset(all, 0, 4 * CELLS * sizeof *all);
    for (int c = 0; c < 4; c++)
        for (int k = 0; k < g->m[2]; k++)
            for (int j = 0; j < g->m[1]; j++)
                for (int i = 0; i < g->m[0]; i++)
                    all[((c * NZ + k + g->lo[2]) * NY + j + g->lo[1]) * NX + i] =
                        component(f, c)[fluid_grid_at(g, i, j, k)];
    par_sum_array(all, 4 * CELLS);
}

/* all[CASES][4][cells] after ten steps. */
static void step(int threads, double *all) {
    struct fluid *f[CASES];
    threads_set(threads);
    for (int w = 0; w < CASES; w++) {
        const struct fluid_input in = scene(w);
        f[w] = fluid_new(&in);
        stir(f[w]);
    }
    for (int s = 0; s < 10; s++)
        for (int w = 0; w < CASES; w++) fluid_step(f[w], 0.02);
    for (int w = 0; w < CASES; w++) {
        gather(f[w], all + (ptrdiff_t)w * 4 * CELLS);
        check_below(fluid_measures_of(f[w]).divergence_max, 1e-11);
        fluid_free(f[w]);
    }
    threads_set(1);
}

static void compare(const double *all, const double *reference) {
    for (int c = 0; c < CASES * 4; c++) {
        double most = 0, worst = 0;
        for (int i = c * CELLS; i < (c + 1) * CELLS; i++) {
            most = fmax(most, fabs(reference[i]));
            worst = check_worst(worst, (reference[i] - all[i]));
        }
        check_above(most, 1e-3);
        assert_true(isfinite(most));
        if (!(worst < 1e-12 * most)) fail_msg("scene %d, component %d: %g of %g", c / 4, c % 4, worst, most);
    }
}

static void same_on_any_number_of_ranks_and_threads(void **state) {
    (void)state;
    const size_t bytes = (size_t)CASES * 4 * CELLS * sizeof(double);
    double *all = malloc(bytes), *reference = malloc(bytes);
    step(1, all);
    one_rank_expects("fluid_ranks", all, bytes, reference);
    compare(all, reference);
    for (int threads = 1 + par_size(); threads <= (par_size() > 2 ? 0 : 5); threads += 3) {
        step(threads, all);
        compare(all, reference);
    }
    free(all);
    free(reference);
}

/* The state in a checkpoint is complete: state arrays copied into a new fluid give the same continuation, also with
 * open low sides. */
static void state_is_all_there_is(void **state) {
    (void)state;
    for (int w = 0; w < CASES; w++) {
        const struct fluid_input in = scene(w);
        struct fluid *f = fluid_new(&in), *other = fluid_new(&in);
        const struct fluid_grid *g = fluid_grid_of(f);
        double worst = 0;
        stir(f);
        for (int s = 0; s < 5; s++) fluid_step(f, 0.02);
        for (int c = 0; c < 4; c++)
            for (int k = 0; k < g->m[2]; k++)
                for (int j = 0; j < g->m[1]; j++)
                    for (int i = 0; i < g->m[0]; i++) {
                        const size_t n = fluid_grid_at(g, i, j, k);
                        component(other, c)[n] = component(f, c)[n];
                    }
        fluid_state_of(other)->driving = fluid_state_of(f)->driving;
        fluid_state_of(other)->t = fluid_state_of(f)->t;
        fluid_state_refresh(other);
        for (int s = 0; s < 5; s++) {
            fluid_step(f, 0.02);
            fluid_step(other, 0.02);
        }
        for (int c = 0; c < 4; c++)
            for (int k = 0; k < g->m[2]; k++)
                for (int j = 0; j < g->m[1]; j++)
                    for (int i = 0; i < g->m[0]; i++) {
                        const size_t n = fluid_grid_at(g, i, j, k);
                        worst = check_worst(worst, (component(other, c)[n] - component(f, c)[n]));
                    }
        check_below(par_max(worst), 1e-12);
        fluid_free(f);
        fluid_free(other);
    }
}

FLUID_TEST_MAIN(cmocka_unit_test(same_on_any_number_of_ranks_and_threads), cmocka_unit_test(state_is_all_there_is))
