/* Measures a step of the fluid alone and its parts, with the bytes and flops that they need. */
#include "base/ensure.h"
#include "base/par.h"
#include "base/par_halo.h"
#include "program/bench/parts.h"

#include <math.h>

struct flow {
    struct fluid *fluid;
    double dt;
};

static void step(void *with) {
    const struct flow *f = with;
    fluid_step(f->fluid, f->dt);
}

/* Fills one ghost layer of the three velocities. */
static void halo(void *with) {
    const struct flow *f = with;
    struct fluid_state *s = fluid_state_of(f->fluid);
    par_halo_fill(fluid_grid_of(f->fluid)->halos, 3, (double *const[]){s->u, s->v, s->w}, 1);
}

/* A uniform flow, from which either a channel or a flow from inflow to outflow develops. */
static struct fluid *fluid_of(const int cells[3], int channel, enum fluid_projection projection) {
    const double d = 1.5625e-3; /* m */
    struct fluid_input in = {
        .length = {cells[0] * d, cells[1] * d, cells[2] * d},
        .density = 1000,
        .viscosity = 1e-3,
        .initial_velocity = {0.1, 0, 0},
        .projection = projection,
        .side = {{{.type = FLUID_INFLOW, .profile = FLUID_POISEUILLE, .bulk_velocity = 0.1}, {.type = FLUID_OUTFLOW}},
                 {{.type = FLUID_WALL}, {.type = FLUID_WALL}},
                 {{.type = FLUID_PERIODIC}, {.type = FLUID_PERIODIC}}}};
    for (int c = 0; c < 3; c++) in.n[c] = cells[c];
    if (channel) {
        in.side[0][0] = in.side[0][1] = (struct fluid_side){.type = FLUID_PERIODIC};
        in.driving = (struct fluid_driving){FLUID_DRIVING_BULK, 0, 0.1};
    }
    return fluid_new(&in);
}

struct fluid *bench_fluid_new(const int cells[3], int channel) {
    return fluid_of(cells, channel, FLUID_EACH_STAGE);
}

/* Compulsory traffic of a cell and stage, in doubles.
 * Momentum: u, v, w, p in (4), u* out (3), R_old in at two stages of three and R out at two of three (3 each): 11.
 * Forward (divergence, transforms in the cache, the recurrence up z): u* in, its y out: 3 + 1; u* is in the cache where
 * the momentum pass is joined to this: 1.
 * Columns: only the last direction's values at the ranks' ends: negligible.
 * Backward (the recurrence down z, transforms in the cache, correction): y, u*, p in, u, v, w, p out: 1 + 3 + 1 + 4.
 * Flops of a cell and stage.
 * Momentum, a component: fluxes 2 + 3 + 3 (sums and a product through the own faces and the two others), their
 * differences 3, scales 3, sums 2; diffusion 3 x 3 and a scale; predictor 6; pressure gradient and source 4: 36.
 * Forward: divergence 8, transforms of 5/2 log2 n a point in x and y, recurrence 3. Backward: recurrence 5, the
 * transforms, correction 3 x 3 and the pressure's 1. */
struct work {
    double doubles, flops;
};
enum part { STEP, MOMENTUM, POISSON, FORWARD, COLUMNS, BACKWARD, HALO, PARTS };

static struct work work_of(enum part part, const int n[3], int joined) {
    const double transforms = 2.5 * (log2(n[0]) + log2(n[1]));
    const struct work momentum = {11, 3 * 36}, forward = {joined ? 1 : 4, 11 + transforms},
                      backward = {9, 15 + transforms};
    switch (part) {
    case MOMENTUM:
        return momentum;
    case FORWARD:
        return forward;
    case BACKWARD:
        return backward;
    case POISSON:
        return (struct work){forward.doubles + backward.doubles, forward.flops + backward.flops};
    case STEP:
        return (struct work){momentum.doubles + forward.doubles + backward.doubles,
                             momentum.flops + forward.flops + backward.flops};
    case COLUMNS:
    case HALO:
        return (struct work){0, 0};
    case PARTS:
        break;
    }
    ENSURE(0, "part %d", (int)part);
}

