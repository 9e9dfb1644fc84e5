/* Wall seconds of the work besides the step: checks, rollback, the parts of a sample, fields, checkpoints.
 * usage: [mpiexec -n N] bench_output SCENE.yaml CHECKPOINT.h5 FOLDER [--set-like overrides]...
 * FOLDER must have the subfolders checkpoint/ and fields/; with BENCH_ONLY=NAME only that part is run. Best and median
 * of the repeats, the slowest rank's. */
#include "coupling/interface/deposit.h"
#include "base/die.h"
#include "base/par.h"
#include "base/signals.h"
#include "base/step_status.h"
#include "coupling/control/rollback.h"
#include "coupling/step.h"
#include "program/output/checkpoint.h"
#include "program/output/outputs.h"
#include "solid/bonds/family.h"
#include "solid/measure/damage.h"
#include "solid/measure/energy.h"
#include "solid/measure/fragments.h"
#include "solid/measure/stress.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { REPEATS = 15 };

struct bench {
    struct run *run;
    void *series, *files; /* of output_series, output_fields */
    struct outputs_found found;
    struct rollback *rollback;
    const char *folder;
    double *work;
    double (*tensor)[6];
};

static void check(struct bench *b) {
    struct step_status status;
    step_check(b->run, 1, &status);
}
static void glance(struct bench *b) {
    struct step_status status;
    step_check(b->run, 0, &status);
}
static void stop(struct bench *b) {
    (void)b;
    signals_stop(0);
}
static void surface(struct bench *b) { solid_surface_update(b->run->solid, b->run->surface); }
static void step(struct bench *b) { step_advance(b->run); }
static void save(struct bench *b) { rollback_save(b->rollback, b->run); }
static void restore(struct bench *b) { rollback_restore(b->rollback, b->run); }
/* Samples an output as at the end of a stage. */
static void write(struct bench *b, const struct output *output, void *self) {
    const struct outputs_moment m = {b->run->step, 1, 1, 1, 0, &b->found};
    output->sample(self, b->run, &m);
}
static void fields(struct bench *b) { write(b, &output_fields, b->files); }
static void checkpoint(struct bench *b) { checkpoint_write(b->run, b->folder); }
static void prepare(struct bench *b) { output_series.prepare(b->series, b->run); }
static void sample(struct bench *b) {
    b->run->moved = ++b->run->step; /* as if the solid had moved */
    write(b, &output_series, b->series);
}
static void energy(struct bench *b) { solid_energy_measure(b->run->solid); }
static void count(struct bench *b) { solid_family_count(b->run->solid); }
static void damage(struct bench *b) { solid_damage_measure(b->run->solid, b->work); }
static void fragments(struct bench *b) { solid_fragments_measure(b->run->solid, NULL, NULL); }
static void stress(struct bench *b) { solid_stress_measure(b->run->solid, b->tensor); }
static void strain(struct bench *b) { solid_stress_strain(b->run->solid, b->tensor); }
static void deposit(struct bench *b) {
    b->run->deposited = -1;
    deposit_update(b->run);
}
static void medium(struct bench *b) { medium_measure(b->run->medium, b->run->fluid, b->run->surface->immersed_area); }
static void effective(struct bench *b) { medium_connect_porosity(b->run->medium); }
static void flow(struct bench *b) { fluid_measures_of(b->run->fluid); }

static const struct {
    const char *name;
    void (*run)(struct bench *b);
    int a_step_on; /* 1: after a step, which is not timed */
} all[] = {
    {"step_check", check, 0},
    {"step_check, a plane", glance, 0},
    {"signals_stop", stop, 0},
    {"rollback_save", save, 1},
    {"rollback_restore", restore, 1},
    {"step", step, 0},
    {"surface update", surface, 0},
    {"series_prepare", prepare, 0},
    {"series_sample", sample, 0},
    {"  flow", flow, 0},
    {"  deposit", deposit, 0},
    {"  medium", medium, 0},
    {"    effective", effective, 0},
    {"  energy", energy, 0},
    {"  count bonds", count, 0},
    {"  damage", damage, 0},
    {"  fragments", fragments, 0},
    {"stress", stress, 0},
    {"strain", strain, 0},
    {"fields_write", fields, 0},
    {"checkpoint_write", checkpoint, 0},
};

static int rising(const void *a, const void *b) {
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    if (argc < 4) die_all(EXIT_CODE_SCENE, "bench_output: SCENE.yaml CHECKPOINT.h5 FOLDER");
    struct scene *scene = scene_new(argv[1], argc - 4, (const char *const *)(argv + 4));
    struct bench b = {.run = run_new(scene), .folder = argv[3]};
    checkpoint_read(b.run, argv[3], argv[2]);
    step_begin_stage(b.run);
    step_advance(b.run);    /* markers, probes, ghosts */
    b.found.fragments = -1; /* measured by the series */
    b.series = calloc(1, output_series.bytes);
    b.files = calloc(1, output_fields.bytes);
    output_series.begin(b.series, b.run);
    output_fields.begin(b.files, b.run);
    output_series.open(b.series, b.run, b.folder, -1);
    output_fields.open(b.files, b.run, b.folder, -1);
    b.rollback = rollback_new(b.run);
    rollback_save(b.rollback, b.run);
    b.work = calloc((size_t)b.run->solid->n + 1, sizeof *b.work);
    b.tensor = calloc((size_t)b.run->solid->n + 1, sizeof *b.tensor);
    const char *only = getenv("BENCH_ONLY");
    if (par_rank() == 0) printf("# %-18s %10s %10s ms\n", "part", "best", "median");
    for (size_t k = 0; k < sizeof all / sizeof *all; k++) {
        double seconds[REPEATS];
        if (only && strcmp(only, all[k].name) != 0) continue;
        for (int i = 0; i < REPEATS; i++) {
            if (all[k].a_step_on) step_advance(b.run);
            par_barrier();
            const double start = par_seconds();
            all[k].run(&b);
            seconds[i] = par_max(par_seconds() - start);
        }
        qsort(seconds, REPEATS, sizeof *seconds, rising);
        if (par_rank() == 0) printf("%-20s %10.3f %10.3f\n", all[k].name, 1e3 * seconds[0], 1e3 * seconds[REPEATS / 2]);
    }
    free(b.tensor);
    free(b.work);
    rollback_free(b.rollback);
    free(b.series);
    free(b.files);
    run_free(b.run);
    scene_free(scene);
    par_end();
    return 0;
}
