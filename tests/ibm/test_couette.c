/* Taylor-Couette flow between immersed cylinders: torque and velocity against the exact solution. */
/* Taylor-Couette flow with both cylinders immersed, R2 = 2 R1, the inner one turning: u = A r + B/r between them, A =
 * -Omega/3, B = 4 Omega R1^2/3, and a torque of 4 pi mu Omega R1^2/(1 - 1/4) = 16.755161 mu Omega R1^2 a length.
 * Markers are as deep in the material as is exact for a plane, (1/2 + 2 phi(t-1) phi(t+1))/2 cells in the mean over
 * positions t on the grid (test_planes.c). The fluid inside the inner cylinder rotates as a rigid body; the fluid
 * outside the outer one is at rest except for leakage. */
#include "tests/ibm/flows.h"
#include "tests/check.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <cmocka.h>

enum { ACROSS = 6, DEPTH = 3 }; /* the box, inner radii; cells along the cylinders */
static const double RETRACTION = 0.266, OMEGA = 1e-3, RADIUS = 1;

struct couette {
    double torque[2]; /* of the cylinders on the fluid about their axis, per length, over mu Omega R1^2: inner, outer */
    double seam;      /* torque of the box's periodic sides, in the same unit */
    double rate;      /* d/dt of the fluid's angular momentum over the last step, in the same unit */
    double error;     /* of u between the cylinders, root mean square over Omega R1 */
    double slip;      /* over Omega R1 */
};

static double centre(void) { return 0.5 * ACROSS * RADIUS; }

/* Speed at a distance from the axis. */
static double exact(double r) {
    if (r < RADIUS) return OMEGA * r;
    return r < 2 * RADIUS ? OMEGA / 3 * (4 * RADIUS * RADIUS / r - r) : 0;
}

/* Position of velocity c of cell i, j relative to the axis. */
static double place(const struct fluid_grid *g, int c, int i, int j, double x[2]) {
    x[0] = (g->lo[0] + i + (c == 0 ? 1 : 0.5)) * g->d[0] - centre();
    x[1] = (g->lo[1] + j + (c == 1 ? 1 : 0.5)) * g->d[1] - centre();
    return sqrt(x[0] * x[0] + x[1] * x[1]);
}

static struct body cylinders(double dx) {
    struct body b = body_new(200000);
    for (int c = 0; c < 2; c++) {
        const double wall = (c + 1) * RADIUS, r = wall + (c ? 1 : -1) * RETRACTION * dx;
        const int around = (int)(2 * M_PI * wall / dx + 0.5);
        for (int k = 0; k < DEPTH; k++)
            for (int i = 0; i < around; i++) {
                const double turn = 2 * M_PI * (i + 0.3) / around;
                const double n[3] = {cos(turn), sin(turn), 0};
                const double x[3] = {centre() + r * n[0], centre() + r * n[1], (k + 0.5) * dx};
                body_add(&b, x, n);
                b.area[b.total - 1] = 2 * M_PI * wall / around * dx;
                for (int d = 0; d < 2; d++) b.v[d][b.total - 1] = c ? 0 : OMEGA * r * (d ? n[0] : -n[1]);
            }
    }
    b.n = (int)b.total;
    for (int i = 0; i < b.n; i++) b.volume[i] = b.area[i] * dx;
    return b;
}

static void fill_exact(struct fluid *f) {
    const struct fluid_grid *g = fluid_grid_of(f);
    double *const u[2] = {fluid_state_of(f)->u, fluid_state_of(f)->v};
    for (int k = 0; k < g->m[2]; k++)
        for (int j = 0; j < g->m[1]; j++)
            for (int i = 0; i < g->m[0]; i++)
                for (int c = 0; c < 2; c++) {
                    double x[2];
                    const double r = place(g, c, i, j, x);
                    u[c][fluid_grid_at(g, i, j, k)] = exact(r) / r * (c ? x[0] : -x[1]);
                }
    fluid_state_refresh(f);
}

/* Angular momentum a length; and the error between the cylinders. */
static double angular(struct fluid *f, double *error) {
    const struct fluid_grid *g = fluid_grid_of(f);
    const double *const u[2] = {fluid_state_of(f)->u, fluid_state_of(f)->v};
    double sum = 0, squares = 0, n = 0;
    for (int k = 0; k < g->m[2]; k++)
        for (int j = 0; j < g->m[1]; j++)
            for (int i = 0; i < g->m[0]; i++)
                for (int c = 0; c < 2; c++) {
                    double x[2];
                    const double r = place(g, c, i, j, x), e = exact(r) / r * (c ? x[0] : -x[1]);
                    const double have = u[c][fluid_grid_at(g, i, j, k)];
                    sum += c ? x[0] * have : -x[1] * have;
                    if (r < RADIUS || r > 2 * RADIUS) continue;
                    squares += (have - e) * (have - e);
                    n++;
                }
    *error = sqrt(squares / n) / (OMEGA * RADIUS);
    return sum * g->d[0] * g->d[1] / DEPTH;
}

/* The torque that friction and convection take across the periodic sides, a length: x and y leap by the box's width
 * there. */
