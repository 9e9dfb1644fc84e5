/* Forcing with feedback: the slip's law, the step's length, the two ways through a stage, energy, momentum. */
#include "base/threads.h"
#include "fluid/scheme.h"
#include "ibm/feedback.h"
#include "physics/retraction.h"
#include "tests/check.h"
#include "tests/ibm/flows.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>

enum { CELLS = 16 };

static struct body sphere(void) {
    const struct array_case c = {.n = CELLS, .solid_fraction = 0.125, .even = 1, .retraction = PHYSICS_RETRACTION};
    return array_body(&c);
}

static double limit(void) { return 1.65 / CELLS / CELLS / 12; }

static struct fluid *box(double speed, double viscosity, int driven) {
    struct fluid_input in = {.density = 1, .viscosity = viscosity, .immersed = 1, .keeps_rate = 1};
    for (int d = 0; d < 3; d++) in.n[d] = CELLS, in.length[d] = 1;
    if (driven) in.driving = (struct fluid_driving){FLUID_DRIVING_BULK, 0, speed};
    in.initial_velocity[0] = speed;
    return fluid_new(&in);
}

static void take_step(struct fluid *f, struct ibm *ibm, double dt) {
    for (int r = 0; r < fluid_scheme_stages(f); r++) {
        fluid_predict(f, r, dt);
        ibm_feedback_begin(ibm, r, dt);
        ibm_feedback_end(ibm, r, dt);
        fluid_project(f, r, dt);
    }
}

/* The steady drag on an array of spheres, at a fraction of RK3's viscous limit and with a slip time, both over the
 * limit. */
static double drag(enum fluid_integrator integrator, double fraction, double slip_time) {
    struct fluid *f = box(1e-3, 1, 1);
    struct body body = sphere();
    struct ibm *ibm = ibm_new(f, 1);
    const double dt = fraction * limit();
    double force[3];
    fluid_scheme_set(f, integrator);
    ibm_feedback_set(ibm, slip_time * limit());
    body_send(ibm, &body);
    for (long step = 0; step < lrint(0.06 / dt); step++) take_step(f, ibm, dt);
    ibm_forcing_total(ibm, force);
    body_free(&body);
    ibm_free(ibm);
    fluid_free(f);
    return -force[0];
}

/* Whatever the step and the scheme are, the wall is in the same place, as long as the slip time is shorter than a
 * stage. */
static void test_step(void **state) {
    (void)state;
    const double slip_time[] = {0.01, 0.03};
    for (int i = 0; i < 2; i++) {
        if (check_skips(i, 2)) continue;
        const double s = slip_time[i],
                     at[5] = {drag(FLUID_RK3, 1, s), drag(FLUID_RK3, 0.25, s), drag(FLUID_RK3, 0.0625, s),
                              drag(FLUID_AB2, 0.4, s), drag(FLUID_AB2, 0.1, s)};
        print_message("slip time %g: drag %.6g, %.6g, %.6g at 1, 1/4, 1/16 of the limit; AB2: %.6g, %.6g at 0.4, 0.1\n",
                      s, at[0], at[1], at[2], at[3], at[4]);
        for (int k = 1; k < 5; k++) check_relative(at[k], at[0], 1e-3);
    }
}

/* In a steady flow along a sheet of markers, all with the same force F per mass, the mean slip of a step is s F. */
static void slip_by(enum fluid_integrator integrator) {
    const double dt = 0.04, s = 4e-4, push = 0.7;
    struct fluid_input in = {
        .n = {4, 8, 8}, .length = {4, 8, 8}, .density = 1, .viscosity = 1, .immersed = 1, .keeps_rate = 1};
    in.driving = (struct fluid_driving){FLUID_DRIVING_GRADIENT, 0, push};
    struct fluid *f = fluid_new(&in);
    struct ibm *ibm = ibm_new(f, 1);
    struct body body = body_new(32);
    double slip = 0, total[3];
    double(*out)[3] = calloc(33, sizeof *out);
    for (int k = 0; k < 32; k++) body_add(&body, (double[3]){k % 4 + 0.5, 4.5, k / 4 + 0.5}, (double[3]){0, 1, 0});
    body_finish(&body, 32, 1);
    fluid_scheme_set(f, integrator);
    ibm_feedback_set(ibm, s);
    body_send(ibm, &body);
    for (int step = 0; step < 2600; step++)
        for (int r = 0; r < fluid_scheme_stages(f); r++) {
            fluid_predict(f, r, dt);
            ibm_feedback_begin(ibm, r, dt);
            if (step == 2599) {
                ibm_feedback_velocity(ibm, out);
                slip -= fluid_scheme_gamma(f, r) * out[0][0];
            }
            ibm_feedback_end(ibm, r, dt);
            fluid_project(f, r, dt);
        }
    ibm_forcing_total(ibm, total);
    check_relative(total[0], -push * 4 * 8 * 8, 1e-6);
    if (body.n > 0) check_relative(slip, s * total[0] / 32, 1e-6);
    free(out);
    body_free(&body);
    ibm_free(ibm);
    fluid_free(f);
}

