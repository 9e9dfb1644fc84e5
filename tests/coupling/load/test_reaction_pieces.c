/* Load by reaction on a body that breaks: momentum, resumed and repeated steps, numbers of ranks. */
#include "coupling/load/reaction.h"
#include "coupling/control/rollback.h"
#include "coupling/run.h"
#include "coupling/run_state.h"
#include "coupling/step.h"
#include "base/files/folder.h"
#include "base/files/state_file.h"
#include "tests/coupling/ball.h"
#include "tests/coupling/inner.h"
#include "tests/coupling/scene_of.h"
#include "solid/bonds/family.h"
#include "tests/check.h"
#include "tests/one_rank.h"

#include <math.h>
#include <stdio.h>

enum { SITES = 16 * 16 * 16, FIELDS = 10, ALL = FIELDS * SITES };
static const double CELL = 0.01;

static const char *const tears = "coupling: {load: reaction}\n"
                                 "stages:\n"
                                 "  - {name: tear, steps: 100, time_step: 1.0e-3, integrator: verlet}\n";

static struct run *begin(struct scene **scene, const char *density, const char *integrator) {
    char set[2][64];
    snprintf(set[0], sizeof set[0], "solid.materials.soft.density=%s", density);
    snprintf(set[1], sizeof set[1], "stages.tear.integrator=%s", integrator);
    *scene = scene_of(BALL_IN_A_BOX("3000"), tears, 2, (const char *const[]){set[0], set[1]});
    return run_new(*scene);
}

/* The ball is torn along z. */
static void tear(struct run *r) {
    static const double most[3] = {3, -1, 2};
    for (int c = 0; c < 3; c++)
        for (int h = 0; h < r->solid->n; h++) r->solid->v[c][h] = most[c] * (r->solid->x0[2][h] - 0.08) / 0.04;
    step_begin_stage(r);
}

static void end(struct run *r, struct scene *scene) {
    run_free(r);
    scene_free(scene);
}

static void steps(struct run *r, int n) {
    for (int k = 0; k < n; k++) step_advance(r);
}

static long broken(struct run *r) {
    solid_family_count(r->solid);
    return r->solid->bonds_broken;
}

/* Momentum of fluid and solid less the impulse that the inner fluid has given back: by how much it changes at most,
 * over the impulse that they have exchanged. */
static double momentum_lost(const char *density, const char *integrator) {
    struct scene *scene;
    struct run *r = begin(&scene, density, integrator);
    const size_t capacity = (size_t)r->solid->n + 1;
    struct inner *records = calloc(capacity, sizeof *records);
    double start[3] = {0}, inner[3] = {0}, gained = 0, most = 0;
    char *is_free = calloc(capacity, 1);
    const double mass = atof(density);
    tear(r);
    for (int n = 0; n <= 30; n++) {
        double sum[6] = {0}, fluid[3];
        inner_note(r, records);
        for (int h = 0; h < r->solid->n; h++) {
            for (int c = 0; c < 3; c++) sum[c] += mass * r->solid->volume[h] * r->solid->v[c][h];
            is_free[h] = 0;
        }
        for (int i = 0; i < r->surface->n; i++) is_free[r->surface->h[i]] = r->surface->two_sided[i] == SOLID_ISOLATED;
        for (int c = 0; c < 3; c++) sum[3 + c] = inner[c];
        par_sum_array(sum, 6);
        fluid_measures_momentum(r->fluid, fluid, NULL);
        for (int c = 0; c < 3; c++) {
            const double total = fluid[c] + sum[c] - sum[3 + c];
            if (n == 0) start[c] = total;
            most = check_worst(most, total - start[c]);
        }
        step_advance(r);
        for (int c = 0; c < 3; c++) gained += fabs(r->load[c]) * r->dt;
        for (int h = 0; h < r->solid->n; h++)
            for (int c = 0; c < 3; c++) {
                const double given = inner_given(r, &records[h], h, c, 3, n == 0);
                if (!is_free[h]) inner[c] += 1000 * r->solid->volume[h] * given; /* free ones carry no fluid */
            }
    }
    long isolated = 0;
    for (int i = 0; i < r->surface->n; i++) isolated += r->surface->two_sided[i] == SOLID_ISOLATED;
    isolated = par_sum_long(isolated);
    print_message("density %s, %s: %ld bonds broken, %ld particles free, momentum lost %.3g of %.3g N s\n", density,
                  integrator, broken(r), isolated, most, gained);
    check_above(broken(r), 1000);
    check_above(isolated, 0);
    check_above(gained, 0.01);
    free(records);
    free(is_free);
    end(r, scene);
    return most / gained;
}