static double across_seam(struct fluid *f) {
    const struct fluid_grid *g = fluid_grid_of(f);
    const double *u = fluid_state_of(f)->u, *v = fluid_state_of(f)->v, d = g->d[0];
    const int n = g->n[0], last = n - 1;
    double sum = 0;
    for (int k = 0; k < DEPTH; k++)
        for (int i = 0; i < n; i++) {
#define AT(a, i, j) a[fluid_grid_at(g, i, j, k)]
            const int next = (i + 1) % n;
            sum += (AT(v, 0, i) - AT(v, last, i)) / d;
            sum -= 0.25 * (AT(v, 0, i) + AT(v, last, i)) * (AT(u, last, i) + AT(u, last, next));
            sum -= (AT(u, i, 0) - AT(u, i, last)) / d;
            sum += 0.25 * (AT(u, i, 0) + AT(u, i, last)) * (AT(v, i, last) + AT(v, next, last));
#undef AT
        }
    return sum * n * d * d / DEPTH;
}

static struct couette turn(int cells, int iterations, double time) {
    const double dx = ACROSS * RADIUS / cells, dt = 1.65 * dx * dx / 12, unit = OMEGA * RADIUS * RADIUS;
    struct fluid_input in = {.n = {cells, cells, DEPTH}, .density = 1, .viscosity = 1, .immersed = 1};
    for (int d = 0; d < 3; d++) in.length[d] = in.n[d] * dx;
    struct fluid *f = fluid_new(&in);
    struct ibm *ibm = ibm_new(f, iterations);
    struct body body = cylinders(dx);
    struct couette c = {.slip = 0};
    double before = 0, seam = 0, ignored;
    fill_exact(f);
    const long steps = (long)ceil(time / dt);
    for (long step = 0; step < steps; step++) {
        before = angular(f, &ignored);
        seam = 0.25 * across_seam(f); /* RK3 adds its stages' rates up to 1/4, 0, 3/4 */
        body_send(ibm, &body);
        for (int r = 0; r < 3; r++) {
            fluid_predict(f, r, dt);
            ibm_forcing_stage(ibm, r, dt);
            fluid_project(f, r, dt);
            if (r == 1) seam += 0.75 * across_seam(f);
        }
    }
    double *force[3];
    for (int d = 0; d < 3; d++) force[d] = calloc((size_t)body.n, sizeof(double));
    ibm_forcing_by_marker(ibm, dt, force);
    for (int i = 0; i < body.n; i++)
        c.torque[i >= body.n - (int)lrint(2 * 2 * M_PI * RADIUS / dx) * DEPTH] +=
            ((body.x[0][i] - centre()) * force[1][i] - (body.x[1][i] - centre()) * force[0][i]) / (DEPTH * dx) / unit;
    c.rate = (angular(f, &c.error) - before) / dt / unit;
    c.seam = seam / unit;
    c.slip = ibm_forcing_slip(ibm) / (OMEGA * RADIUS);
    for (int d = 0; d < 3; d++) free(force[d]);
    body_free(&body);
    ibm_free(ibm);
    fluid_free(f);
    return c;
}

static const double TORQUE = 16.755161;

static void torque_and_velocity_converge(void **state) {
    (void)state;
    static const int cells[3] = {24, 48, 72};
    struct couette c[3];
    for (int n = 0; n < 3; n++) {
        c[n] = turn(cells[n], 2, 0.6);
        print_message("R1 = %2d cells: torque %.4f, %.4f (%+.2f %%), u %.3e, slip %.2e, budget %.1e\n",
                      cells[n] / ACROSS, c[n].torque[0], c[n].torque[1], 100 * (c[n].torque[0] / TORQUE - 1),
                      c[n].error, c[n].slip, c[n].torque[0] + c[n].torque[1] + c[n].seam - c[n].rate);
        /* the torque of the cylinders changes the fluid's angular momentum, or leaves through the sides */
        check_close(c[n].torque[0] + c[n].torque[1] + c[n].seam - c[n].rate, 0, 1e-9 * TORQUE);
    }
    const double order = log(fabs(c[0].torque[0] - TORQUE) / fabs(c[2].torque[0] - TORQUE)) / log(3);
    const double order_u = log(c[0].error / c[2].error) / log(3);
    print_message("order of the torque %.2f, of u %.2f\n", order, order_u);
    check_relative(c[1].torque[0], TORQUE, 0.03);
    check_relative(c[2].torque[0], TORQUE, 0.01);
    check_above(order, 1.7);
    check_above(order_u, 1);
}

static void slip_falls_with_iterations(void **state) {
    (void)state;
    static const int iterations[4] = {1, 2, 3, 5};
    double last = INFINITY;
    for (int n = 0; n < 4; n++) {
        const struct couette c = turn(48, iterations[n], 0.1);
        print_message("N_s = %d: slip %.3e, torque %.4f\n", iterations[n], c.slip, c.torque[0]);
        check_below(c.slip, 0.8 * last);
        last = c.slip;
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(torque_and_velocity_converge),
                                       cmocka_unit_test(slip_falls_with_iterations)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