static void test_slip(void **state) {
    (void)state;
    slip_by(FLUID_RK3);
    slip_by(FLUID_AB2);
}

/* With the slips sent back by the caller a stage is the same, to the bit. */
static void test_two_ways(void **state) {
    (void)state;
    struct fluid *f[2];
    struct ibm *ibm[2];
    struct body body = sphere();
    double total[2][3];
    double(*out)[3] = calloc((size_t)body.n + 1, sizeof *out);
    double(*slip)[3] = calloc((size_t)body.n + 1, sizeof *slip);
    for (int i = 0; i < body.n; i++) body.v[1][i] = 1e-3 * sin(7 * i);
    for (int k = 0; k < 2; k++) {
        f[k] = box(1e-3, 1, 0);
        ibm[k] = ibm_new(f[k], 1);
        ibm_feedback_set(ibm[k], 0.02 * limit());
        body_send(ibm[k], &body);
    }
    for (int step = 0; step < 4; step++)
        for (int r = 0; r < 3; r++) {
            for (int k = 0; k < 2; k++) {
                fluid_predict(f[k], r, limit());
                ibm_feedback_begin(ibm[k], r, limit());
            }
            ibm_feedback_end(ibm[0], r, limit());
            ibm_feedback_velocity(ibm[1], out);
            for (int i = 0; i < body.n; i++)
                for (int c = 0; c < 3; c++) {
                    assert_true(ibm_feedback_is_in_domain(ibm[1], i));
                    slip[i][c] = body.v[c][i] - out[i][c];
                }
            ibm_feedback_apply_slip(ibm[1], r, limit(), (const double(*)[3])slip);
            for (int k = 0; k < 2; k++) fluid_project(f[k], r, limit());
        }
    const size_t bytes = fluid_grid_of(f[0])->size * sizeof(double);
    assert_memory_equal(fluid_state_of(f[0])->u, fluid_state_of(f[1])->u, bytes);
    assert_memory_equal(fluid_state_of(f[0])->p, fluid_state_of(f[1])->p, bytes);
    for (int k = 0; k < 2; k++) {
        ibm_forcing_total(ibm[k], total[k]);
        ibm_free(ibm[k]);
        fluid_free(f[k]);
    }
    for (int c = 0; c < 3; c++) check_equal(total[0][c], total[1][c]);
    free(out);
    free(slip);
    body_free(&body);
}

/* The kept force is that of the markers when they were set, also when it was given for them; a marker outside the
 * domain has none, and nothing reaches it. */
static void test_kept(void **state) {
    (void)state;
    struct fluid_input in = {.density = 1, .viscosity = 1, .immersed = 1};
    for (int d = 0; d < 3; d++) in.n[d] = CELLS, in.length[d] = 1;
    in.side[1][0].type = in.side[1][1].type = FLUID_WALL;
    in.initial_velocity[0] = 1e-3;
    struct fluid *f = fluid_new(&in);
    struct ibm *ibm = ibm_new(f, 1);
    struct body body = sphere();
    const size_t n = (size_t)body.n + 1;
    double *force[3] = {calloc(n, sizeof(double)), calloc(n, sizeof(double)), calloc(n, sizeof(double))};
    double(*u)[3] = calloc(n, sizeof *u);
    ibm_feedback_set(ibm, 0.02 * limit());
    for (int i = 0; i < body.n; i++) body.x[1][i] += 0.3; /* some are beyond the wall */
    body_send(ibm, &body);
    for (int step = 0; step < 2; step++)
        for (int r = 0; r < 3; r++) {
            fluid_predict(f, r, limit());
            ibm_feedback_begin(ibm, r, limit());
            ibm_feedback_end(ibm, r, limit());
            fluid_project(f, r, limit());
        }
    ibm_marker_force_get(ibm, force);
    for (int i = 0; i < body.n; i++) body.x[2][i] += 0.3; /* many get to another slab or rank */
    body_send(ibm, &body);
    for (int given = 0; given < 2; given++) {
        double largest = 0;
        long outside = 0;
        const double(*kept)[3] = ibm_feedback_force(ibm);
        for (int i = 0; i < body.n; i++) {
            const int is_in = body.x[1][i] <= 1;
            assert_int_equal(ibm_feedback_is_in_domain(ibm, i), is_in);
            outside += !is_in;
            for (int c = 0; c < 3; c++) check_equal(kept[i][c], is_in ? force[c][i] : 0);
            largest = fmax(largest, fabs(kept[i][0]));
        }
        assert_true(par_sum_long(outside) > 0);
        check_above(par_max(largest), 1e-6);
        for (int i = 0; i < body.n; i++) {
            body.x[2][i] += 0.3;
            for (int c = 0; c < 3; c++) force[c][i] = body.x[1][i] <= 1 ? i + 0.25 * c : 0;
        }
        ibm_marker_force_set_next(ibm, body.n, (const double *const *)force);
        body_send(ibm, &body);
        fluid_predict(f, 0, limit());
        ibm_feedback_begin(ibm, 0, limit());
        ibm_feedback_velocity(ibm, u);
        for (int i = 0; i < body.n; i++)
            for (int c = 0; c < 3 && body.x[1][i] > 1; c++) check_equal(u[i][c], 0);
        ibm_feedback_end(ibm, 0, limit());
        fluid_project(f, 0, limit());
    }
    for (int c = 0; c < 3; c++) free(force[c]);
    free(u);
    body_free(&body);
    ibm_free(ibm);
    fluid_free(f);
}

