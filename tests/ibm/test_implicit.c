/* Implicit forcing: one steady flow for every step, the explicit scheme's; momentum; moving bodies. */
/* One steady flow for every step and number of ranks, the explicit scheme's; momentum; moving bodies; sides with
 * conditions. */
#include "base/step_status.h"
#include "base/threads.h"
#include "tests/ibm/flows.h"
#include "ibm/feedback.h"
#include "physics/retraction.h"
#include "tests/check.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <string.h>
/* after the above */
#include <cmocka.h>

enum { N = 16 };

/* The forcing of the fluid, with the slip time of a scene, over d^2/nu. */
static struct ibm *forcing(struct fluid *f) {
    struct ibm *b = ibm_new(f, 2);
    if (fluid_input_of(f)->implicit)
        ibm_implicit_set(b, 4e-3);
    else
        ibm_feedback_set(b, 4e-3);
    return b;
}

/* One step. */
static void march(struct fluid *f, struct ibm *b, double dt) {
    for (int r = 0; r < 3; r++) {
        fluid_predict(f, r, dt);
        if (fluid_input_of(f)->implicit) {
            ibm_implicit_force_again(b, r, dt);
            fluid_diffusion_stage(f, r, dt);
            ibm_implicit_force(b, r, dt);
        } else {
            ibm_feedback_begin(b, r, dt);
            ibm_feedback_end(b, r, dt);
        }
        fluid_project(f, r, dt);
    }
}

/* A sphere in a box of unit cells and viscosity; nu dt/d^2 is dt. */
static struct fluid_input box(int implicit) {
    struct fluid_input in = {.n = {N, N, N},
                             .length = {N, N, N},
                             .density = 2,
                             .viscosity = 1,
                             .driving = {FLUID_DRIVING_GRADIENT, 0, 2e-6},
                             .immersed = 1,
                             .implicit = implicit};
    return in;
}

static struct body sphere(void) {
    const double centre[3] = {0.5 * N, 0.5 * N, 0.5 * N}, lattice[3] = {0.5, 0.5, 0.5};
    return body_sphere_cut(centre, array_radius(0.125) * N, 1, lattice, BODY_COUNTED, PHYSICS_RETRACTION);
}

/* k/L^2 after so many steps; each step's momentum balance, with the force on the fluid. */
static double permeability(int implicit, double dt, int steps) {
    const struct fluid_input in = box(implicit);
    struct fluid *f = fluid_new(&in);
    struct ibm *b = forcing(f);
    struct body body = sphere();
    body_send(b, &body);
    double before[3], after[3], force[3];
    for (int s = 0; s < steps; s++) {
        fluid_measures_momentum(f, before, NULL);
        march(f, b, dt);
        fluid_measures_momentum(f, after, NULL);
        ibm_forcing_total(b, force);
        const double driven = 2e-6 * N * N * N, residual = (after[0] - before[0]) / dt - force[0] - driven;
        check_close(residual, 0, 1e-12 * driven);
    }
    const double k = in.density * in.viscosity * fluid_measures_of(f).bulk_velocity / (2e-6 * N * N);
    ibm_free(b);
    fluid_free(f);
    body_free(&body);
    return k;
}

/* Equal within the effect of a stage's tolerance, 2e-3 of a slip that is itself a tenth of k. */
static void same_for_every_step(void **state) {
    (void)state;
    const double huge = permeability(1, 1e4, 12), large = permeability(1, 100, 12), small = permeability(1, 8, 60);
    print_message("k/L^2 = %.7f (nu dt/d^2 = 1e4), %.7f (100), %.7f (8)\n", huge, large, small);
    check_relative(large, huge, 3e-4);
    check_relative(small, huge, 3e-4);
}

/* The slip law has the mean share of a plane of markers; the explicit scheme has three stages of different lengths.
 * They differ by 1e-4 of k. With half of the slip time in the law, or the mean share of equal stages, k is off
 * by 1.8e-3. */
static void explicit_scheme_agrees(void **state) {
    (void)state;
    if (par_size() > 1) return;
    const double implicit = permeability(1, 1e3, 8), limit = 1.65 / 12, explicit = permeability(0, limit, 2000);
    print_message("k/L^2 = %.6f implicit, %.6f explicit at its limit\n", implicit, explicit);
    check_relative(implicit, explicit, 4e-4);
}

/* The sum of the forces by marker is the total force, for a body that reaches over periodic sides and ranks. */
static void markers_share_the_force(void **state) {
    (void)state;
    const struct fluid_input in = box(1);
    struct fluid *f = fluid_new(&in);
    struct ibm *b = forcing(f);
    struct body body = sphere();
    double *each[3], force[3], sum[3] = {0, 0, 0};
    for (int h = 0; h < body.n; h++) body.x[2][h] += 0.5 * N;
    body_send(b, &body);
    march(f, b, 50);
    ibm_forcing_total(b, force);
    for (int c = 0; c < 3; c++) each[c] = calloc((size_t)body.n + 1, sizeof(double));
    ibm_forcing_by_marker(b, 50, each);
    for (int c = 0; c < 3; c++) {
        for (int h = 0; h < body.n; h++) sum[c] += each[c][h];
        free(each[c]);
    }
    par_sum_array(sum, 3);
    for (int c = 0; c < 3; c++) check_close(sum[c], force[c], 1e-12 * fabs(force[0]));
    check_below(force[0], 0);
    ibm_free(b);
    fluid_free(f);
    body_free(&body);
}

