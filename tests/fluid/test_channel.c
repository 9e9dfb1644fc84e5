/* Laminar flows with known solutions. Between walls at 0 and H the scheme holds, at the cell centres, the parabola plus
 * a constant: u = G/(2 mu) (y (H - y) + dy^2/4). */
#include "tests/fluid/fluid_case.h"
#include "tests/check.h"

/* A channel along `stream` between walls along `across`, thin in the third direction. */
static struct fluid_input channel(int stream, int across, int n) {
    struct fluid_input in = {.n = {4, 4, 4}, .length = {4, 4, 4}, .density = 2, .viscosity = 0.5};
    for (int d = 0; d < 3; d++) all_sides(&in, d, FLUID_PERIODIC);
    in.n[across] = n;
    in.length[across] = 1;
    all_sides(&in, across, FLUID_WALL);
    in.driving.direction = stream;
    return in;
}

static double parabola(const struct fluid_grid *g, int across, int j, double gradient, double mu) {
    const double y = (j + g->lo[across] + 0.5) * g->d[across];
    return gradient / (2 * mu) * (y * (g->length[across] - y) + 0.25 * g->d[across] * g->d[across]);
}

/* Largest distance from the parabola of gradient G over the largest velocity, and largest cross flow. */
static double off_parabola(struct fluid *f, int stream, int across, double gradient) {
    const struct fluid_grid *g = fluid_grid_of(f);
    const double mu = fluid_input_of(f)->viscosity * fluid_input_of(f)->density, most = fabs(gradient) / (8 * mu);
    double worst = 0;
    for (int c = 0; c < 3; c++)
        for (int k = 0; k < g->m[2]; k++)
            for (int j = 0; j < g->m[1]; j++)
                for (int i = 0; i < g->m[0]; i++) {
                    const int at[3] = {i, j, k};
                    const double expected = c == stream ? parabola(g, across, at[across], gradient, mu) : 0;
                    worst = check_worst(worst, (component(f, c)[fluid_grid_at(g, i, j, k)] - expected));
                }
    return par_max(worst) / most;
}

static void poiseuille_by_gradient(void **state) {
    (void)state;
    for (int stream = 0; stream < 3; stream++)
        for (int across = 0; across < 3; across++) {
            if (stream == across) continue;
            struct fluid_input in = channel(stream, across, 9);
            in.driving.type = FLUID_DRIVING_GRADIENT;
            in.driving.value = 3;
            struct fluid *f = fluid_new(&in);
            const double dt = 0.9 * fluid_limits_stable_step(f).viscous;
            for (double t = 0; t * 0.5 < 2.8; t += dt) fluid_step(f, dt);
            check_below(off_parabola(f, stream, across, 3), 1e-10);
            fluid_free(f);
        }
}

/* The centreline and quarter heights at nu t/h^2, h the half height, in units of the final centre velocity.  (series
 * solution) */
static void start_up(void **state) {
    (void)state;
    static const double time[] = {0.05, 0.1, 0.2, 0.5, 1, 2};
    static const double centre[] = {.099956, .197746, .370386, .699455, .912477, .992578};
    static const double quarter[] = {.096298, .176878, .304159, .537481, .688112, .744752};
    struct fluid_input in = channel(0, 1, 33); /* odd: the centre is a cell's; y = h/2 lies a quarter cell off one */
    in.driving.type = FLUID_DRIVING_GRADIENT;
    in.driving.value = 8 * in.density * in.viscosity; /* centre velocity 1 */
    struct fluid *f = fluid_new(&in);
    const struct fluid_grid *g = fluid_grid_of(f);
    double t = 0;
    for (int s = 0; s < 6; s++) {
        const double until = time[s] * 0.25 / in.viscosity;
        const int steps = (int)ceil((until - t) / (0.9 * fluid_limits_stable_step(f).viscous));
        for (int i = 0; i < steps; i++) fluid_step(f, (until - t) / steps);
        t = until;
        double line[33] = {0};
        for (int j = 0; j < g->m[1]; j++)
            line[j + g->lo[1]] = g->lo[2] == 0 ? fluid_state_of(f)->u[fluid_grid_at(g, 0, j, 0)] : 0;
        par_sum_array(line, 33);
        const double at = 0.25 * 33 - 0.5;
        const int low = (int)at;
        check_close(line[16], centre[s], 1e-3);
        check_close(line[low] + (at - low) * (line[low + 1] - line[low]), quarter[s], 1e-3);
    }
    fluid_free(f);
}

/* Started and fed with the developed profile, a channel with an outflow does not change and has the exact pressure
 * gradient; a uniform inflow develops into that profile. */
