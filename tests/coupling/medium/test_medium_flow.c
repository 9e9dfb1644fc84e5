/* Pressure drop, permeability and tortuosity of flows with known solutions. */
#include "base/par.h"
#include "coupling/medium/medium.h"
#include "tests/check.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <cmocka.h>

enum { NX = 16, NY = 12, NZ = 12 };
static const double d = 0.01, density = 800, viscosity = 2e-3;

static struct fluid *channel(int periodic_x) {
    struct fluid_input in = {
        .n = {NX, NY, NZ}, .length = {NX * d, NY * d, NZ * d}, .density = density, .viscosity = viscosity};
    in.side[1][0].type = in.side[1][1].type = FLUID_WALL;
    if (!periodic_x) {
        in.side[0][0] = (struct fluid_side){.type = FLUID_INFLOW, .profile = FLUID_POISEUILLE, .bulk_velocity = 0.1};
        in.side[0][1].type = FLUID_OUTFLOW;
    } else {
        in.driving = (struct fluid_driving){.type = FLUID_DRIVING_GRADIENT, .direction = 0, .value = 3.0};
        in.initial_velocity[0] = 3.0 * (NY * d) * (NY * d) / (12 * density * viscosity);
        in.initial_poiseuille = 1;
    }
    return fluid_new(&in);
}

static struct medium *medium_between(struct fluid *f, double low, double high) {
    const double box_low[3] = {low, 0, 0}, box_high[3] = {high, NY * d, NZ * d};
    return medium_new(fluid_grid_of(f), box_low, box_high);
}

/* Sets u (cell by cell in y), v, w and p (section by section in x) in this rank's cells and all ghosts. */
static void flow_set(struct fluid *f, const double *u_of_y, double v, double w, const double *p_of_x) {
    const struct fluid_grid *g = fluid_grid_of(f);
    struct fluid_state *q = fluid_state_of(f);
    for (int k = -g->halo; k < g->m[2] + g->halo; k++)
        for (int j = -g->halo; j < g->m[1] + g->halo; j++)
            for (int i = -g->halo; i < g->m[0] + g->halo; i++) {
                const size_t a = fluid_grid_at(g, i, j, k);
                const int gj = g->lo[1] + j, gi = g->lo[0] + i;
                q->u[a] = gj >= 0 && gj < NY ? u_of_y[gj] : 0;
                q->v[a] = v;
                q->w[a] = w;
                q->p[a] = gi >= 0 && gi < NX ? p_of_x[gi] : 0;
            }
}

/* Mean of the parabola (y - low)(high - y)/2 over cell j, times `factor`; 0 outside of [low, high]. */
static double parabola_mean(int j, double low, double high, double factor) {
    const double a = j * d, b = (j + 1) * d;
    if (a < low - 1e-9 || b > high + 1e-9) return 0;
    const double s = a - low, t = b - low, h = high - low;
    return factor * 0.5 * (h * (t * t - s * s) / 2 - (t * t * t - s * s * s) / 3) / d;
}

/* A slit that fills the box: k = h^2/12, tortuosity exactly 1. */
static void test_slit_fills_box(void **state) {
    (void)state;
    struct fluid *f = channel(0);
    struct medium *m = medium_between(f, 4.3 * d, 11 * d);
    const double G = 37, h = NY * d;
    double u[NY], p[NX];
    for (int j = 0; j < NY; j++) u[j] = parabola_mean(j, 0, h, G / (density * viscosity));
    for (int i = 0; i < NX; i++) p[i] = 5 - G * (i + 0.5) * d;
    flow_set(f, u, 0, 0, p);
    const struct medium_values value = medium_measure(m, f, 0.006);
    check_equal(value.porosity, 1);
    check_relative(value.porosity_effective, 1, 1e-14);
    check_relative(value.pressure_drop, G * 6.7 * d, 1e-12);
    check_relative(value.permeability, h * h / 12, 1e-12);
    check_relative(value.velocity, G * h * h / 12 / (density * viscosity), 1e-12);
    check_equal(value.tortuosity, 1);
    check_relative(value.specific_surface, 0.006 / (6.7 * d * NY * d * NZ * d), 1e-14);
    /* a value computed alone is the same */
    check_equal(medium_measure_pressure_drop(m, f), value.pressure_drop);
    check_equal(medium_measure_porosity(m), value.porosity);
    medium_free(m);
    fluid_free(f);
}

