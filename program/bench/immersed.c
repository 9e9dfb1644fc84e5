/* Measures the parts of a coupled step and whole steps of the porous block, intact and broken. */
#include "base/par.h"
#include "program/bench/parts.h"
#include "program/bench/scene.h"
#include "coupling/interface/interface.h"
#include "coupling/run.h"
#include "coupling/step.h"
#include "solid/bonds/family.h"
#include "solid/contact/contact.h"
#include "solid/step/integrate.h"

#include <math.h>

enum {
    CUBE = 14
}; /* edge of the pieces of a broken block, in spacings; about a quarter of its bonds are broken, as in
    * a crushed one */

static struct run *run_of(const struct bench_scene *what) {
    struct run *r = run_new(bench_scene_new(what));
    step_begin_stage(r);
    while (r->stage_step < r->scene->stage[0].steps) step_advance(r);
    r->stage = 1;
    r->stage_step = 0;
    step_begin_stage(r);
    return r;
}

static void end(struct run *r) {
    struct scene *scene = (struct scene *)(size_t)r->scene;
    run_free(r);
    scene_free(scene);
}

/* The cube of pieces that contains a particle's initial position, as indices along the directions. */
static void cube_of(const struct solid *s, int h, long cube[3]) {
    for (int c = 0; c < 3; c++) cube[c] = lrint(floor(s->x0[c][h] / (CUBE * s->in.spacing)));
}

/* Breaks every bond between two such cubes. */
static void break_up(struct solid *s) {
    static struct solid_family_view view;
    for (int h = 0; h < s->n; h++) {
        long here[3], there[3];
        solid_family_view(s, h, &view);
        cube_of(s, h, here);
        for (int b = 0; b < view.n; b++) {
            cube_of(s, view.l[b], there);
            const int one = here[0] == there[0] && here[1] == there[1] && here[2] == there[2];
            if (!one && view.intact[b]) solid_family_break(s, h, b);
        }
    }
}

static void coupled_step(void *with) { step_advance(with); }

/* Sets the markers after all of them have moved a little, alternately there and back. */
static void markers(void *with) {
    struct run *r = with;
    struct markers *m = &r->markers;
    static double shift = 1e-9;
    shift = -shift;
    interface_update(r);
    for (int i = 0; i < m->n; i++) m->x[0][i] += shift * r->solid->in.spacing;
    ibm_markers_set(r->ibm, m->n, (const double *const *)m->x, (const double *const *)m->v, m->volume);
}

/* The forcing of the three stages of a step. */
static void forcing(void *with) {
    struct run *r = with;
    for (int s = 0; s < 3; s++) ibm_forcing_stage(r->ibm, s, r->dt);
}

static void probe(void *with) { load_sample(with); }

static void interface(void *with) {
    struct run *r = with;
    solid_surface_update(r->solid, r->surface);
}

/* A step of the solid alone as in a run: contact's lists, then all substeps. */
static void touching_step(void *with) {
    struct run *r = with;
    solid_contact_update(r->solid);
    solid_integrate(r->solid, r->dt / r->substeps, r->substeps);
}

static void solid(void *with) {
    struct run *r = with;
    solid_integrate(r->solid, r->dt / r->substeps, r->substeps);
}

static void row_of(struct bench *bench, const struct run *r, const char *part, struct bench_sample time, double units,
                   const char *unit, double bytes, double flops) {
    bench_row_write_cells(
        &bench->table, fluid_grid_of(r->fluid)->n,
        (struct bench_row){.part = part, .time = time, .units = units, .unit = unit, .bytes = bytes, .flops = flops});
}

static void measure(struct bench *bench, const char *part, bench_call *call, struct run *r, double units,
                    const char *unit, double bytes, double flops) {
    row_of(bench, r, part, bench_measure_one(&bench->repetition, call, r), units, unit, bytes, flops);
}

/* Contact's part of such steps, for one substep: the particles move on from step to step, as they do in a run. */
static void contact(struct bench *bench, const char *part, struct run *r) {
    struct bench_sample sample[1][BENCH_CHANNELS];
    bench_measure(&bench->repetition, touching_step, 1, (void *[]){r}, sample);
    struct bench_sample time = sample[0][BENCH_CLOCK + CLOCK_CONTACT];
    time.median /= r->substeps;
    time.low /= r->substeps;
    time.high /= r->substeps;
    row_of(bench, r, part, time, (double)r->solid->n_global, "particle", 0, 0);
}