static void momentum_is_kept(void **state) {
    (void)state;
    check_below(momentum_lost("3000", "verlet"), 1e-12);
    check_below(momentum_lost("500", "verlet"), 1e-12);
    check_below(momentum_lost("3000", "rk3"), 1e-12);
}

/* By place: the fluid's velocity and pressure, and d, v of the particle that began there. The same on all ranks. */
static void collect(struct run *r, double *all) {
    const struct fluid_grid *g = fluid_grid_of(r->fluid);
    const struct fluid_state *q = fluid_state_of(r->fluid);
    const double *const field[4] = {q->u, q->v, q->w, q->p};
    memset(all, 0, ALL * sizeof *all);
    for (int k = 0; k < g->m[2]; k++)
        for (int j = 0; j < g->m[1]; j++)
            for (int i = 0; i < g->m[0]; i++)
                for (int f = 0; f < 4; f++)
                    all[FIELDS * (((k + g->lo[2]) * 16 + j + g->lo[1]) * 16 + i) + f] =
                        field[f][fluid_grid_at(g, i, j, k)] / (f < 3 ? 1 : 1000);
    for (int h = 0; h < r->solid->n; h++) {
        int at[3];
        for (int c = 0; c < 3; c++) at[c] = (int)floor(r->solid->x0[c][h] / CELL);
        double *here = all + FIELDS * ((at[2] * 16 + at[1]) * 16 + at[0]);
        for (int c = 0; c < 3; c++) {
            here[4 + c] = r->solid->d[c][h] / CELL;
            here[7 + c] = r->solid->v[c][h];
        }
    }
    par_sum_array(all, ALL);
}

static double all[ALL], again[ALL];

static double difference(void) {
    double worst = 0;
    for (int i = 0; i < ALL; i++) worst = check_worst(worst, all[i] - again[i]);
    return worst;
}

/* A run goes on from the state kept in memory as if it had not stopped, to the bit, and from a checkpoint to round-off:
 * markers are sorted again, so sums over them are made in another order. */
static void resumed_is_the_same(void **state) {
    (void)state;
    char folder[FOLDER_PATH], why[256];
    int head;
    struct run_state list;
    struct scene *scene;
    struct run *r = begin(&scene, "3000", "verlet"), *other = run_new(scene);
    snprintf(folder, sizeof folder, "%s/tests/coupling/reaction_pieces_%d", FRANA_BINARY_DIR, par_size());
    folder_make(folder);
    folder_clear(folder);
    tear(r);
    steps(r, 8);
    check_above(broken(r), 100);
    run_state_of(r, &list);
    struct store *s = store_begin(folder, "state", 0);
    state_file_write(s, &list.list);
    store_end(s);
    struct rollback *start = rollback_new(r);
    rollback_save(start, r);
    steps(r, 8);
    collect(r, all);
    rollback_restore(start, r);
    steps(r, 8);
    collect(r, again);
    const double repeated = difference();
    s = store_read_open_latest(folder);
    assert_non_null(s);
    run_state_of(other, &list);
    if (state_file_read(s, &list.list, &head, why, sizeof why)) fail_msg("%s %s", why, store_read_error());
    store_read_close(s);
    fluid_state_refresh(other->fluid);
    step_begin_stage(other);
    steps(other, 8);
    collect(other, again);
    print_message("repeated: %g; resumed: %g\n", repeated, difference());
    assert_true(repeated == 0);
    check_below(difference(), 1e-10);
    rollback_free(start);
    run_free(other);
    end(r, scene);
}

/* One rank writes its results to a file, more ranks compare with it. */
static void ranks_agree(void **state) {
    (void)state;
    struct scene *scene;
    struct run *r = begin(&scene, "3000", "verlet");
    tear(r);
    steps(r, 12);
    check_above(broken(r), 100);
    collect(r, all);
    one_rank_expects("coupling_load_test_reaction_pieces", all, sizeof all, again);
    print_message("%d ranks against 1: %.3g\n", par_size(), difference());
    check_below(difference(), 1e-10);
    end(r, scene);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(momentum_is_kept), cmocka_unit_test(resumed_is_the_same),
                                       cmocka_unit_test(ranks_agree)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