/* A sphere at rest in a moving fluid of hardly any viscosity: the energy falls, at steps up to thirty times the time in
 * which the flow crosses a cell would ask for, and the momentum that the fluid loses is the forcing's impulse. */
static void test_energy(void **state) {
    (void)state;
    const double speed = 1e-6, dt[] = {1e-3, 1, 100};
    for (int i = 0; i < 6; i++) {
        const int k = i % 3;
        struct fluid *f = box(speed, 1e-12, 0);
        struct ibm *ibm = ibm_new(f, 1);
        struct body body = sphere();
        double force[3], before[3], after[3];
        fluid_scheme_set(f, i < 3 ? FLUID_RK3 : FLUID_AB2);
        ibm_feedback_set(ibm, 1e-3 * dt[k]);
        body_send(ibm, &body);
        const double start = fluid_measures_kinetic_energy(f);
        for (int step = 0; step < 60; step++) {
            fluid_measures_momentum(f, before, NULL);
            take_step(f, ibm, dt[k]);
            fluid_measures_momentum(f, after, NULL);
            ibm_forcing_total(ibm, force);
            check_close(after[0] - before[0], force[0] * dt[k], 1e-13 * speed);
            check_at_most(fluid_measures_kinetic_energy(f), start);
        }
        check_below(fluid_measures_kinetic_energy(f), 0.9 * start);
        body_free(&body);
        ibm_free(ibm);
        fluid_free(f);
    }
}

/* What four steps of a stirred fluid leave: velocities, the forcing's total, the last U of each marker and its f. */
struct left {
    double u[3][(CELLS + 16) * (CELLS + 16) * (CELLS + 16)], total[3];
    double out[4096][3], kept[3][4096];
};

/* A sphere over the periodic side in z and a wall in y; by both ways through a stage. */
static void leave(int threads, int sent_back, struct left *left) {
    threads_set(threads);
    struct fluid_input in = {.density = 1, .viscosity = 1, .immersed = 1};
    for (int d = 0; d < 3; d++) in.n[d] = CELLS, in.length[d] = 1;
    in.side[1][0].type = in.side[1][1].type = FLUID_WALL;
    in.initial_velocity[0] = 1e-3;
    struct fluid *f = fluid_new(&in);
    struct ibm *ibm = ibm_new(f, 1);
    struct body body = sphere();
    double(*slip)[3] = calloc((size_t)body.n + 1, sizeof *slip);
    assert_in_range(body.n, 1, 4096);
    assert_true(fluid_grid_of(f)->size * sizeof(double) <= sizeof left->u[0]);
    for (int i = 0; i < body.n; i++) {
        body.x[1][i] += 0.2;
        body.x[2][i] += 0.5;
        for (int c = 0; c < 3; c++) body.v[c][i] = 1e-3 * sin(7 * i + c);
    }
    ibm_feedback_set(ibm, 0.02 * limit());
    body_send(ibm, &body);
    memset(left, 0, sizeof *left);
    for (int step = 0; step < 4; step++)
        for (int r = 0; r < 3; r++) {
            fluid_predict(f, r, limit());
            ibm_feedback_begin(ibm, r, limit());
            ibm_feedback_velocity(ibm, left->out);
            for (int i = 0; i < body.n; i++)
                for (int c = 0; c < 3; c++) slip[i][c] = body.v[c][i] - left->out[i][c];
            if (sent_back)
                ibm_feedback_apply_slip(ibm, r, limit(), (const double(*)[3])slip);
            else
                ibm_feedback_end(ibm, r, limit());
            fluid_project(f, r, limit());
        }
    const struct fluid_state *state = fluid_state_of(f);
    const double *const u[3] = {state->u, state->v, state->w};
    for (int c = 0; c < 3; c++) memcpy(left->u[c], u[c], fluid_grid_of(f)->size * sizeof(double));
    ibm_forcing_total(ibm, left->total);
    ibm_marker_force_get(ibm, (double *const[]){left->kept[0], left->kept[1], left->kept[2]});
    free(slip);
    body_free(&body);
    ibm_free(ibm);
    fluid_free(f);
    threads_set(1);
}

/* Threads share the slabs; a cell's increments are added in the same order. */
static void test_threads(void **state) {
    (void)state;
    static struct left one, more;
    for (int sent_back = 0; sent_back < 2; sent_back++) {
        leave(1, sent_back, &one);
        check_above(fabs(one.total[0]), 1e-6);
        for (int threads = 2; threads <= 4; threads++) {
            leave(threads, sent_back, &more);
            assert_memory_equal(&one, &more, sizeof one);
        }
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_step),     cmocka_unit_test(test_slip),
                                       cmocka_unit_test(test_two_ways), cmocka_unit_test(test_kept),
                                       cmocka_unit_test(test_energy),   cmocka_unit_test(test_threads)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