/* A marker, a stage and an iteration: 27 points of three components, summed and added to, factor by factor: 39
 * multiply-adds each, 2 x 3 x 39 = 234, and the weights of six directions and alignments twice, 2 x 6 x 11 flops: 600
 * flops. Its cache line twice, 128 B; its increment out and in, and added to the force received, 96 B. The fields'
 * blocks overlap and stay in the cache: u* in and out once for a marker and component, 48 B. A probe: p and three
 * components on 4 x 4 x 4 points, 256 multiply-adds, and the differences at 8 points: about 800 flops; its position,
 * normal and result are 11 doubles, the fields' values 32 B. */
static const double forcing_bytes = 6 * (128 + 96 + 48), forcing_flops = 6 * 600;
/* With feedback a stage writes twice and reads once, three quarters of the work of two iterations. */
static const double feedback_bytes = 0.75 * 6 * (128 + 96 + 48), feedback_flops = 0.75 * 6 * 600;
static const double probe_bytes = 11 * 8 + 32, probe_flops = 800;

enum { RUNS = 6 };

/* Takes steps of the runs in turn: an intact block whose bonds may not break; one whose bonds may break; the same by
 * RK3; a broken block; the intact block with the load by reaction, and the same with the fluid by AB2. */
static void steps(struct bench *bench, struct run *const run[RUNS]) {
    static const char *const name[RUNS] = {"coupled_step",        "coupled_step_breakage", "coupled_step_rk3",
                                           "coupled_step_broken", "coupled_step_reaction", "coupled_step_ab2"};
    struct bench_sample sample[RUNS][BENCH_CHANNELS];
    bench_measure(&bench->repetition, coupled_step, RUNS, (void *const *)run, sample);
    for (int k = 0; k < RUNS; k++)
        row_of(bench, run[k], name[k], sample[k][BENCH_WALL], (double)fluid_cells(run[k]->fluid), "cell-step", 0, 0);
    for (int k = 1; k < RUNS && bench->observe; k += 3) { /* the blocks whose bonds may break, and by reaction */
        double part[CLOCK_ALL];
        for (int c = 0; c < CLOCK_ALL; c++) part[c] = sample[k][BENCH_CLOCK + c].median;
        bench->observe(run[k], sample[k][BENCH_WALL].median, part);
    }
    if (par_rank() == 0)
        printf("%-26s %-12s intact block, breakage on over off: %.4f (%d and %d substeps)\n", "", "",
               sample[1][BENCH_WALL].median / sample[0][BENCH_WALL].median, run[1]->substeps, run[0]->substeps);
    if (par_rank() == 0)
        printf("%-26s %-12s intact block, load by reaction over by probe: %.4f (%d and %d substeps)\n", "", "",
               sample[4][BENCH_WALL].median / sample[0][BENCH_WALL].median, run[4]->substeps, run[0]->substeps);
    if (par_rank() == 0)
        printf("%-26s %-12s intact block, load by reaction, fluid by AB2 over RK3: %.4f (%d and %d substeps)\n", "", "",
               sample[5][BENCH_WALL].median / sample[4][BENCH_WALL].median, run[5]->substeps, run[4]->substeps);
    for (int k = 0; k < 4; k += 3) {
        char size[32];
        const int *n = fluid_grid_of(run[k]->fluid)->n;
        snprintf(size, sizeof size, "%dx%dx%d", n[0], n[1], n[2]);
        bench_row_traffic(&bench->table, name[k], size, coupled_step, run[k], 2);
    }
}

void bench_immersed(struct bench *bench) {
    struct run *run[RUNS];
    for (int k = 0; k < RUNS; k++)
        run[k] = run_of(&(struct bench_scene){
            .half = bench->quick, .breakage = k == 1 || k == 3, .rk3 = k == 2, .reaction = k >= 4, .ab2 = k == 5});
    break_up(run[3]->solid);
    for (int k = 0; k < 3; k++) step_advance(run[3]); /* so that contact has its lists and the interface is set up */
    steps(bench, run);
    struct run *intact = run[0], *broken = run[3];
    const double n = (double)intact->surface->total, m = (double)broken->surface->total;
    const double probes = par_sum(intact->probes.n);
    measure(bench, "markers", markers, intact, n, "marker", 0, 0);
    measure(bench, "forcing", forcing, intact, n, "marker", forcing_bytes, forcing_flops);
    measure(bench, "forcing_feedback", forcing, run[4], n, "marker", feedback_bytes, feedback_flops);
    measure(bench, "probe", probe, intact, probes, "probe", probe_bytes, probe_flops);
    measure(bench, "interface", interface, intact, n, "marker", 0, 0);
    measure(bench, "interface_broken", interface, broken, m, "marker", 0, 0);
    contact(bench, "contact", run[1]);
    contact(bench, "contact_broken", broken);
    measure(bench, "solid_substeps", solid, intact,
            (double)par_sum_long(solid_family_directed(intact->solid)) * intact->substeps, "directed bond", 0, 0);
    for (int k = 0; k < RUNS; k++) end(run[k]);
}