static const struct {
    const char *name[2]; /* with inflow and outflow; periodic along x */
    int channel;
} part[PARTS] = {[STEP] = {{"fluid_step", "channel_step"}, BENCH_WALL},
                 [MOMENTUM] = {{"fluid_momentum", "channel_momentum"}, BENCH_CLOCK + CLOCK_MOMENTUM},
                 [POISSON] = {{"fluid_poisson", "channel_poisson"}, BENCH_CLOCK + CLOCK_POISSON},
                 [FORWARD] = {{"fluid_poisson_forward", "channel_poisson_forward"}, BENCH_CLOCK + CLOCK_FORWARD},
                 [COLUMNS] = {{"fluid_poisson_columns", "channel_poisson_columns"}, BENCH_CLOCK + CLOCK_COLUMNS},
                 [BACKWARD] = {{"fluid_poisson_backward", "channel_poisson_backward"}, BENCH_CLOCK + CLOCK_BACKWARD},
                 [HALO] = {{"fluid_halo", "channel_halo"}, BENCH_CLOCK + CLOCK_HALO}};

/* The times of the parts are those of the program's clocks while whole steps run. */
static void measure_step(struct bench *bench, struct flow *f, const int n[3], int channel, int parts) {
    struct bench_sample sample[1][BENCH_CHANNELS];
    bench_measure(&bench->repetition, step, 1, (void *[]){f}, sample);
    for (int k = 0; k < parts; k++) {
        const struct work w = work_of((enum part)k, n, fluid_is_joined(f->fluid));
        struct bench_row row = {.part = part[k].name[channel],
                                .time = sample[0][part[k].channel],
                                .units = (double)fluid_cells(f->fluid),
                                .unit = "cell-step",
                                .bytes = 3 * 8 * w.doubles,
                                .flops = 3 * w.flops};
        snprintf(row.size, sizeof row.size, "%dx%dx%d", n[0], n[1], n[2]);
        bench_row_write(&bench->table, &row);
        if (k == STEP) bench_row_traffic(&bench->table, row.part, row.size, step, f, 2);
    }
}

/* A ghost value is read once, where it is owned, and written once, in the ghost. */
static void measure_halo(struct bench *bench, struct flow *f, const int n[3]) {
    const struct fluid_grid *g = fluid_grid_of(f->fluid);
    double ghosts = 1, cells = 1;
    for (int c = 0; c < 3; c++) ghosts *= g->m[c] + 2, cells *= g->m[c];
    bench_row_write_cells(&bench->table, n,
                          (struct bench_row){.part = "halo_fill",
                                             .time = bench_measure_one(&bench->repetition, halo, f),
                                             .units = 3 * par_sum(ghosts - cells),
                                             .unit = "ghost value",
                                             .bytes = 16});
}

/* A step with one projection in place of three. What it must move and compute is not counted. */
static void measure_last_stage(struct bench *bench, const int n[3], int channel) {
    struct flow f = {.fluid = fluid_of(n, channel, FLUID_LAST_STAGE)};
    f.dt = 0.5 * fluid_limits_stable_step(f.fluid).step;
    bench_row_write_cells(&bench->table, n,
                          (struct bench_row){.part = channel ? "channel_step_last_stage" : "fluid_step_last_stage",
                                             .time = bench_measure_one(&bench->repetition, step, &f),
                                             .units = (double)fluid_cells(f.fluid),
                                             .unit = "cell-step"});
    fluid_free(f.fluid);
}

static void measure(struct bench *bench, const int n[3], int channel, int by_part) {
    struct flow f = {.fluid = bench_fluid_new(n, channel)};
    f.dt = 0.5 * fluid_limits_stable_step(f.fluid).step;
    measure_step(bench, &f, n, channel, by_part ? PARTS : 1);
    if (by_part && !channel) measure_halo(bench, &f, n);
    fluid_free(f.fluid);
    if (!bench->sizes) measure_last_stage(bench, n, channel);
}

void bench_fluid(struct bench *bench) {
    if (bench->sizes) {
        for (int k = 0; k < bench->sizes; k++)
            if (bench->size[k].cells[0]) measure(bench, bench->size[k].cells, 0, 1);
    } else if (bench->quick) {
        measure(bench, (int[]){32, 16, 16}, 0, 1);
        measure(bench, (int[]){32, 16, 16}, 1, 1);
    } else {
        measure(bench, (int[]){128, 64, 64}, 0, 1);
        measure(bench, (int[]){256, 128, 128}, 1, 1);
    }
}

void bench_fluid_growth(struct bench *bench) {
    static const int n[][3] = {{32, 16, 16}, {64, 32, 32}, {128, 64, 64}, {256, 128, 128}};
    for (int k = 0; k < (bench->quick ? 2 : 4); k++) measure(bench, n[k], 0, 0);
}
