/* The lines of the table of docs/performance.md. Reasons of the targets stand on that page. */
#include "program/bench/line.h"

#define SMALL "128x64x64"
#define LARGE "256x128x128"
#define FULL "54872"
#define POROUS "54576"
#define ROW(what_, kind_, part_, size_, ranks_, ...)                                                                   \
    { .what = what_, .kind = BENCH_LINE_##kind_, .part = part_, .size = size_, .ranks = ranks_, __VA_ARGS__ }
#define RUN(what_, kind_, run_, ...)                                                                                   \
    { .what = what_, .kind = BENCH_LINE_##kind_, .run = BENCH_WHOLE_##run_, __VA_ARGS__ }

/* clang-format off */
const struct bench_line bench_lines[] = {
    ROW("fluid, 128 × 64 × 64, inflow–outflow, walls in y: RK3 step", MS, "fluid_step", SMALL, 2),
    ROW("– of the limit", LIMIT, "fluid_step", SMALL, 2, .least = 0.69),
    ROW("– momentum, of its limit", LIMIT, "fluid_momentum", SMALL, 2),
    ROW("– Poisson solve, of its limit", LIMIT, "fluid_poisson", SMALL, 2, .least = 0.75),
    ROW("– – forward pass", LIMIT, "fluid_poisson_forward", SMALL, 2),
    ROW("– – backward pass", LIMIT, "fluid_poisson_backward", SMALL, 2),
    ROW("– with one projection a step, over three", RATIO, "fluid_step_last_stage", SMALL, 2, .over = "fluid_step", .most = 0.6),
    ROW("– CaNS at its best over frana, then", CANS, "fluid_step", SMALL, 2, .least = 5.7),
    ROW("fluid, 256 × 128 × 128, channel: RK3 step", MS, "channel_step", LARGE, 2),
    ROW("– of the limit", LIMIT, "channel_step", LARGE, 2, .least = 0.6),
    ROW("– momentum, of its limit", LIMIT, "channel_momentum", LARGE, 2),
    ROW("– Poisson solve, of its limit", LIMIT, "channel_poisson", LARGE, 2, .least = 0.75),
    ROW("– – forward pass", LIMIT, "channel_poisson_forward", LARGE, 2),
    ROW("– – backward pass", LIMIT, "channel_poisson_backward", LARGE, 2),
    ROW("– with one projection a step, over three", RATIO, "channel_step_last_stage", LARGE, 2, .over = "channel_step", .most = 0.6),
    ROW("– CaNS at its best over frana, then", CANS, "channel_step", LARGE, 2, .least = 4.6),
    ROW("force sweep, full block, 1 rank, a directed bond", NS, "sweep_full", FULL, 1),
    ROW("– of the limit", LIMIT, "sweep_full", FULL, 1, .least = 0.68),
    ROW("– a core's speed on 2 ranks over 1", RATIO, "sweep_full", FULL, 1, .over_ranks = 2, .least = 0.9),
    ROW("– LAMMPS PERI/PMB over frana", LAMMPS, "sweep_full", FULL, 1, .least = 28.8),
    ROW("– in mixed precision over double", RATIO, "sweep_full_mixed", "", 1, .over = "sweep_full_double"),
    ROW("– – of its limit", LIMIT, "sweep_full_mixed", "", 1, .least = 0.44),
    ROW("– – LAMMPS PERI/PMB over frana", LAMMPS, "sweep_full_mixed", "", 1, .over = "sweep_full_double", .least = 40),
    ROW("– with ν = 0.2 over bonds alone", RATIO, "sweep_full_dilated", "", 1, .over = "sweep_full_bonds", .most = 1.9),
    ROW("– – of its limit", LIMIT, "sweep_full_dilated", "", 1),
    ROW("– of an image over a box", RATIO, "sweep_full_image", "", 1, .over = "sweep_full_box"),
    ROW("force sweep, the main case's porous block, 1 rank, a directed bond", NS, "sweep_porous", POROUS, 1),
    ROW("– of the limit", LIMIT, "sweep_porous", POROUS, 1, .least = 0.45),
    ROW("– a core's speed on 2 ranks over 1", RATIO, "sweep_porous", POROUS, 1, .over_ranks = 2, .least = 0.9),
    ROW("– in mixed precision over double", RATIO, "sweep_porous_mixed", "", 1, .over = "sweep_porous_double"),
    ROW("– – of its limit", LIMIT, "sweep_porous_mixed", "", 1, .least = 0.31),
    ROW("– with ν = 0.2 over bonds alone", RATIO, "sweep_porous_dilated", "", 1, .over = "sweep_porous_bonds"),
    ROW("– of an image over a box", RATIO, "sweep_porous_image", "", 1, .over = "sweep_porous_box"),
    ROW("– with damping", NS, "sweep_porous_damped", POROUS, 1),
    ROW("– – of its limit", LIMIT, "sweep_porous_damped", POROUS, 1, .least = 0.49),
    ROW("– – a core's speed on 2 ranks over 1", RATIO, "sweep_porous_damped", POROUS, 1, .over_ranks = 2, .least = 0.9),
    ROW("force sweep, a plate with holes, 1 rank, a directed bond", NS, "sweep_plate", "", 1),
    ROW("– of the limit", LIMIT, "sweep_plate", "", 1, .least = 0.22),
    ROW("pressures of a crack of 40 spacings' radius, among 10⁶ particles, over the force sweep, 1 rank", RATIO, "crack_pressures", "1000000", 1, .over = "crack_sweep", .most = 0.2),
    ROW("– 2 ranks", RATIO, "crack_pressures", "1000000", 2, .over = "crack_sweep"),
    ROW("– a substep with these pressures over one without, 1 rank", RATIO, "crack_substep_wet", "1000000", 1, .over = "crack_substep_dry"),
    ROW("coupled step of the main case, 2 ranks", MS, "coupled_step", SMALL, 2),
    ROW("– forcing (N_s = 2) and probe, over the fluid's step", RATIO, "forcing+probe", SMALL, 2, .over = "fluid_step", .most = 0.41),
    ROW("– forcing, of its limit", LIMIT, "forcing", SMALL, 2),
    ROW("– probe, of its limit", LIMIT, "probe", SMALL, 2),
    ROW("– with breakage on, intact, over breakage off", RATIO, "coupled_step_breakage", SMALL, 2, .over = "coupled_step"),
    RUN("the whole S3, Verlet, 2 ranks", MINUTES, VERLET),
    RUN("– over its fluid's steps alone", STEPS, VERLET, .most = 2.5),
    RUN("– contact in the fracture stage, of the run", CONTACT, VERLET, .most = 0.022),
    RUN("– samples and output, of the run", OUTPUT, VERLET, .most = 0.02),
    RUN("– the parts measured alone, over the run", PARTS, VERLET, .least = 0.9),
    RUN("the whole S3, default load and cheaper settings", MINUTES, ECONOMICAL),
    RUN("– over the Verlet run", RUNS, ECONOMICAL, .most = 0.73),
    RUN("the whole S3, RK3", MINUTES, RK3),
    RUN("– over the Verlet run", RUNS, RK3, .most = 1.1),
    ROW("memory of the fluid, 128 × 64 × 64, 2 ranks, a cell", BYTES, "memory_fluid", SMALL, 2, .most = 83.337),
    ROW("memory of the main case's run, a cell", BYTES, "memory_run", SMALL, 2, .most = 329.76),
    ROW("memory of the main case's block, a directed bond", BYTES, "memory_lattice_bond", POROUS, 2, .most = 2.1748),
    ROW("– in lists", BYTES, "memory_list_bond", POROUS, 2, .most = 24.394),
    ROW("– an image, 1 rank", BYTES, "memory_image_bond", "", 1),
};
/* clang-format on */
const int bench_lines_count = sizeof bench_lines / sizeof *bench_lines;
