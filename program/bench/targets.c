/* The table of targets, and how it is written.
 * Targets: docs/performance.md. Reasons: docs/design/fluid.md, solid.md, ibm.md, cracks.md and docs/timeline.md. */
#include "program/bench/targets.h"
#include "program/bench/sentence.h"

#include <math.h>
#include <stdio.h>

/* clang-format off */
const struct bench_target bench_targets[] = {
    {.what = "fluid, 128 × 64 × 64, inflow–outflow, walls in y, 2 ranks, an RK3 step",
     .peer = "CaNS {cans fluid_step 128x64x64} ms as it comes, {cans_best fluid_step 128x64x64} ms at its "
             "best, ours then {cans_ours fluid_step 128x64x64} ms",
     .ours = bench_value_ms, .of = {"fluid_step", "128x64x64", 2, 0},
     .reach = 8, .unit = "ms",
     .why = "Memory traffic would allow {least fluid_step 128x64x64 2} ms. The Poisson solver takes {ms "
            "fluid_poisson 128x64x64 2} ms and momentum {ms fluid_momentum 128x64x64 2} ms, mostly for "
            "arithmetic on data in the first two caches. Ghosts take {ms fluid_halo 128x64x64 2} ms, of "
            "which more than half is waiting for the other rank."},
    {.what = "fluid, 256 × 128 × 128, channel, 2 ranks",
     .peer = "CaNS {cans channel_step 256x128x128} ms as it comes, {cans_best channel_step 256x128x128} ms "
             "at its best, ours then {cans_ours channel_step 256x128x128} ms",
     .ours = bench_value_ms, .of = {"channel_step", "256x128x128", 2, 0},
     .reach = 85, .unit = "ms",
     .why = "Memory traffic would allow {least channel_step 256x128x128 2} ms. As on the small grid the "
            "transforms' and the fluxes' arithmetic in the caches is the limit: the Poisson solver takes "
            "{ms channel_poisson 256x128x128 2} ms, momentum {ms channel_momentum 256x128x128 2} ms."},
    {.what = "fluid, 128 × 64 × 64, as in line 1 with one projection a step (`fluid.projection: last_stage`)",
     .ours = bench_value_ms, .of = {"fluid_step_last_stage", "128x64x64", 2, 0},
     .reach = 8, .unit = "ms",
     .why = "With one projection a step the scheme is of second order in time, CaNS's is of third. Below an error of "
            "0.05 % in time three projections and longer steps cost less (cases/verification/projection)."},
    {.what = "fluid, 256 × 128 × 128, channel, as in line 2 with one projection a step",
     .ours = bench_value_ms, .of = {"channel_step_last_stage", "256x128x128", 2, 0},
     .reach = 85, .unit = "ms",
     .why = "The same holds as for the line before."},
    {.what = "Poisson solve, 128 × 64 × 64, 2 ranks, share of its roofline",
     .ours = bench_value_roofline, .of = {"fluid_poisson", "128x64x64", 2, 0},
     .reach = 75, .at_least = 1, .unit = "%",
     .why = "The limit is the arithmetic of transforms in the first-level cache. The roofline counts an "
            "operation as half of a fused multiply-add, but most operations of a transform are additions. "
            "The forward pass (divergence, transforms) has {roofline fluid_poisson_forward 128x64x64 2} %, "
            "the backward pass (transforms, correction) {roofline fluid_poisson_backward 128x64x64 2} %."},
    {.what = "Poisson solve, 256 × 128 × 128, 2 ranks, share of its roofline",
     .ours = bench_value_roofline, .of = {"channel_poisson", "256x128x128", 2, 0},
     .reach = 75, .at_least = 1, .unit = "%",
     .why = "The limit is the same. The forward pass, which moves few bytes, has {roofline "
            "channel_poisson_forward 256x128x128 2} %. The backward pass has {roofline "
            "channel_poisson_backward 256x128x128 2} %, because its correction is near the bandwidth of "
            "memory."},
    {.what = "force sweep, full block in double, 1 rank, a directed bond",
     .peer = "LAMMPS PERI/PMB {lammps} ns",
     .ours = bench_value_ns, .of = {"sweep_full", "54872", 1, 0},
     .reach = 0.5, .unit = "ns",
     .why = "The limit is the multipliers: the sweep reaches {roofline sweep_full 54872 1} % of what they "
            "can do. An entry also waits for results of operations that depend on each other, which fill "
            "the schedulers of the vector units, and for loads that cross cache lines."},
    {.what = "force sweep, full block in double, a core's speed on 2 ranks over 1",
     .ours = bench_value_core_speed, .of = {"sweep_full", "54872", 2, 0},
     .reach = 90, .at_least = 1, .unit = "%",
     .why = "Both ranks compute the bonds across the border of their parts, in entries of fewer bonds. The cores "
            "share the third-level cache and memory."},
    {.what = "force sweep, the main case's porous block, 1 rank, a directed bond",
     .ours = bench_value_ns, .of = {"sweep_porous", "54576", 1, 0},
     .reach = 0.75, .unit = "ns",
     .why = "The limit is the multipliers too, of which the sweep reaches {roofline sweep_porous 54576 1} "
            "%. Beside cavities about half of the eight lanes of an entry have no bond, and most entries "
            "are narrow ones of four lanes, which take two thirds of a wide one's time."},
    {.what = "force sweep, porous block, a core's speed on 2 ranks over 1",
     .ours = bench_value_core_speed, .of = {"sweep_porous", "54576", 2, 0},
     .reach = 90, .at_least = 1, .unit = "%",
     .why = "What two ranks lose is in the bonds within each part. Two independent programs at the same "
            "time lose as much, because the cores share the third-level cache and memory."},
    {.what = "force sweep, porous block with damping, 1 rank, a directed bond",
     .ours = bench_value_ns, .of = {"sweep_porous_damped", "54576", 1, 0},
     .reach = 0.95, .unit = "ns",
     .why = "The limit is the arithmetic of bond and relative velocity: {flops sweep_porous_damped 54576 1} "
            "operations a directed bond in place of {flops sweep_porous 54576 1}. As without damping about "
            "half of the lanes have no bond."},
    {.what = "force sweep, porous block with damping, a core's speed on 2 ranks over 1",
     .ours = bench_value_core_speed, .of = {"sweep_porous_damped", "54576", 2, 0},
     .reach = 90, .at_least = 1, .unit = "%",
     .why = "The same as without damping."},
    {.what = "force sweep, full block in mixed precision, 1 rank, a directed bond",
     .ours = bench_value_ns, .of = {"sweep_full_mixed", "54872", 1, 0},
     .reach = 0.35, .unit = "ns",
     .why = "The limit is the number of instructions, which hardly depends on the width of their numbers: a "
            "bond's three reactions are stored as in double. In turn with it double takes {ns "
            "sweep_full_double 54872 1} ns."},
    {.what = "force sweep, porous block in mixed precision, 1 rank, a directed bond",
     .ours = bench_value_ns, .of = {"sweep_porous_mixed", "54576", 1, 0},
     .reach = 0.5, .unit = "ns",
     .why = "The limit is the number of instructions. A narrow entry takes as many of them as a wide one, "
            "for half of the lanes. In turn with it double takes {ns sweep_porous_double 54576 1} ns."},
    {.what = "force sweep, mixed precision, LAMMPS's time a directed bond over ours, 1 rank",
     .peer = "LAMMPS PERI/PMB {lammps} ns",
     .ours = bench_value_lammps, .of = {"sweep_full_mixed", "54872", 1, 0},
     .reach = 40, .at_least = 1, .unit = "",
     .why = "In double the ratio is {lammps_ratio}, with both programs in turn. It is multiplied by the "
            "ratio of double to mixed precision, which were measured in turn too. The limit is that of the "
            "full block in mixed precision."},
    {.what = "force sweep, a plate with holes, 1 rank, a directed bond",
     .ours = bench_value_ns, .of = {"sweep_plate", "", 1, 0},
     .reach = 1.2, .unit = "ns",
     .why = "The limit is the arithmetic: most particles are swept in rows of eight with common constants, "
            "where the multipliers are busy for about half of the time. Particles near edges and holes are "
            "swept by lists of bonds, with gathered displacements."},
    {.what = "forcing (N_s = 2) and probe of a coupled step, 2 ranks",
     .ours = bench_value_immersed, .of = {"forcing", "128x64x64", 2, 0},
     .reach = 4, .unit = "ms",
     .why = "The limit is loads and stores in the first-level cache: the rows of a marker's block begin at "
            "any value, so half of the stores cross a boundary of 32 bytes. Half of the probe is arithmetic, "
            "the rest exchanges and fetches the tips' data. In the main case's settling stage the two take {stage settle "
            "forcing} and {stage settle probe} ms a step, with new markers and waiting, because other "
            "parts' data have filled the caches."},
    {.what = "contact in the fracture stage of the whole S3, Verlet, 2 ranks",
     .ours = bench_value_contact, .of = {"", "", 2, 0},
     .reach = 8, .unit = "s",
     .why = "In each of {sweeps} substeps a step contact is solved by a dozen iterations over the pairs that touch, "
            "a fifth of the time in a crushed block. A quarter is finding these among the listed pairs and copying them, "
            "from memory that the force sweep has left cold. A fifth is lists of pairs, the rest reading and writing the "
            "particles and waiting. How far the block is crushed, and with it this time, depends on round-off "
            "(cases/porous_channel)."},
    {.what = "pressures of a crack that a fluid is pumped into, 10⁶ particles, radius 40 spacings, 1 rank, "
             "of the sweep",
     .ours = bench_value_cracks, .of = {"crack_pressures", "1000000", 1, 0},
     .reach = 20, .unit = "%",
     .why = "The limit is the iterations of the pressures' linear system. Two fifths of an iteration are two "
            "sweeps over the struts, a quarter is fourteen over the links, in which the preconditioner reduces what "
            "varies within a few spacings. Bricks of particles do the same for what varies over the crack."},
    {.what = "the whole S3, Verlet, 2 ranks",
     .peer = "CaNS's steps at its best and LAMMPS's sweeps, as many of each: {peers 0} min",
     .ours = bench_value_minutes, .of = {"", "", 2, 0},
     .reach = 6, .unit = "min",
     .why = "The force sweeps take {share solid} % of it, with {sweeps} sweeps a step in the fracture stage, which "
            "is what the stability of the bonds needs. The Poisson solver takes {share poisson} %, "
            "forcing {share forcing} %, momentum {share momentum} %."},
    {.what = "the whole S3 with the default load and cheaper settings, Verlet, 2 ranks",
     .peer = "CaNS's steps at its best and LAMMPS's sweeps, as many of each: {peers 2} min",
     .ours = bench_value_minutes, .of = {"", "", 2, BENCH_WHOLE_ECONOMICAL},
     .reach = 6, .unit = "min",
     .why = "This is `cases/porous_channel/economical.sh`: load by reaction, one projection a step, bonds in mixed "
            "precision, the fluid by Adams and Bashforth's scheme where the block is elastic, and the block settles "
            "with twice the step, so in half as many steps. More bonds break than by the probe. The force sweeps take "
            "{share solid 2} % of it, contact {share contact 2} %, forcing {share forcing 2} %, momentum {share momentum 2} %, the Poisson solver {share poisson 2} %."},
    {.what = "the whole S3, RK3, 2 ranks",
     .peer = "CaNS's steps at its best and LAMMPS's sweeps, as many of each: {peers 1} min",
     .ours = bench_value_minutes, .of = {"", "", 2, BENCH_WHOLE_RK3},
     .reach = 9, .unit = "min",
     .why = "The limit is the force sweeps, three a substep. Contact's stiffness bounds the substep, with "
            "{substeps 1} substeps in the last step."},
    {.what = "the whole S3, Verlet, 2 ranks: the bench's parts, as many as it has, over its time",
     .ours = bench_value_parts, .of = {"", "", 2, 0},
     .reach = 90, .at_least = 1, .unit = "%",
     .why = "The bench and the run each take minutes, and the shared machine changes its speed between and within them: "
            "the same parts gave 92 and 113 % with an earlier run. {waiting} % of the run is waiting for the other "
            "rank, and {share output} % output, which is no part of the sum."},
    {.what = "the whole S3, Verlet, 2 ranks: samples and output, of its time",
     .ours = bench_value_output, .of = {"", "", 2, 0},
     .reach = 2, .unit = "%",
     .why = "The limit is the work of a sample: it reads all fields of fluid and solid, which have left the "
            "caches by then, and computes the energy of every bond. In the fracture stage bonds break between all "
            "samples, so that each finds fragments, damage and connected pores anew. The scene samples every tenth "
            "step. Fields and checkpoints are four tenths of it."},
    {.what = "memory of the fluid, 128 × 64 × 64, 2 ranks, a cell",
     .ours = bench_value_bytes, .of = {"memory_fluid", "128x64x64", 2, 0},
     .reach = 0, .unit = "B",
     .why = "The limit is the fields. What a rank holds beside them does not shrink with its part: planes "
            "that momentum and divergence share, scratch of the transforms, and buffers of ghosts. On one "
            "rank it is {bytes memory_fluid 128x64x64 1} B a cell."},
    {.what = "memory of the main case's run, 2 ranks, a cell",
     .ours = bench_value_bytes, .of = {"memory_run", "128x64x64", 2, 0},
     .reach = 0, .unit = "B",
     .why = "The limit is the fluid's fields and what a marker holds, {bytes memory_marker 128x64x64 2} B."},
    {.what = "memory of the main case's block, 2 ranks, a directed bond",
     .ours = bench_value_bytes, .of = {"memory_lattice_bond", "54576", 2, 0},
     .reach = 0, .unit = "B",
     .why = "The limit is the state of the bonds, which are kept by segments of eight sites and not one by "
            "one. Bonds between the ranks are held twice: on one rank it is {bytes memory_lattice_bond "
            "54576 1} B."},
    {.what = "memory of the same block in lists, 2 ranks, a directed bond",
     .ours = bench_value_bytes, .of = {"memory_list_bond", "54576", 2, 0},
     .reach = 0, .unit = "B",
     .why = "The limit is the entry of a list: the other end, the bond's vector and its stiffness."},
};
/* clang-format on */
const int bench_targets_count = sizeof bench_targets / sizeof *bench_targets;