/* A slit between solid plates within the box: k = porosity h^2/12. */
static void test_slit_between_plates(void **state) {
    (void)state;
    struct fluid *f = channel(0);
    struct medium *m = medium_between(f, 4 * d, 12 * d);
    const double G = 37, h = 7 * d;
    double x[3][8 * NY * NZ], volume[8 * NY * NZ], u[NY], p[NX];
    int n = 0;
    if (par_rank() == par_size() - 1)
        for (int k = 0; k < NZ; k++)
            for (int j = 0; j < NY; j++)
                for (int i = 4; i < 12; i++) {
                    if (j >= 3 && j < 10) continue;
                    x[0][n] = (i + 0.5) * d, x[1][n] = (j + 0.5) * d, x[2][n] = (k + 0.5) * d;
                    volume[n++] = d * d * d;
                }
    const double *const position[3] = {x[0], x[1], x[2]};
    medium_deposit(m, n, position, volume);
    for (int j = 0; j < NY; j++) u[j] = parabola_mean(j, 3 * d, 10 * d, G / (density * viscosity));
    for (int i = 0; i < NX; i++) p[i] = -G * (i + 0.5) * d;
    flow_set(f, u, 0, 0, p);
    const struct medium_values value = medium_measure(m, f, 0);
    check_relative(value.porosity, 7.0 / 12, 1e-12);
    check_relative(value.porosity_effective, 7.0 / 12, 1e-12);
    check_relative(value.permeability, 7.0 / 12 * h * h / 12, 1e-12);
    check_equal(value.tortuosity, 1);
    medium_free(m);
    fluid_free(f);
}

/* The steady flow of the solver under a pressure gradient: on n cells h^2/12 (1 + 2/n^2), exactly. It starts from the
 * continuous parabola, 1.4 % slower; the slowest mode has decayed by 1e-7 at the end. */
static void test_poiseuille_by_the_fluid(void **state) {
    (void)state;
    struct fluid *f = channel(1);
    struct medium *m = medium_between(f, 4 * d, 11 * d);
    const double dt = 0.8 * fluid_limits_stable_step(f).viscous, h = NY * d;
    for (int step = 0; step < 2200; step++)
        for (int r = 0; r < 3; r++) {
            fluid_predict(f, r, dt);
            fluid_project(f, r, dt);
        }
    const struct medium_values value = medium_measure(m, f, 0);
    check_relative(value.pressure_drop, 3.0 * 7 * d, 1e-10);
    check_relative(value.permeability, h * h / 12 * (1 + 2.0 / (NY * NY)), 1e-8);
    check_relative(value.tortuosity, 1, 1e-12);
    medium_free(m);
    /* a box that is the whole period: only the driving counts */
    m = medium_between(f, 0, NX * d);
    check_relative(medium_measure_pressure_drop(m, f), 3.0 * NX * d, 1e-14);
    check_relative(medium_measure(m, f, 0).permeability, h * h / 12 * (1 + 2.0 / (NY * NY)), 1e-8);
    double u[NY] = {0}, p[NX];
    for (int i = 0; i < NX; i++) p[i] = i * i;
    flow_set(f, u, 0, 0, p);
    check_relative(medium_measure_pressure_drop(m, f), 3.0 * NX * d, 1e-14);
    medium_free(m);
    fluid_free(f);
}

/* Only sections wholly outside the box count; pressures inside have no effect. */
static void test_pressure_outside_only(void **state) {
    (void)state;
    struct fluid *f = channel(0);
    double u[NY], p[NX];
    for (int j = 0; j < NY; j++) u[j] = 1;
    for (int i = 0; i < NX; i++) {
        const double x = (i + 0.5) * d;
        p[i] = i < 4 ? 100 - 50 * x : i >= 11 ? 20 - 300 * x : 1e6;
    }
    flow_set(f, u, 0, 0, p);
    const double low[2] = {4 * d, 4.6 * d}, high[2] = {11 * d, 10.2 * d};
    for (int b = 0; b < 2; b++) {
        struct medium *m = medium_between(f, low[b], high[b]);
        check_relative(medium_measure_pressure_drop(m, f), 100 - 50 * low[b] - (20 - 300 * high[b]), 1e-12);
        medium_free(m);
    }
    /* no section before the box: the domain's first two */
    for (int i = 0; i < NX; i++) p[i] = 7 - 2 * (i + 0.5) * d;
    flow_set(f, u, 0, 0, p);
    struct medium *m = medium_between(f, 0, NX * d);
    check_relative(medium_measure_pressure_drop(m, f), 2 * NX * d, 1e-12);
    medium_free(m);
    fluid_free(f);
}

