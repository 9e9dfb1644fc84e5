/* Markers and forcing against plain sums over the whole grid. */
#include "base/par.h"
#include "base/threads.h"
#include "tests/ibm/bodies.h"
#include "physics/rk3.h"
#include "tests/check.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>

enum { NX = 14, NY = 16, NZ = 20, MARKERS = 200 };
static const int cells[3] = {NX, NY, NZ};
static const double dx = 0.1;

/* A number in [-1, 1) that depends on nothing but n. */
static double hash(unsigned n) {
    n = (n ^ 61) ^ (n >> 16);
    n *= 9;
    n ^= n >> 4;
    n *= 0x27d4eb2du;
    n ^= n >> 15;
    return (double)n / 2147483648.0 - 1;
}

static struct fluid *box(int wall_y) {
    struct fluid_input in = {.density = 3, .viscosity = 1e-3, .immersed = 1};
    for (int d = 0; d < 3; d++) in.n[d] = cells[d], in.length[d] = cells[d] * dx;
    if (wall_y) in.side[1][0].type = in.side[1][1].type = FLUID_WALL;
    return fluid_new(&in);
}

/* Smooth in space and the same on any ranks. */
static double wave(int c, int i, int j, int k) {
    return sin(2 * M_PI * (i + 0.3 * c) / NX) * cos(2 * M_PI * (j - 0.2 * c) / NY) +
           0.5 * cos(2 * M_PI * k * (1 + c) / NZ);
}

static void set_predicted(struct fluid *f) {
    const struct fluid_grid *g = fluid_grid_of(f);
    double *const *u = fluid_predicted(f);
    for (int c = 0; c < 3; c++)
        for (int k = 0; k < g->m[2]; k++)
            for (int j = 0; j < g->m[1]; j++)
                for (int i = 0; i < g->m[0]; i++)
                    u[c][fluid_grid_at(g, i, j, k)] = wave(c, i + g->lo[0], j + g->lo[1], k + g->lo[2]);
    fluid_predicted_refresh(f, 3);
}

/* Markers at arbitrary positions: around the box, some a whole period away, some on cells' sides; velocities and areas
 * by number. everywhere: all of them on every rank. */
static struct body cloud(double low, double high, double moved, int everywhere) {
    struct body b = body_new(MARKERS);
    for (unsigned h = 0; h < MARKERS; h++) {
        double x[3];
        for (unsigned d = 0; d < 3; d++) {
            const double s = 0.5 * (1 + hash(7 * h + d));
            x[d] = (low + (high - low) * s) * cells[d] * dx + moved * hash(h + d);
            if (h % 50 == 0) x[d] = floor(x[d] / dx) * dx;
        }
        body_add(&b, x, x);
    }
    if (everywhere)
        b.n = MARKERS;
    else
        body_finish(&b, 0, dx);
    const long first = everywhere ? 0 : (long)MARKERS * par_rank() / par_size();
    for (int h = 0; h < b.n; h++) {
        const unsigned id = (unsigned)(h + first);
        for (unsigned d = 0; d < 3; d++) b.v[d][h] = hash(1000 + 3 * id + d);
        b.area[h] = dx * dx * (1 + 0.5 * hash(5000 + id));
        b.volume[h] = b.area[h] * dx;
    }
    return b;
}

/* delta(x_face - X) cell, over periodic images */
static double weight(int c, const int at[3], const struct body *b, int h) {
    double w = 1;
    for (int d = 0; d < 3; d++) {
        double t = at[d] + (d == c ? 1.0 : 0.5) - b->x[d][h] / dx;
        t -= cells[d] * floor(t / cells[d] + 0.5);
        w *= ibm_kernel(t);
        if (w == 0) return 0;
    }
    return w;
}

