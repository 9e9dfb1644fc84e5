/* Times the parts of forcing and probe in a scene whose particles all move. */
/* Time of the forcing and the probe by part, in the steps of a scene whose particles all move:
 *     bench_forcing SCENE.yaml [stage, from 0]
 * Medians of the slowest rank, and in brackets of the fastest, ms: the difference is the load imbalance. */
#include "base/die.h"
#include "base/par.h"
#include "coupling/interface/interface.h"
#include "coupling/run.h"
#include "coupling/step.h"
#include "ibm/state.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { REPEATS = 31, PARTS_MAX = 24 };
static double seconds[PARTS_MAX][REPEATS];
static const char *name[PARTS_MAX];
static int parts, repeat;

#define TIME(what, ...)                                                                                                \
    do {                                                                                                               \
        par_barrier();                                                                                                 \
        const double begun = par_seconds();                                                                            \
        __VA_ARGS__;                                                                                                   \
        seconds[parts][repeat] = par_seconds() - begun;                                                                \
        name[parts++] = what;                                                                                          \
    } while (0)

static int rising(const void *a, const void *b) {
    const double *p = a, *q = b;
    return (*p > *q) - (*p < *q);
}

/* Vibrations far below a cell: no marker changes its cell, all change their weights. */
static void shake(struct solid *s, int n) {
    for (int c = 0; c < 3; c++)
        for (int h = 0; h < s->n; h++) {
            s->d[c][h] += 1e-9 * sin(h + c + n);
            s->v[c][h] = 1e-3 * sin(0.1 * h + c + n);
        }
}

static void forced_stages(struct run *r) {
    static const char *const stage_name[3] = {"force, stage 1", "force, stage 2", "force, stage 3"};
    for (int k = 0; k < 3; k++) {
        fluid_predict(r->fluid, k, r->dt);
        TIME(stage_name[k], ibm_forcing_stage(r->ibm, k, r->dt));
        fluid_project(r->fluid, k, r->dt);
    }
}

/* The parts of an iteration separately, with caches as the one before has left them. */
static void iteration(struct run *r) {
    struct ibm *b = r->ibm;
    double *const *u = fluid_predicted(r->fluid);
    struct ibm_tally t = {.squares = 0};
    TIME("  read inner", ibm_sweep_gather(b, u, 0, b->inner, IBM_EVALUATE, &t));
    TIME("  read inner again", ibm_sweep_gather(b, u, 0, b->inner, IBM_EVALUATE, &t));
    TIME("  read edges", ibm_edge_sum(b, u, 0, b->pieces));
    TIME("  share sums", ibm_share_sums(b));
    ibm_edge_finish(b, 0, b->edges, IBM_EVALUATE, &t);
    for (int h = 0; h < b->served; h++)
        for (int c = 0; c < 3; c++) b->increment[h][c] *= 1e-9;
    TIME("  write inner", ibm_sweep_scatter(b, u, 0, b->inner));
    TIME("  write inner again", ibm_sweep_scatter(b, u, 0, b->inner));
    TIME("  write edges", ibm_edge_scatter(b, u, 0, b->pieces));
}

static void step(struct run *r) {
    const struct markers *m = &r->markers;
    const struct wall_probes *p = &r->probes;
    parts = 0;
    shake(r->solid, repeat);
    TIME("markers, coupling", interface_update(r));
    TIME("markers, weights",
         ibm_markers_set(r->ibm, m->n, (const double *const *)m->x, (const double *const *)m->v, m->volume));
    forced_stages(r);
    TIME("state refresh, whole", fluid_state_refresh(r->fluid));
    const struct ibm_probe_input in = {.n = p->n,
                                       .x = {p->root[0], p->root[1], p->root[2]},
                                       .normal = {p->normal[0], p->normal[1], p->normal[2]},
                                       .length = r->scene->coupling->probe_length};
    TIME("refresh and probe", ibm_probe(r->ibm, &in, p->traction, p->pressure, p->active));
    TIME("the same, and loads", load_sample(r));
    iteration(r);
    TIME("layout", ibm_layout(r->ibm));
    shake(r->solid, repeat + 1); /* weights of a fresh layout */
    interface_update(r);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    if (argc < 2) die_all(EXIT_CODE_SCENE, "bench_forcing: which scene?");
    struct scene *scene = scene_new(argv[1], 0, NULL);
    struct run *r = run_new(scene);
    r->stage = argc > 2 ? atoi(argv[2]) : scene->stages - 1;
    step_begin_stage(r);
    for (repeat = 0; repeat < REPEATS; repeat++) step(r);
    const struct ibm *b = r->ibm;
    for (int rank = 0; rank < par_size(); rank++) {
        if (rank == par_rank())
            printf("rank %d: %d markers, serves %d inner and %d edges of %d pieces, %d sums swapped\n", rank,
                   r->markers.n, b->inner, b->edges, b->pieces, b->swapped);
        fflush(stdout);
        par_barrier();
    }
    for (int p = 0; p < parts; p++) {
        qsort(seconds[p], REPEATS, sizeof(double), rising);
        const double median = seconds[p][REPEATS / 2];
        const double slow = par_max(median), fast = par_min(median), best = par_max(seconds[p][0]);
        if (par_rank() == 0) printf("%-24s %8.3f  (%.3f, best %.3f) ms\n", name[p], 1e3 * slow, 1e3 * fast, 1e3 * best);
    }
    run_free(r);
    scene_free(scene);
    par_end();
    return 0;
}