/* A fluid between the given sides along x, open across; the driving along x is G = 30 Pa/m. */
static const double G = 30;
static struct fluid *between(struct fluid_side low, struct fluid_side high) {
    struct fluid_input in = {.n = {NX, NY, NZ},
                             .length = {NX * d, NY * d, NZ * d},
                             .density = density,
                             .viscosity = viscosity,
                             .side = {{low, high}},
                             .body_force = {G / density, 0, 0}};
    return fluid_new(&in);
}

/* The drop over a box from low to high, both in cells, with p section by section. */
static double drop_with(struct fluid *f, double low, double high, double reach, const double *p) {
    const double u[NY] = {0};
    struct medium *m = medium_between(f, low * d, high * d);
    medium_reach(m, reach);
    flow_set(f, u, 0, 0, p);
    const double drop = medium_measure_pressure_drop(m, f);
    medium_free(m);
    return drop;
}

/* A face on a side of given pressure, or less than a cell from it; with one section and with two between them; a side
 * that gives none. */
static void test_sides_of_given_pressure(void **state) {
    (void)state;
    const struct fluid_side open = {.type = FLUID_PRESSURE, .pressure = 7},
                            outlet = {.type = FLUID_PRESSURE, .pressure = 2};
    struct fluid *f = between(open, outlet);
    double p[NX];
    for (int i = 0; i < NX; i++) p[i] = 1e6;
    check_relative(drop_with(f, 0, NX, 1, p), 5 + G * NX * d, 1e-14);
    /* between face and side only the driving acts */
    check_relative(drop_with(f, 0.4, NX - 0.7, 1, p), 5 + G * NX * d, 1e-14);
    /* the line through the side and the one section */
    p[0] = 6, p[NX - 1] = 2.5;
    check_relative(drop_with(f, 1.2, NX - 1, 1, p), 7 - 1.2 * 2 - (2 + 1) + G * (NX - 2.2) * d, 1e-14);
    /* the force reaches that section: the side alone */
    check_relative(drop_with(f, 1.1, NX - 1, 1.3, p), 5 + G * NX * d, 1e-14);
    /* the line through the two nearest sections, not the side */
    p[0] = 100, p[1] = 6, p[2] = 5, p[NX - 1] = 3, p[NX - 2] = 4, p[NX - 3] = 1e6;
    check_relative(drop_with(f, 3, NX - 2.4, 1, p), 4.5 - 4.9 + G * (NX - 5.4) * d, 1e-14);
    fluid_free(f);

    struct fluid_side in = {.type = FLUID_INFLOW, .bulk_velocity = 0.1}, out = {.type = FLUID_OUTFLOW};
    f = between(in, out);
    for (int i = 0; i < NX; i++) p[i] = 1e6;
    p[0] = 6, p[NX - 1] = 3;
    check_relative(drop_with(f, 1, NX - 1.5, 1, p), 3 + G * (NX - 1) * d, 1e-14); /* one section: with the driving */
    check_relative(drop_with(f, 1, NX - 1, 1.4, p), 3 + G * (NX - 1) * d, 1e-14); /* at whatever reach */
    fluid_free(f);
}

/* Sections that the force on the fluid reaches do not count. */
static void test_reach_of_the_force(void **state) {
    (void)state;
    struct fluid *f = between((struct fluid_side){.type = FLUID_PRESSURE}, (struct fluid_side){.type = FLUID_PRESSURE});
    double p[NX];
    for (int i = 0; i < NX; i++) p[i] = i < 4 ? 100 - 5 * (i + 0.5) : i >= 12 ? 20 - 3 * (i + 0.5) : 1e6 * i;
    const double expected = 100 - 5 * 5 - (20 - 3 * 11) + G * 6 * d;
    check_relative(drop_with(f, 5, 11, 2, p), expected, 1e-12);
    check_relative(drop_with(f, 5, 11, 1.2, p), expected, 1e-12);
    check_above(fabs(drop_with(f, 5, 11, 1, p)), 1e5);
    check_relative(drop_with(f, 5.1, 10.9, 1.2, p), 100 - 5 * 5.1 - (20 - 3 * 10.9) + G * 5.8 * d, 1e-12);
    fluid_free(f);
}