/* N_s iterations of the forcing by plain sums over a periodic box; u [3][NZ][NY][NX] */
static void force_plainly(double (*u)[NZ][NY][NX], const struct body *b, int iterations) {
    static double lack[MARKERS][3];
    for (int s = 0; s < iterations; s++) {
        memset(lack, 0, sizeof lack);
        for (int pass = 0; pass < 2; pass++)
            for (int h = 0; h < MARKERS; h++)
                for (int c = 0; c < 3; c++) {
                    double sum = 0;
                    for (int k = 0; k < NZ; k++)
                        for (int j = 0; j < NY; j++)
                            for (int i = 0; i < NX; i++) {
                                const double w = weight(c, (int[3]){i, j, k}, b, h);
                                if (w == 0) continue;
                                if (pass == 0)
                                    sum += w * u[c][k][j][i];
                                else
                                    u[c][k][j][i] += lack[h][c] * w * b->volume[h] / (dx * dx * dx);
                            }
                    if (pass == 0) lack[h][c] = b->v[c][h] - sum;
                }
    }
}

static void compare(struct fluid *f, double (*u)[NZ][NY][NX]) {
    const struct fluid_grid *g = fluid_grid_of(f);
    double worst = 0;
    for (int c = 0; c < 3; c++)
        for (int k = 0; k < g->m[2]; k++)
            for (int j = 0; j < g->m[1]; j++)
                for (int i = 0; i < g->m[0]; i++)
                    worst = check_worst(worst, fluid_predicted(f)[c][fluid_grid_at(g, i, j, k)] -
                                                   u[c][k + g->lo[2]][j + g->lo[1]][i + g->lo[0]]);
    check_close(par_max(worst), 0, 1e-12);
}

/* Markers all over a periodic box and one period outside it; set, moved, given other velocities. */
static void forcing_is_the_plain_sum(void **state) {
    (void)state;
    struct fluid *f = box(0);
    struct ibm *b = ibm_new(f, 2);
    double(*u)[NZ][NY][NX] = malloc(3 * sizeof *u);
    for (int turn = 0; turn < 3; turn++) {
        const double moved = turn >= 2 ? 0.04 : 0;
        struct body mine = cloud(-0.4, 1.3, moved, 0), all = cloud(-0.4, 1.3, moved, 1);
        for (int d = 0; d < 3; d++) { /* turn 1: only this differs from the last turn */
            for (int h = 0; h < mine.n; h++) mine.v[d][h] += turn;
            for (int h = 0; h < all.n; h++) all.v[d][h] += turn;
        }
        set_predicted(f);
        body_send(b, &mine);
        ibm_forcing_stage(b, turn % 3, 0.01);
        for (int c = 0; c < 3; c++)
            for (int k = 0; k < NZ; k++)
                for (int j = 0; j < NY; j++)
                    for (int i = 0; i < NX; i++) u[c][k][j][i] = wave(c, i, j, k);
        force_plainly(u, &all, 2);
        compare(f, u);
        body_free(&mine);
        body_free(&all);
    }
    free(u);
    ibm_free(b);
    fluid_free(f);
}

static double grid_sum(struct fluid *f, int c, int torque_arm) {
    const struct fluid_grid *g = fluid_grid_of(f);
    double sum = 0;
    for (int k = 0; k < g->m[2]; k++)
        for (int j = 0; j < g->m[1]; j++)
            for (int i = 0; i < g->m[0]; i++) {
                const int at[3] = {i, j, k};
                const double arm =
                    torque_arm < 0 ? 1 : (at[torque_arm] + g->lo[torque_arm] + (torque_arm == c ? 1.0 : 0.5)) * dx;
                sum += arm * fluid_predicted(f)[c][fluid_grid_at(g, i, j, k)];
            }
    return par_sum(sum) * dx * dx * dx;
}

