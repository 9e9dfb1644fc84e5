/* Partial ghost refresh near a box: equal to the full one inside, nothing touched beyond its reach. */
#include "tests/fluid/fluid_case.h"
#include "tests/check.h"

#include <stdlib.h>

enum { NX = 12, NY = 14, NZ = 17, STALE = 1000 };

static struct fluid_input scene(int which) {
    struct fluid_input in = {
        .n = {NX, NY, NZ}, .length = {1.2, 1.4, 1.7}, .density = 1.2, .viscosity = 0.01, .immersed = 1};
    for (int d = 0; d < 3; d++) all_sides(&in, d, d == which ? FLUID_WALL : FLUID_PERIODIC);
    if (which == 3) {
        in.side[0][0] = (struct fluid_side){.type = FLUID_INFLOW, .profile = FLUID_POISEUILLE, .bulk_velocity = 0.5};
        in.side[0][1].type = FLUID_OUTFLOW;
        in.side[1][0].type = FLUID_SLIP;
        in.side[1][1] = (struct fluid_side){.type = FLUID_WALL, .velocity = {0.2, 0, 0.1}};
        in.side[2][0] = (struct fluid_side){.type = FLUID_PRESSURE, .pressure = 0.2};
        in.side[2][1].type = FLUID_SLIP;
    }
    return in;
}

static int owned(const struct fluid_grid *g, int i, int j, int k) {
    return i >= 0 && i < g->m[0] && j >= 0 && j < g->m[1] && k >= 0 && k < g->m[2];
}

enum { FIELDS = 4 }; /* u, v, w, p */

static double *field_of(struct fluid *f, int c) {
    const struct fluid_state *s = fluid_state_of(f);
    return c == 0 ? s->u : c == 1 ? s->v : c == 2 ? s->w : s->p;
}

/* Cells of this rank random, ghosts stale. */
static void prepare(struct fluid *f) {
    const struct fluid_grid *g = fluid_grid_of(f);
    const int h = g->halo;
    for (int c = 0; c < FIELDS; c++)
        for (int k = -h; k < g->m[2] + h; k++)
            for (int j = -h; j < g->m[1] + h; j++)
                for (int i = -h; i < g->m[0] + h; i++)
                    field_of(f, c)[fluid_grid_at(g, i, j, k)] =
                        owned(g, i, j, k) ? random_at(i, j + g->lo[1], k + g->lo[2], c) : STALE;
}

static int within(const struct fluid_grid *g, int d, int at, int low, int high) {
    for (int image = g->periodic[d] ? -1 : 0; image <= g->periodic[d]; image++)
        if (at + image * g->n[d] >= low && at + image * g->n[d] < high) return 1;
    return 0;
}

/* Compares with the full refresh inside the box; returns how many ghosts (of four fields) are no longer stale. */
static long near_against_full(struct fluid *f, int layers, const int low[3], const int high[3]) {
    const struct fluid_grid *g = fluid_grid_of(f);
    double *full[FIELDS];
    prepare(f);
    fluid_state_refresh(f);
    for (int c = 0; c < FIELDS; c++) {
        full[c] = malloc(g->size * sizeof(double));
        memcpy(full[c], field_of(f, c), g->size * sizeof(double));
    }
    prepare(f);
    fluid_state_refresh_near(f, layers, low, high);
    long fresh = 0;
    for (int c = 0; c < FIELDS; c++)
        for (int k = -layers; k < g->m[2] + layers; k++)
            for (int j = -layers; j < g->m[1] + layers; j++)
                for (int i = -layers; i < g->m[0] + layers; i++) {
                    const size_t n = fluid_grid_at(g, i, j, k);
                    const double value = field_of(f, c)[n];
                    fresh += !owned(g, i, j, k) && value != STALE;
                    if (within(g, 0, i, low[0], high[0]) && within(g, 1, j + g->lo[1], low[1], high[1]) &&
                        within(g, 2, k + g->lo[2], low[2], high[2]) && value != full[c][n])
                        fail_msg("field %d at %d %d %d: %g, not %g", c, i, j, k, value, full[c][n]);
                }
    for (int c = 0; c < FIELDS; c++) free(full[c]);
    return par_sum_long(fresh);
}

static void near_is_full_inside(void **state) {
    (void)state;
    for (int which = 0; which < 4; which++) {
        const struct fluid_input in = scene(which);
        struct fluid *f = fluid_new(&in);
        for (int trial = 0; trial < (check_skips(1, 1) ? 20 : 60); trial++)
            for (int layers = 1; layers <= 3; layers++) {
                int low[3], high[3];
                for (int d = 0; d < 3; d++) { /* from layers beyond one side to layers beyond the other */
                    const double a = random_at(trial, d, which, 1) + 0.5, b = random_at(trial, d, which, 2) + 0.5;
                    low[d] = -layers + (int)(a * (in.n[d] + layers));
                    high[d] = low[d] + 1 + (int)(b * (in.n[d] + layers - low[d]));
                }
                near_against_full(f, layers, low, high);
            }
        fluid_free(f);
    }
}

/* A box in the middle of one rank needs no exchange; one at a wall does not change the ghosts at other sides. */
static void far_sides_are_skipped(void **state) {
    (void)state;
    const struct fluid_input in = scene(1);
    struct fluid *f = fluid_new(&in);
    int low[3], high[3];
    if (par_rank() == 0)
        for (int d = 0; d < 3; d++) {
            low[d] = fluid_grid_of(f)->m[d] / 2;
            high[d] = low[d] + 1;
        }
    par_bcast(low, sizeof low, 0);
    par_bcast(high, sizeof high, 0);
    if (fluid_grid_of(f)->m[1] > 6 && par_size() < 3) assert_int_equal(near_against_full(f, 2, low, high), 0);
    low[1] = NY - 3;
    high[1] = NY + 2;
    const long fresh = near_against_full(f, 2, low, high);
    check_above(fresh, 0);
    if (par_size() < 3) check_at_most(fresh, FIELDS * 2);
    fluid_free(f);
}

FLUID_TEST_MAIN(cmocka_unit_test(near_is_full_inside), cmocka_unit_test(far_sides_are_skipped))