/* Beyond a periodic end the sections repeat. */
static void test_box_at_a_periodic_end(void **state) {
    (void)state;
    struct fluid *f = between((struct fluid_side){0}, (struct fluid_side){0});
    double p[NX];
    for (int i = 0; i < NX; i++) p[i] = i < 8 ? 1e6 : 4 - 2 * (i - 12);
    const double front = 4 - 2 * (16 - 12.5), back = 4 - 2 * (8 - 12.5);
    check_relative(drop_with(f, 0, 8, 1, p), front - back + G * 8 * d, 1e-12);
    for (int i = 0; i < NX; i++) p[i] = i > 0 && i < 9 ? 1e6 : 4 - 2 * (i == 0 ? 4 : i - 12);
    check_relative(drop_with(f, 1, 9, 1, p), 4 - 2 * 4.5 - (4 - 2 * (9 - 12.5)) + G * 8 * d, 1e-12);
    /* one section, or less, is left of the period: all of the driving is over the box */
    for (int i = 0; i < NX; i++) p[i] = 1e3 * i;
    check_relative(drop_with(f, 1, NX, 1, p), G * NX * d, 1e-12);
    check_relative(drop_with(f, 0.3, NX - 0.2, 1, p), G * NX * d, 1e-12);
    fluid_free(f);
}

/* Oblique flow: sqrt(2); and only pore cells count. */
static void test_tortuosity(void **state) {
    (void)state;
    struct fluid *f = channel(0);
    struct medium *m = medium_between(f, 4 * d, 12 * d);
    double u[NY], p[NX] = {0};
    for (int j = 0; j < NY; j++) u[j] = 1;
    flow_set(f, u, 1, 0, p);
    check_relative(medium_measure(m, f, 0).tortuosity, sqrt(2), 1e-14);
    flow_set(f, u, 2, 2, p);
    check_relative(medium_measure(m, f, 0).tortuosity, 3, 1e-14);
    /* the lower half flows twice as fast, and then is solid (but for a layer of less than half) */
    for (int j = 0; j < NY; j++) u[j] = j < 6 ? 2 : 1;
    flow_set(f, u, 2, 0, p);
    check_relative(medium_measure(m, f, 0).tortuosity, (sqrt(8) + sqrt(5)) / 3, 1e-14);
    double x[3][8 * NY * NZ], volume[8 * NY * NZ];
    int n = 0;
    if (par_rank() == 0)
        for (int k = 0; k < NZ; k++)
            for (int j = 0; j < 7; j++)
                for (int i = 4; i < 12; i++) {
                    x[0][n] = (i + 0.5) * d, x[1][n] = (j + 0.5) * d, x[2][n] = (k + 0.5) * d;
                    volume[n++] = (j < 6 ? 0.9 : 0.1) * d * d * d;
                }
    const double *const position[3] = {x[0], x[1], x[2]};
    medium_deposit(m, n, position, volume);
    check_relative(medium_measure(m, f, 0).tortuosity, sqrt(5), 1e-14);
    medium_free(m);
    fluid_free(f);
}

/* Undefined values are NaN. */
static void test_at_rest(void **state) {
    (void)state;
    struct fluid *f = channel(0);
    struct medium *m = medium_between(f, 4 * d, 12 * d);
    const double u[NY] = {0}, p[NX] = {0};
    flow_set(f, u, 0, 0, p);
    const struct medium_values value = medium_measure(m, f, 0);
    check_equal(value.pressure_drop, 0);
    check_equal(value.velocity, 0);
    assert_true(isnan(value.permeability) && isnan(value.tortuosity));
    medium_free(m);
    fluid_free(f);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_slit_fills_box),
        cmocka_unit_test(test_slit_between_plates),
        cmocka_unit_test(test_poiseuille_by_the_fluid),
        cmocka_unit_test(test_pressure_outside_only),
        cmocka_unit_test(test_sides_of_given_pressure),
        cmocka_unit_test(test_reach_of_the_force),
        cmocka_unit_test(test_box_at_a_periodic_end),
        cmocka_unit_test(test_tortuosity),
        cmocka_unit_test(test_at_rest),
    };
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