/* <S F, u> over the grid = <F, I u> over the markers, for any F and u, across ranks and periodic sides. */
static void spreading_is_adjoint(void **state) {
    (void)state;
    struct fluid *f = box(0);
    const struct fluid_grid *g = fluid_grid_of(f);
    struct ibm *b = ibm_new(f, 1);
    struct body mine = cloud(0, 1, 0, 0), still = cloud(0, 1, 0, 0);
    for (int d = 0; d < 3; d++) memset(still.v[d], 0, (size_t)still.n * sizeof(double));

    /* onto a fluid at rest one iteration leaves S V */
    for (int c = 0; c < 3; c++) memset(fluid_predicted(f)[c], 0, g->size * sizeof(double));
    body_send(b, &mine);
    ibm_forcing_stage(b, 0, 1);
    double grid = 0, *spread[3], *force[3];
    for (int c = 0; c < 3; c++) {
        force[c] = calloc(MARKERS, sizeof(double));
        spread[c] = malloc(g->size * sizeof(double));
        memcpy(spread[c], fluid_predicted(f)[c], g->size * sizeof(double));
    }
    set_predicted(f);
    for (int c = 0; c < 3; c++)
        for (int k = 0; k < g->m[2]; k++)
            for (int j = 0; j < g->m[1]; j++)
                for (int i = 0; i < g->m[0]; i++) {
                    const size_t n = fluid_grid_at(g, i, j, k);
                    grid += spread[c][n] * fluid_predicted(f)[c][n];
                }
    /* markers at rest lack -I u, and one iteration gives exactly that */
    double markers = 0;
    const double unit = fluid_input_of(f)->density * dx * dx * dx;
    body_send(b, &still);
    ibm_forcing_stage(b, 0, 1);
    ibm_forcing_by_marker(b, 1, force);
    for (int h = 0; h < mine.n; h++)
        for (int c = 0; c < 3; c++) markers -= mine.v[c][h] * force[c][h] / unit;
    grid = par_sum(grid);
    markers = par_sum(markers);
    check_above(fabs(grid), 0.1);
    check_close(grid, markers, 1e-13 * fabs(grid) + 1e-13);
    for (int c = 0; c < 3; c++) free(spread[c]), free(force[c]);
    body_free(&mine);
    body_free(&still);
    ibm_free(b);
    fluid_free(f);
}

/* Away from the sides of the domain the fluid gets each marker's force and its torque. */
static void force_and_torque_are_kept(void **state) {
    (void)state;
    struct fluid *f = box(0);
    struct ibm *b = ibm_new(f, 1);
    struct body mine = cloud(0.2, 0.8, 0, 0);
    for (int c = 0; c < 3; c++) memset(fluid_predicted(f)[c], 0, fluid_grid_of(f)->size * sizeof(double));
    body_send(b, &mine);
    ibm_forcing_stage(b, 0, 1);
    double force[3] = {0, 0, 0}, torque[3] = {0, 0, 0};
    for (int h = 0; h < mine.n; h++)
        for (int c = 0; c < 3; c++) {
            const int p = (c + 1) % 3, q = (c + 2) % 3;
            force[c] += mine.v[c][h] * mine.volume[h];
            torque[c] += (mine.x[p][h] * mine.v[q][h] - mine.x[q][h] * mine.v[p][h]) * mine.volume[h];
        }
    par_sum_array(force, 3);
    par_sum_array(torque, 3);
    for (int c = 0; c < 3; c++) {
        const int p = (c + 1) % 3, q = (c + 2) % 3;
        check_close(grid_sum(f, c, -1), force[c], 1e-13);
        check_close(grid_sum(f, q, p) - grid_sum(f, p, q), torque[c], 1e-13);
    }
    body_free(&mine);
    ibm_free(b);
    fluid_free(f);
}

