/* Measures the search for particles to refine and single refinements of a plate. */
#include "base/ensure.h"
#include "base/memory.h"
#include "base/par.h"
#include "base/sort.h"
#include "program/bench/parts.h"
#include "solid/refine/refine.h"
#include "solid/solid.h"

#include <math.h>

enum { EVENTS = 15, APART = 15 };
static const double SPACING = 1e-3; /* m */

static struct solid *square_new(int sites, const struct solid_refinement *refinement) {
    const double side = sites * SPACING, corner[4][2] = {{0, 0}, {side, 0}, {side, side}, {0, side}},
                 none[4][2] = {{0}};
    static const signed char straight[4] = {0};
    const struct solid_outline outline = {0, 4, corner, none, straight};
    const struct solid_material material = {72e9, 2440, 135, 3, PHYSICS_CONSTANT, 0, 0};
    return bench_sweep_plate(1, &outline, &material, refinement);
}

/* The search for particles to refine, in a state where no particle exceeds the threshold. */
static void search(void *with) { solid_refine_criteria(with); }

/* Marks the k-th of the particles to be refined, with its family; five in a row of the plate. */
static void mark_one(const struct solid *s, int k, uint8_t *mark) {
    const double at[2] = {5 + k % 5 * APART, 5 + k / 5 * APART};
    for (int h = 0; h < s->n; h++) {
        mark[h] = 1;
        for (int c = 0; c < 2; c++) mark[h] &= fabs(s->x0[c][h] / SPACING - 0.5 - at[c]) < 0.1;
    }
}

/* Duration of one refinement on the slowest rank, s. */
static double event(struct solid *s, int k) {
    uint8_t *mark = memory_new(MEMORY_SOLID, (size_t)s->n + 1, 1);
    mark_one(s, k, mark);
    par_barrier();
    const double before = par_seconds();
    const long refined = solid_refine_marked(s, mark);
    const double seconds = par_max(par_seconds() - before);
    ENSURE(refined > 20, "%ld particles refined", refined);
    memory_free(mark);
    return seconds;
}

void bench_refine(struct bench *bench) {
    const struct solid_refinement refinement = {.levels = 1, .energy = 1e9, .low = {-1, -1}, .high = {1, 1}};
    struct solid *s = square_new(bench->quick ? 80 : 130, &refinement);
    double seconds[EVENTS];
    struct bench_row row = bench_sweep_row("sweep_refined", s, bench_measure_one(&bench->repetition, bench_sweep, s));
    bench_row_write(&bench->table, &row);
    row = bench_sweep_row("refine_look", s, bench_measure_one(&bench->repetition, search, s));
    bench_row_write(&bench->table, &row);
    for (int k = 0; k < EVENTS; k++) seconds[k] = event(s, k);
    const double median = sort_median(seconds, EVENTS);
    row = bench_sweep_row("refine_event", s, (struct bench_sample){1, EVENTS, median, seconds[0], seconds[EVENTS - 1]});
    bench_row_write(&bench->table, &row);
    solid_free(s);
}