/* A sphere dragged along between walls, from an inflow to an outflow, through cells and over ranks, at nu dt/d^2 from
 * 0.1 to 1e4: the flow stays of the order of the given speeds, and points that move with the sphere have its
 * velocity. */
static void a_moving_body_between_walls(void **state) {
    (void)state;
    for (int power = -1; power <= 4; power++) {
        struct fluid_input in = box(1);
        const double speed = 2e-5, dt = pow(10, power), step = speed * dt;
        in.driving.type = FLUID_DRIVING_NONE;
        in.side[1][0].type = in.side[1][1].type = FLUID_WALL;
        in.side[2][0] = (struct fluid_side){.type = FLUID_INFLOW, .bulk_velocity = speed};
        in.side[2][1].type = FLUID_OUTFLOW;
        in.initial_velocity[2] = speed;
        struct fluid *f = fluid_new(&in);
        struct ibm *b = forcing(f);
        struct body body = sphere();
        for (int s = 0; s < 12; s++) {
            for (int h = 0; h < body.n; h++) {
                body.x[0][h] += step;
                body.v[0][h] = speed;
            }
            body_send(b, &body);
            march(f, b, dt);
        }
        struct step_status status = fluid_limits_check(f);
        assert_false(status.failed);
        check_below(fluid_measures_of(f).divergence_max, 1e-12 * speed * N);
        check_below(fluid_measures_of(f).convection_rate, 20 * speed);
        if (power > 0) check_below(ibm_forcing_slip(b), 0.3 * speed);
        ibm_free(b);
        fluid_free(f);
        body_free(&body);
    }
}

/* The checkpoint's guess is sufficient for a resumed run, and it is kept when the markers are sorted again. */
static void marker_force_is_handed_on(void **state) {
    (void)state;
    const struct fluid_input in = box(1);
    struct fluid *f[2] = {fluid_new(&in), fluid_new(&in)};
    struct ibm *b[2] = {forcing(f[0]), forcing(f[1])};
    struct body body = sphere();
    double *kept[3], force[2][3];
    for (int c = 0; c < 3; c++) kept[c] = calloc((size_t)body.n + 1, sizeof(double));
    body_send(b[0], &body);
    for (int s = 0; s < 3; s++) march(f[0], b[0], 20);
    struct fluid_state *from = fluid_state_of(f[0]), *to = fluid_state_of(f[1]);
    double *const all[2][4] = {{from->u, from->v, from->w, from->p}, {to->u, to->v, to->w, to->p}};
    for (int q = 0; q < 4; q++) memcpy(all[1][q], all[0][q], fluid_grid_of(f[0])->size * sizeof(double));
    ibm_marker_force_get(b[0], kept);
    body_send(b[1], &body);
    ibm_marker_force_set(b[1], (const double *const *)kept);
    body_send(b[1], &body);
    for (int k = 0; k < 2; k++) {
        fluid_state_refresh(f[k]);
        march(f[k], b[k], 20);
        ibm_forcing_total(b[k], force[k]);
    }
    check_relative(force[1][0], force[0][0], 1e-12);
    for (int k = 0; k < 2; k++) {
        ibm_free(b[k]);
        fluid_free(f[k]);
    }
    for (int c = 0; c < 3; c++) free(kept[c]);
    body_free(&body);
}

/* Threads share the slabs of the markers and the planes of the fluid; a cell's increments are added in the same
 * order. The sphere reaches over the periodic side in z, and over its ranks. */
static void threads_make_no_difference(void **state) {
    (void)state;
    static double first[3][(N + 16) * (N + 16) * (N + 16)];
    for (int threads = 1; threads <= 4; threads++) {
        threads_set(threads);
        const struct fluid_input in = box(1);
        struct fluid *f = fluid_new(&in);
        struct ibm *b = forcing(f);
        struct body body = sphere();
        for (int h = 0; h < body.n; h++) {
            body.x[2][h] += 0.5 * N;
            for (int c = 0; c < 3; c++) body.v[c][h] = 1e-5 * sin(7 * h + c);
        }
        body_send(b, &body);
        for (int s = 0; s < 2; s++) march(f, b, 50);
        const struct fluid_state *now = fluid_state_of(f);
        const double *const all[3] = {now->u, now->v, now->w};
        for (int c = 0; c < 3; c++) {
            const size_t bytes = fluid_grid_of(f)->size * sizeof(double);
            assert_true(bytes <= sizeof first[c]);
            if (threads == 1) memcpy(first[c], all[c], bytes);
            assert_memory_equal(first[c], all[c], bytes);
        }
        ibm_free(b);
        fluid_free(f);
        body_free(&body);
        threads_set(1);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(same_for_every_step),       cmocka_unit_test(explicit_scheme_agrees),
        cmocka_unit_test(markers_share_the_force),   cmocka_unit_test(a_moving_body_between_walls),
        cmocka_unit_test(marker_force_is_handed_on), cmocka_unit_test(threads_make_no_difference)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