/* The reported force is the one that the fluid received, also near walls, where part of a kernel is outside. */
static void force_total_is_what_the_fluid_received(void **state) {
    (void)state;
    static const double gamma[3] = {8.0 / 15, 2.0 / 15, 1.0 / 3};
    for (int wall = 0; wall < 2; wall++) {
        struct fluid *f = box(wall);
        struct ibm *b = ibm_new(f, 2);
        struct body mine = cloud(0, 1, 0, 0);
        body_send(b, &mine);
        const double dt = 0.02;
        double received[3] = {0, 0, 0}, total[3];
        for (int r = 0; r < 3; r++) {
            set_predicted(f);
            double before[3];
            for (int c = 0; c < 3; c++) before[c] = grid_sum(f, c, -1);
            ibm_forcing_stage(b, r, dt);
            /* rho int du dV = gamma_r dt F_r */
            for (int c = 0; c < 3; c++) received[c] += 3 * (grid_sum(f, c, -1) - before[c]) / dt;
        }
        ibm_forcing_total(b, total);
        for (int c = 0; c < 3; c++) {
            check_above(fabs(total[c]), 1e-3);
            check_close(total[c], received[c], 1e-12 * fabs(received[c]) + 1e-13 / dt);
        }
        for (int r = 0; r < 3; r++) check_close(physics_rk3_gamma[r], gamma[r], 1e-15);
        body_free(&mine);
        ibm_free(b);
        fluid_free(f);
    }
}

/* The work of all stages' forces: of the forces by marker where none is cut off, and with one velocity that of the
 * total force, near walls too. */
static void work_is_force_times_velocity(void **state) {
    (void)state;
    for (int wall = 0; wall < 2; wall++) {
        struct fluid *f = box(wall);
        struct ibm *b = ibm_new(f, 2);
        struct body mine = cloud(0, 1, 0, 0);
        const double dt = 0.02;
        double total[3], power = 0, size = 0, *force[3];
        for (int c = 0; c < 3; c++) force[c] = calloc((size_t)mine.n + 1, sizeof(double));
        for (int h = 0; wall && h < mine.n; h++)
            for (int c = 0; c < 3; c++) mine.v[c][h] = 0.3 + c;
        body_send(b, &mine);
        for (int r = 0; r < 3; r++) {
            set_predicted(f);
            ibm_forcing_stage(b, r, dt);
        }
        ibm_forcing_total(b, total);
        ibm_forcing_by_marker(b, dt, force);
        for (int c = 0; c < 3; c++) {
            for (int h = 0; !wall && h < mine.n; h++) power += force[c][h] * mine.v[c][h];
            for (int h = 0; h < mine.n; h++) size += fabs(force[c][h] * mine.v[c][h]);
        }
        power = wall ? total[0] * 0.3 + total[1] * 1.3 + total[2] * 2.3 : par_sum(power);
        size = par_sum(size);
        check_above(fabs(power), 1e-3 * size);
        check_close(par_sum(ibm_forcing_work(b)) / dt, power, 1e-13 * size);
        for (int c = 0; c < 3; c++) free(force[c]);
        body_free(&mine);
        ibm_free(b);
        fluid_free(f);
    }
}

/* Faces on a wall keep the wall's velocity; a marker outside the domain has no effect. */
static void walls_are_left_alone(void **state) {
    (void)state;
    struct fluid *f = box(1);
    const struct fluid_grid *g = fluid_grid_of(f);
    struct ibm *b = ibm_new(f, 3);
    struct body out = body_new(MARKERS), near = body_new(MARKERS);
    for (int h = 0; h < 60; h++) {
        const double x = (h + 0.5) / 60 * cells[0] * dx;
        body_add(&out, (double[3]){x, h % 2 ? -0.3 * dx : (NY + 0.1) * dx, x}, (double[3]){0, 1, 0});
        body_add(&near, (double[3]){x, h % 2 ? 0.3 * dx : (NY - 0.4) * dx, x}, (double[3]){0, 1, 0});
    }
    body_finish(&out, 60 * dx * dx, dx);
    body_finish(&near, 60 * dx * dx, dx);
    for (int h = 0; h < out.n; h++) out.v[1][h] = 1;
    for (int h = 0; h < near.n; h++) near.v[1][h] = 1;
    for (int c = 0; c < 3; c++) memset(fluid_predicted(f)[c], 0, g->size * sizeof(double));
    double total[3];
    body_send(b, &out);
    ibm_forcing_stage(b, 0, 1);
    ibm_forcing_total(b, total);
    check_equal(total[0], 0);
    check_equal(total[1], 0);
    check_equal(total[2], 0);
    body_send(b, &near);
    ibm_forcing_stage(b, 0, 1);
    ibm_forcing_total(b, total);
    check_above(total[1], 0.01);
    double on_wall = 0;
    for (int k = 0; k < g->m[2]; k++)
        for (int i = 0; i < g->m[0]; i++) {
            if (g->lo[1] == 0) on_wall = check_worst(on_wall, fluid_predicted(f)[1][fluid_grid_at(g, i, -1, k)]);
            if (g->lo[1] + g->m[1] == NY)
                on_wall = check_worst(on_wall, fluid_predicted(f)[1][fluid_grid_at(g, i, g->m[1] - 1, k)]);
        }
    check_equal(par_max(on_wall), 0);
    body_free(&out);
    body_free(&near);
    ibm_free(b);
    fluid_free(f);
}

