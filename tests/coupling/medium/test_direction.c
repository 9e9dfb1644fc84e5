/* Permeability along y, z and slanted directions: turned samples, an isotropic array, sides of given pressure. */
#include "coupling/interface/deposit.h"
#include "coupling/run.h"
#include "coupling/step.h"
#include "tests/check.h"
#include "tests/coupling/scene_of.h"

#include <math.h>
#include <stdio.h>

static const char *const head = "title: test\n"
                                "domain: {size: [1, 1, 1], cells: [%d, %d, %d]}\n"
                                "fluid:\n"
                                "  density: 1\n"
                                "  viscosity: 1\n"
                                "%s"
                                "  sides:\n"
                                "    x_low: {type: %s}\n    x_high: {type: %s}\n"
                                "    y_low: {type: %s}\n    y_high: {type: %s}\n"
                                "    z_low: {type: %s}\n    z_high: {type: %s}\n"
                                "solid:\n"
                                "  materials:\n    - {name: rigid, youngs_modulus: 1, density: 1, horizon_ratio: 2}\n"
                                "  bodies:\n"
                                "%s"
                                "coupling:\n  surface: %s\n  medium: {low: [0, 0, 0], high: [1, 1, 1]}\n";

struct sample {
    int cells;
    const char *surface, *driving, *bodies;
    int open;   /* 1, 2, 3: the sides along x, y, z have pressures of 1e-3 and 0; 0: all are periodic */
    double end; /* s */
};

/* What the medium measures at the end. */
static struct medium_values measure(struct sample s) {
    char text[2048], stages[256];
    const char *side[3][2];
    for (int d = 0; d < 3; d++) {
        side[d][0] = s.open == d + 1 ? "pressure, pressure: 1.0e-3" : "periodic";
        side[d][1] = s.open == d + 1 ? "pressure, pressure: 0" : "periodic";
    }
    const double step = 1.65 / (12.0 * s.cells * s.cells);
    snprintf(text, sizeof text, head, s.cells, s.cells, s.cells, s.driving, side[0][0], side[0][1], side[1][0],
             side[1][1], side[2][0], side[2][1], s.bodies, s.surface);
    snprintf(stages, sizeof stages, "stages: [{name: flow, steps: %d, time_step: %.10e, solid: rigid}]\n",
             (int)(s.end / step), step);
    struct scene *scene = scene_of(text, stages, 0, NULL);
    struct run *r = run_new(scene);
    step_begin_stage(r);
    while (r->stage_step < scene->stage[0].steps) step_advance(r);
    const struct medium_values value = deposit_measure(r);
    run_free(r);
    scene_free(scene);
    return value;
}

/* So small that a flow turned round is the same flow: inertia is below round-off. */
#define SMALL 1e-9

static const char *gradient(int d) {
    static char text[3][80];
    snprintf(text[d], sizeof text[d], "  driving: {type: pressure_gradient, direction: %c, value: %g}\n", "xyz"[d],
             SMALL);
    return text[d];
}

/* Two spheres, off all symmetries of grid and cell; turned: by 90 degrees about z, (x, y) -> (1 - y, x);
 * about x, (y, z) -> (1 - z, y). */
static void body(char text[512], int turn) {
    double x[2][3] = {{0.33, 0.41, 0.45}, {0.72, 0.77, 0.60}};
    const int a = turn == 1 ? 0 : 1, b = a + 1;
    for (int q = 0; q < 2 && turn; q++) {
        const double old = x[q][a];
        x[q][a] = 1 - x[q][b], x[q][b] = old;
    }
    snprintf(text, 512,
             "    - {name: a, material: rigid, shape: sphere, centre: [%g, %g, %g], radius: %g}\n"
             "    - {name: b, material: rigid, shape: sphere, centre: [%g, %g, %g], radius: 0.2}\n",
             x[0][0], x[0][1], x[0][2], 0.33, x[1][0], x[1][1], x[1][2]);
}

/* K with u = K G/mu, a column a direction. */
static void tensor(const char *bodies, double K[3][3]) {
    for (int j = 0; j < 3; j++) {
        const struct medium_values v = measure((struct sample){12, "shape", gradient(j), bodies, 0, 0.05});
        for (int i = 0; i < 3; i++) K[i][j] = v.mean_velocity[i] / SMALL;
        check_relative(v.permeability, K[j][j], 1e-12);
        check_above(v.permeability, 0);
        check_above(v.tortuosity, 1);
    }
}

/* The tensor of the turned sample is the turned tensor, R K R^T, to round-off. */
static void a_turned_sample(void **state) {
    (void)state;
    char text[512];
    double K[3][3], turned[3][3];
    body(text, 0);
    tensor(text, K);
    check_above(fabs(K[0][1]), 1e-3 * K[0][0]); /* it has parts off the diagonal */
    for (int turn = 1; turn <= 2; turn++) {
        const int a = turn == 1 ? 0 : 1, b = a + 1;
        int from[3] = {0, 1, 2}, sign[3] = {1, 1, 1}; /* new component c is sign times the old one `from` */
        from[a] = b, from[b] = a, sign[a] = -1;
        body(text, turn);
        tensor(text, turned);
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++)
                check_close(turned[i][j], sign[i] * sign[j] * K[from[i]][from[j]], 1e-10 * K[0][0]);
    }
}