static void inflow_and_outflow(void **state) {
    (void)state;
    for (int uniform = 0; uniform < 2; uniform++)
        for (int stream = 0; stream < 3; stream++)
            for (int reverse = 0; reverse < 2; reverse++) {
                const int across = (stream + 1) % 3, n = 8;
                struct fluid_input in = channel(stream, across, n);
                const double mean = reverse ? -1 : 1, mu = in.density * in.viscosity;
                in.n[stream] = 12;
                in.length[stream] = 2;
                in.side[stream][reverse] =
                    (struct fluid_side){.type = FLUID_INFLOW, .profile = FLUID_POISEUILLE, .bulk_velocity = 1};
                in.side[stream][!reverse].type = FLUID_OUTFLOW;
                in.initial_poiseuille = !uniform;
                in.initial_velocity[stream] = mean;
                struct fluid *f = fluid_new(&in);
                const double dt = 0.9 * fluid_limits_stable_step(f).step, end = uniform ? 6 : 0.2;
                for (double t = 0; t < end; t += dt) {
                    fluid_step(f, dt);
                    if (uniform && t < 10 * dt) check_below(fluid_measures_of(f).divergence_max, 1e-12);
                }
                /* mean of the discrete parabola: G/(2 mu) (1/6 + dy^2/12 + dy^2/4) */
                const double dy = 1.0 / n, gradient = 2 * mu * mean / (1.0 / 6 + dy * dy / 3);
                check_below(off_parabola(f, stream, across, gradient), uniform ? 1e-9 : 1e-11);
                double pressure[12];
                fluid_measures_mean_pressure(f, stream, pressure);
                check_close((pressure[3] - pressure[9]) / (6 * in.length[stream] / 12), gradient,
                            1e-8 * fabs(gradient));
                check_close(bulk_velocity_along(f, stream), mean, 1e-12);
                fluid_free(f);
            }
}

/* Two open sides at given pressures drive the same parabola, in both directions. */
static void between_pressures(void **state) {
    (void)state;
    for (int stream = 0; stream < 3; stream++)
        for (int reverse = 0; reverse < 2; reverse++) {
            const int across = (stream + 2) % 3;
            struct fluid_input in = channel(stream, across, 8);
            in.n[stream] = 6;
            in.length[stream] = 3;
            in.side[stream][reverse] = (struct fluid_side){.type = FLUID_PRESSURE, .pressure = 7};
            in.side[stream][!reverse] = (struct fluid_side){.type = FLUID_PRESSURE, .pressure = 1};
            struct fluid *f = fluid_new(&in);
            const double dt = 0.5 * fluid_limits_stable_step(f).viscous;
            for (double t = 0; t * 0.5 < 2.8; t += dt) fluid_step(f, dt);
            check_below(off_parabola(f, stream, across, reverse ? -2 : 2), 1e-10);
            check_below(fluid_measures_of(f).divergence_max, 1e-11);
            double pressure[6];
            fluid_measures_mean_pressure(f, stream, pressure);
            check_close(pressure[0], reverse ? 1.5 : 6.5, 1e-9);
            fluid_free(f);
        }
}

/* Couette flow by a moving wall, and the same by a side whose conditions are given one by one, against a shear stress
 * given as a gradient on the other side. */
static void couette(void **state) {
    (void)state;
    for (int general = 0; general < 2; general++) {
        struct fluid_input in = channel(0, 1, 6);
        in.side[1][1] = (struct fluid_side){.type = FLUID_WALL, .velocity = {1.5, 0, 0.5}};
        if (general)
            in.side[1][1] =
                (struct fluid_side){.type = FLUID_GENERAL,
                                    .velocity = {1.5, 0, 0.5},
                                    .condition = {FLUID_NEUMANN, FLUID_DIRICHLET, FLUID_NEUMANN, FLUID_NEUMANN}};
        struct fluid *f = fluid_new(&in);
        const struct fluid_grid *g = fluid_grid_of(f);
        const double dt = 0.9 * fluid_limits_stable_step(f).viscous;
        for (double t = 0; t * 0.5 < (general ? 11 : 2.8); t += dt) fluid_step(f, dt);
        for (int k = 0; k < g->m[2]; k++)
            for (int j = 0; j < g->m[1]; j++) {
                const double y = (j + g->lo[1] + 0.5) * g->d[1];
                check_close(fluid_state_of(f)->u[fluid_grid_at(g, 1, j, k)], 1.5 * y, 1e-10);
                check_close(fluid_state_of(f)->w[fluid_grid_at(g, 1, j, k)], 0.5 * y, 1e-10);
            }
        fluid_free(f);
    }
}