/* A sphere held in a uniform stream: the more iterations, the less it slips. */
static void slip_falls_with_iterations(void **state) {
    (void)state;
    static const int iterations[4] = {0, 1, 2, 5};
    double last = INFINITY;
    for (int n = 0; n < 4; n++) {
        struct fluid *f = box(0);
        struct ibm *b = ibm_new(f, iterations[n]);
        const double centre[3] = {0.71, 0.83, 0.92}, lattice[3] = {0.05, 0.05, 0.05};
        struct body sphere = body_sphere_lattice(centre, 0.48, dx, lattice, 0);
        for (int c = 0; c < 3; c++)
            for (size_t i = 0; i < fluid_grid_of(f)->size; i++) fluid_predicted(f)[c][i] = c == 0;
        body_send(b, &sphere);
        ibm_forcing_stage(b, 0, 1);
        const double slip = ibm_forcing_slip(b);
        if (n == 0) check_close(slip, 1, 1e-14);
        check_below(slip, last);
        last = slip;
        body_free(&sphere);
        ibm_free(b);
        fluid_free(f);
    }
    check_below(last, 0.1);
}

/* Threads share the slabs; a cell's increments are added in the same order. Two iterations in one pass on one thread,
 * and one after the other on several; three have one more. */
static void threads_make_no_difference(void **state) {
    (void)state;
    for (int iterations = 2; iterations <= 3; iterations++) {
        static double first[3][(NX + 16) * (NY + 16) * (NZ + 16)], given[3], slip;
        for (int threads = 1; threads <= 3; threads++) {
            threads_set(threads);
            struct fluid *f = box(1);
            struct ibm *b = ibm_new(f, iterations);
            struct body m = cloud(0, 1, 0, 0);
            double total[3];
            ibm_markers_set(b, m.n, (const double *const *)m.x, (const double *const *)m.v, m.volume);
            set_predicted(f);
            ibm_forcing_stage(b, 0, 0.01);
            ibm_forcing_total(b, total);
            const double now = ibm_forcing_slip(b);
            for (int c = 0; c < 3; c++) {
                const size_t bytes = fluid_grid_of(f)->size * sizeof(double);
                assert_true(bytes <= sizeof first[c]);
                if (threads == 1) memcpy(first[c], fluid_predicted(f)[c], bytes);
                assert_memory_equal(first[c], fluid_predicted(f)[c], bytes);
                if (threads == 1) given[c] = total[c], slip = now;
                check_equal(total[c], given[c]);
            }
            check_equal(now, slip);
            body_free(&m);
            ibm_free(b);
            fluid_free(f);
            threads_set(1);
        }
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(forcing_is_the_plain_sum),     cmocka_unit_test(spreading_is_adjoint),
        cmocka_unit_test(force_and_torque_are_kept),    cmocka_unit_test(force_total_is_what_the_fluid_received),
        cmocka_unit_test(work_is_force_times_velocity), cmocka_unit_test(walls_are_left_alone),
        cmocka_unit_test(slip_falls_with_iterations),   cmocka_unit_test(threads_make_no_difference)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