/* A slit between plates along each axis, and spheres cut by sides of given pressure along each axis. */
static void each_axis_alike(void **state) {
    (void)state;
    char plates[3][256], halves[3][256];
    double slit[3], cut[3], tortuosity[3], connected[3];
    for (int d = 0; d < 3; d++) {
        double high[3] = {1, 1, 1}, centre[2][3] = {{0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}};
        high[(d + 1) % 3] = 0.25;
        centre[0][d] = 0, centre[1][d] = 1;
        snprintf(plates[d], sizeof plates[d],
                 "    - {name: a, material: rigid, shape: box, low: [0, 0, 0], high: [%g, %g, %g]}\n", high[0], high[1],
                 high[2]);
        snprintf(halves[d], sizeof halves[d],
                 "    - {name: a, material: rigid, shape: sphere, centre: [%g, %g, %g], radius: 0.4}\n"
                 "    - {name: b, material: rigid, shape: sphere, centre: [%g, %g, %g], radius: 0.4}\n",
                 centre[0][0], centre[0][1], centre[0][2], centre[1][0], centre[1][1], centre[1][2]);
        const struct medium_values a = measure((struct sample){12, "lattice", gradient(d), plates[d], 0, 0.4}),
                                   b = measure((struct sample){12, "shape", "", halves[d], d + 1, 0.05});
        slit[d] = a.permeability, cut[d] = b.permeability;
        tortuosity[d] = b.tortuosity, connected[d] = b.porosity_effective;
        check_relative(b.pressure_drop, 1e-3, 1e-12);
    }
    check_relative(slit[0], 0.75 * 0.75 * 0.75 / 12, 0.07);
    for (int d = 1; d < 3; d++) {
        check_relative(slit[d], slit[0], 1e-10);
        check_relative(cut[d], cut[0], 1e-10);
        check_relative(tortuosity[d], tortuosity[0], 1e-10);
        check_relative(connected[d], connected[0], 1e-12);
    }
}

/* The tensor of a simple cubic array is isotropic: along [110] and [111] its permeability is that along [100], but for
 * the grid's error. A gradient and a body force are the same, and so are they the other way round. */
static void slanted(void **state) {
    (void)state;
    const char *const sphere =
        "    - {name: a, material: rigid, shape: sphere, centre: [0.5078125, 0.51875, 0.5125], radius: 0.36278}\n";
    const double x = measure((struct sample){12, "shape", gradient(0), sphere, 0, 0.25}).permeability;
    check_relative(x, 0.0215816, 0.02); /* Zick and Homsy at c = 0.2 */
    const char *const drivings[] = {
        "  driving: {type: pressure_gradient, along: [1, 1, 0], value: 1.0e-3}\n",
        "  driving: {type: pressure_gradient, along: [2, 2, 2], value: 1.0e-3}\n",
        "  body_force: [7.071067811865475e-4, 7.071067811865475e-4, 0]\n",
        "  driving: {type: pressure_gradient, along: [-1, -1, 0], value: 1.0e-3}\n",
    };
    double k[4];
    for (int q = 0; q < 4; q++) {
        const struct medium_values v = measure((struct sample){12, "shape", drivings[q], sphere, 0, 0.25});
        k[q] = v.permeability;
        check_relative(k[q], x, 0.003);
        check_relative(fabs(v.velocity), k[q] * 1e-3, 1e-10); /* k = mu U/|G| */
        check_relative(v.reynolds, fabs(v.velocity) * sqrt(k[q]), 1e-12);
        check_above(v.tortuosity, 1);
        check_below(v.tortuosity, 1.1);
    }
    check_relative(k[2], k[0], 1e-10);
    check_relative(k[3], k[0], 1e-10);
}

/* What would be a number of round-off is not a number. */
static void nothing_along(void **state) {
    (void)state;
    const char *const wall = "    - {name: a, material: rigid, shape: box, low: [0.25, 0, 0], high: [0.5, 1, 1]}\n";
    const char *const sphere =
        "    - {name: a, material: rigid, shape: sphere, centre: [0.5, 0.5, 0.5], radius: 0.36278}\n";
    struct medium_values v = measure((struct sample){12, "lattice", gradient(0), wall, 0, 0.01});
    check_equal(v.porosity_effective, 0);
    assert_true(isnan(v.permeability) && isnan(v.reynolds));
    v = measure((struct sample){12, "shape", "", sphere, 0, 0.005});
    assert_true(isnan(v.permeability) && isnan(v.reynolds) && isnan(v.tortuosity));
    v = measure((struct sample){12, "shape", "  driving: {type: bulk_velocity, direction: z, value: 1.0e-3}\n", sphere,
                                0, 0.05});
    check_above(v.permeability, 0.01); /* along z, which nobody has named */
    check_relative(v.mean_velocity[2], 1e-3, 1e-10);
    v = measure((struct sample){12, "shape",
                                "  driving: {type: bulk_velocity, direction: z, value: 1.0e-3}\n"
                                "  body_force: [1.0e-3, 0, 0]\n",
                                sphere, 0, 0.05});
    assert_true(isnan(v.permeability)); /* along x as well */
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(a_turned_sample), cmocka_unit_test(each_axis_alike),
                                       cmocka_unit_test(slanted), cmocka_unit_test(nothing_along)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