/* Flow rate through a square duct of side 1 at G/mu = 1. */
static double duct(int stream, int cells) {
    struct fluid_input in = channel(stream, (stream + 1) % 3, cells);
    in.n[(stream + 2) % 3] = cells;
    in.length[(stream + 2) % 3] = 1;
    all_sides(&in, (stream + 2) % 3, FLUID_WALL);
    in.driving.type = FLUID_DRIVING_GRADIENT;
    in.driving.value = in.density * in.viscosity;
    in.initial_poiseuille = 1;
    in.initial_velocity[stream] = 0.035;
    struct fluid *f = fluid_new(&in);
    const double dt = 0.9 * fluid_limits_stable_step(f).viscous;
    for (double t = 0; t < 1.5; t += dt) fluid_step(f, dt);
    const double rate = bulk_velocity_along(f, stream);
    fluid_free(f);
    return rate;
}

/* The same from the discrete operator's sine modes: sum over odd k, l of e_k e_l / (lambda_k + lambda_l), with
 * lambda_k = (2n sin(pi k/2n))^2 and e_k = 2/(n sin(pi k/2n))^2, halved for k = n. */
static double duct_modes(int n) {
    double sum = 0;
    for (int k = 1; k <= n; k += 2)
        for (int l = 1; l <= n; l += 2) {
            const double sk = pow(n * sin(M_PI * k / (2 * n)), 2), sl = pow(n * sin(M_PI * l / (2 * n)), 2);
            sum += (k == n ? 1 : 2) / sk * (l == n ? 1 : 2) / sl / (4 * sk + 4 * sl);
        }
    return sum;
}

/* Exactly the discrete solution's flow rate, which comes near 0.0351442537 (series) with the square of the cell. */
static void square_duct(void **state) {
    (void)state;
    static const int cells[3] = {8, 15, 24};
    for (int stream = 0; stream < 3; stream++) {
        double error[3];
        for (int r = 0; r < (stream ? 2 : 3); r++) {
            const double rate = duct(stream, cells[r]);
            error[r] = rate / 0.0351442537 - 1;
            check_close(rate, duct_modes(cells[r]), 1e-7 * rate);
            if (r == 0) continue;
            const double order = log(error[r - 1] / error[r]) / log((double)cells[r] / cells[r - 1]);
            if (!(order > 1.95 && order < 2.05)) fail_msg("order %g (errors %g %g)", order, error[r - 1], error[r]);
        }
    }
}

/* The bulk velocity has its value after every step, from a start that is neither developed nor of that mean. */
static void bulk_velocity_is_held(void **state) {
    (void)state;
    struct fluid_input in = channel(2, 1, 8);
    in.driving = (struct fluid_driving){FLUID_DRIVING_BULK, 2, 0.8};
    in.initial_velocity[2] = 0.2;
    struct fluid *f = fluid_new(&in);
    const double dt = 0.9 * fluid_limits_stable_step(f).viscous;
    for (int i = 0; i * dt * 0.5 < 2.8; i++) {
        fluid_step(f, dt);
        if (i < 20) check_close(bulk_velocity_along(f, 2), 0.8, 1e-14);
    }
    const double dy = 1.0 / 8, gradient = 2 * 0.8 / (1.0 / 6 + dy * dy / 3);
    check_close(fluid_state_of(f)->driving, gradient, 1e-8 * gradient);
    check_below(off_parabola(f, 2, 1, gradient), 1e-9);
    fluid_free(f);
}

/* A gradient that depends on time: without walls its impulse is exact, whatever the step. */
static void oscillating_gradient(void **state) {
    (void)state;
    struct fluid_input in = channel(0, 1, 6);
    all_sides(&in, 1, FLUID_PERIODIC);
    in.driving = (struct fluid_driving){FLUID_DRIVING_GRADIENT, 0, 3};
    in.driving_frequency = 0.7;
    const double w = 2 * M_PI * in.driving_frequency, dt = 0.05;
    struct fluid *f = fluid_new(&in);
    for (int s = 1; s <= 20; s++) {
        fluid_step(f, dt);
        check_close(bulk_velocity_along(f, 0), 3 / in.density / w * sin(w * s * dt), 1e-14);
    }
    fluid_free(f);
}

FLUID_TEST_MAIN(cmocka_unit_test(poiseuille_by_gradient), cmocka_unit_test(start_up),
                cmocka_unit_test(oscillating_gradient), cmocka_unit_test(inflow_and_outflow),
                cmocka_unit_test(between_pressures), cmocka_unit_test(couette), cmocka_unit_test(square_duct),
                cmocka_unit_test(bulk_velocity_is_held))