enum bench_verdict bench_targets_verdict(const struct bench_page_files *p, const struct bench_target *t,
                                         struct bench_value *ours, double *reach) {
    *ours = t->ours(p, &t->of);
    *reach = t->reach > 0 ? t->reach : bench_value_before(p, &t->of).median;
    if (isnan(ours->median) || isnan(*reach)) return BENCH_NOT_MEASURED;
    const int reached = t->at_least ? ours->median >= *reach : ours->median <= *reach;
    const struct bench_whole *run = t->ours == bench_value_minutes ? bench_page_run(p, t->of.kind) : NULL;
    if (reached && run && run->from > 0) return BENCH_NOT_MEASURED; /* a part of the run only */
    return reached ? BENCH_REACHED : BENCH_NOT_REACHED;
}

static void write_row(FILE *to, const struct bench_page_files *p, int number, const struct bench_target *t) {
    static const char *const said[] = {"reached", "not reached", "not measured"};
    const char *space = *t->unit ? " " : "";
    struct bench_value ours;
    double reach;
    const enum bench_verdict verdict = bench_targets_verdict(p, t, &ours, &reach);
    const struct bench_whole *run = t->ours == bench_value_minutes ? bench_page_run(p, t->of.kind) : NULL;
    fprintf(to, "| %d | ", number);
    bench_sentence_write(to, p, t->what);
    if (run && run->from > 0) fprintf(to, ", from step %ld on", run->from);
    fprintf(to, " | ");
    bench_sentence_write(to, p, t->peer ? t->peer : "–");
    fprintf(to, isnan(reach) ? " | – | " : " | %s %.4g%s%s | ", t->at_least ? "≥" : "≤", reach, space, t->unit);
    if (!isnan(ours.median)) fprintf(to, "%.*g%s%s", isnan(ours.low) ? 4 : 3, ours.median, space, t->unit);
    if (!isnan(ours.low)) fprintf(to, " (%.3g–%.3g)", ours.low, ours.high);
    fprintf(to, " | %s |\n", said[verdict]);
}

void bench_targets_write(FILE *to, const struct bench_page_files *p) {
    int found[3] = {0};
    for (int k = 0; k < bench_targets_count; k++) {
        struct bench_value ours;
        double reach;
        found[bench_targets_verdict(p, &bench_targets[k], &ours, &reach)]++;
    }
    fprintf(to, "**%d of %d reached**", found[BENCH_REACHED], bench_targets_count);
    if (found[BENCH_NOT_MEASURED]) fprintf(to, ", %d not measured", found[BENCH_NOT_MEASURED]);
    fprintf(to, ".\n\n| | what | peer, measured | to reach | ours | |\n|---|---|---|---|---|---|\n");
    for (int k = 0; k < bench_targets_count; k++) write_row(to, p, k + 1, &bench_targets[k]);
    fprintf(to, "\nWhat the limit of each line is, and what keeps the program from there:\n\n");
    for (int k = 0; k < bench_targets_count; k++) {
        fprintf(to, "%d. ", k + 1);
        bench_sentence_write(to, p, bench_targets[k].why);
        fprintf(to, "\n");
    }
    fprintf(to, "\n");
}
